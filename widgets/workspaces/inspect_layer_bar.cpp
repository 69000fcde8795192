// SPDX-License-Identifier: MIT
#include "widgets/workspaces/inspect_layer_bar.h"

#include <cmath>
#include <numbers>

#include <QHBoxLayout>
#include <QLocale>
#include <QPainter>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"

namespace widgets {

namespace {

constexpr int kScaleWidth = 60, kScaleHeight = 8;
constexpr int kDegreesPerStep = 15;

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
    m_probe->setText(tr("Point at a view to see what each method would match there; click to pin it."));
}

void InspectLayerBar::showProbe(const std::optional<InspectProbe>& probe) {
    if (!probe) {
        clearProbe();
        return;
    }
    QStringList parts{
        tr("(%1, %2), direction %3\u00b0")
            .arg(number(probe->px.x(), 1), number(probe->px.y(), 1), number(degrees(probe->angleRad), 0))};
    for (const ProbeRow& row : probe->rows) {
        const QString text = row.found() ? tr("%1 px").arg(number(row.probe.cost, 1)) : tr("none");
        parts << QStringLiteral("%1 %2").arg(QString::fromStdString(row.method),
                                             row.found() && !row.kept() ? tr("%1, refused").arg(text) : text);
    }
    m_probe->setText(parts.join(QStringLiteral("  \u00b7  ")));
}

} // namespace widgets
