// SPDX-License-Identifier: MIT
#include "widgets/workspaces/inspect_layer_bar.h"

#include <array>
#include <cmath>
#include <numbers>

#include <QHBoxLayout>
#include <QLocale>
#include <QPainter>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/fitting/method_name.h"
#include "widgets/panels/state_colours.h"

namespace widgets {

namespace {

constexpr int kScaleWidth = 60, kScaleHeight = 8;
constexpr int kDegreesPerStep = 15;
constexpr std::array kCompared{"ch", "dch-thres", "dch-quant", "dch-dt3"};

double degrees(double rad) {
    return rad * 180 / std::numbers::pi;
}

QString number(double value, int decimals) {
    return QLocale().toString(value, 'f', decimals);
}

/// The colour scale as a picture in rich text.
QPixmap scalePicture() {
    QPixmap picture(kScaleWidth, kScaleHeight);
    QPainter painter(&picture);
    for (int x = 0; x < kScaleWidth; ++x)
        painter.fillRect(x, 0, 1, kScaleHeight, scaleColour(double(x) / (kScaleWidth - 1)));
    return picture;
}

} // namespace

InspectLayerBar::InspectLayerBar(InspectOverlays& overlays, QWidget* parent)
    : QWidget(parent)
    , m_overlays(overlays)
    , m_scale(new QLabel(this))
    , m_legend(new QLabel(this))
    , m_direction(new QSlider(Qt::Horizontal, this))
    , m_directionText(new QLabel(this))
    , m_probe(new QLabel(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpacing, 0, kSpacing, kSpacing / 2);
    column->setSpacing(kSpacing / 2);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpacing / 2);
    column->addLayout(row);
    for (const InspectLayer layer : kInspectLayers) {
        addBox(layer);
        row->addWidget(m_boxes.at(layer));
    }
    m_scale->setPixmap(scalePicture());
    m_legend->setMinimumWidth(1);
    m_direction->setRange(0, 360 / kDegreesPerStep - 1);
    m_direction->setFixedWidth(2 * kScaleWidth);
    m_direction->setFocusPolicy(Qt::NoFocus);
    m_direction->setToolTip(tr("Direction of the rim point whose field is shown"));
    row->addSpacing(kSpacing);
    row->addWidget(m_direction);
    row->addWidget(m_directionText);
    row->addWidget(m_scale);
    row->addWidget(m_legend);
    row->addStretch(1);
    m_probe->setTextFormat(Qt::PlainText);
    m_probe->setMinimumWidth(1); // long texts must not widen the window
    column->addWidget(m_probe);
    connect(&overlays, &InspectOverlays::shownChanged, this, &InspectLayerBar::showState);
    connect(m_direction, &QSlider::valueChanged, this,
            [this](int step) { m_overlays.setFieldAngleRad(step * kDegreesPerStep * std::numbers::pi / 180); });
    clearProbe();
    showState();
}

void InspectLayerBar::setLayerTexts(InspectLayer layer, const QString& text, const QString& tip) {
    m_boxes.at(layer)->setText(text);
    m_boxes.at(layer)->setToolTip(tip);
}

void InspectLayerBar::addBox(InspectLayer layer) {
    auto* box = new QCheckBox(inspectLayerId(layer), this);
    box->setFocusPolicy(Qt::NoFocus);
    connect(box, &QCheckBox::toggled, this, [this, layer](bool on) { m_overlays.setShown(layer, on); });
    m_boxes[layer] = box;
}

void InspectLayerBar::showState() {
    for (const auto& [layer, box] : m_boxes) {
        const QSignalBlocker blocker(box);
        box->setChecked(m_overlays.isShown(layer));
    }
    const bool hasField = m_overlays.isShown(InspectLayer::Field);
    m_direction->setVisible(hasField);
    m_directionText->setVisible(hasField);
    const int direction = static_cast<int>(std::lround(degrees(m_overlays.fieldAngleRad())));
    const QSignalBlocker blocker(m_direction);
    m_direction->setValue(direction / kDegreesPerStep);
    m_directionText->setText(tr("%1\u00b0").arg(direction));
    showLegend();
}

void InspectLayerBar::showLegend() {
    QStringList parts;
    if (m_overlays.isShown(InspectLayer::Matches))
        parts << tr("matches 0\u2013%1 px").arg(kResidualScalePx);
    if (m_overlays.isShown(InspectLayer::Field))
        parts << tr("field 0\u2013%1 px").arg(kFieldScalePx);
    if (m_overlays.isShown(InspectLayer::Error))
        parts << tr("error 0\u2013%1 mm").arg(kErrorScaleMm);
    const bool hasScale = !parts.isEmpty();
    if (m_overlays.isShown(InspectLayer::Uncertainty))
        parts << tr("95 % regions");
    m_scale->setVisible(hasScale);
    m_legend->setVisible(!parts.isEmpty());
    m_legend->setText(parts.join(QStringLiteral(", ")));
}

void InspectLayerBar::clearProbe() {
    m_probe->setText(tr("Point at a view to see what each method would match there."));
}

void InspectLayerBar::showProbe(const std::string& method, const ShownMatches& shown, QPointF px) {
    const std::optional<float> angle = rimAngleAt(shown, px);
    if (!shown.target || !angle) {
        clearProbe();
        return;
    }
    const Eigen::Vector2f p(static_cast<float>(px.x()), static_cast<float>(px.y()));
    QStringList parts{tr("(%1, %2), direction %3\u00b0")
                          .arg(number(px.x(), 1), number(px.y(), 1), number(degrees(static_cast<double>(*angle)), 0))};
    std::vector<std::string> names{method};
    for (const char* const name : kCompared)
        if (name != method)
            names.emplace_back(name);
    for (const std::string& name : names) {
        const core::MatchRule rule = core::matchRule(core::parseMethod(name));
        const core::ContourProbe probe =
            name == method ? core::probeContour(*shown.target, rule, p, *angle)
                           : core::probeContour(core::targetForRule(*shown.target, rule), rule, p, *angle);
        const QString text = probe.contourPoint < 0 ? tr("none") : tr("%1 px").arg(number(probe.cost, 1));
        const bool isRefused = probe.contourPoint >= 0 && probe.verdict != core::MatchVerdict::Kept;
        parts << QStringLiteral("%1 %2").arg(QString::fromStdString(name),
                                             isRefused ? tr("%1, refused").arg(text) : text);
    }
    m_probe->setText(parts.join(QStringLiteral("  \u00b7  ")));
}

} // namespace widgets
