// SPDX-License-Identifier: MIT
#include "widgets/workspaces/inspect_layer_bar.h"

#include <cmath>
#include <numbers>

#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/presenters/inspect/inspect_difference.h"
#include "widgets/text/edit_text.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

constexpr int kDirectionWidth = 120;
constexpr int kScaleSteps = 60;
constexpr int kDegreesPerStep = 15;

double degrees(double rad) {
    return rad * 180 / std::numbers::pi;
}

QString number(double value, int decimals) {
    return QLocale().toString(value, 'f', decimals);
}

/// The scale that distances, fields and errors share.
std::vector<QColor> sharedScale() {
    std::vector<QColor> colours;
    for (int step = 0; step < kScaleSteps; ++step)
        colours.push_back(scaleColour(double(step) / (kScaleSteps - 1)));
    return colours;
}

std::vector<QColor> directionScale() {
    std::vector<QColor> colours;
    for (int step = 0; step < kScaleSteps; ++step)
        colours.push_back(directionColour(2 * std::numbers::pi * step / kScaleSteps));
    return colours;
}

LegendEntry scaleEntry(const QString& text) {
    return {LegendEntry::Sample::Scale, text, {}, Qt::SolidLine, sharedScale()};
}

void addFingers(MatchChoice choice, std::vector<LegendEntry>& entries) {
    for (const HandPart part :
         {HandPart::Thumb, HandPart::Index, HandPart::Middle, HandPart::Ring, HandPart::Little, HandPart::Palm})
        if (choice == MatchChoice::ByFinger)
            entries.push_back({LegendEntry::Sample::Line, handPartText(part), handPartColour(part)});
}

void addRefusals(const std::set<core::MatchVerdict>& refusals, std::vector<LegendEntry>& entries) {
    for (const core::MatchVerdict verdict : kRefusals) {
        if (refusals.count(verdict) == 0)
            continue;
        const RefusalLook look = refusalLook(verdict);
        const bool hasLines = verdict != core::MatchVerdict::EmptyBin;
        entries.push_back({hasLines ? LegendEntry::Sample::Line : LegendEntry::Sample::Dot,
                           InspectLayerBar::tr("refused: %1").arg(verdictInWords(verdict)), look.colour, look.line});
    }
}

} // namespace

InspectLayerBar::InspectLayerBar(InspectOverlays& overlays, QWidget* parent)
    : QWidget(parent)
    , m_overlays(overlays)
    , m_matches(new QComboBox(this))
    , m_legend(new LegendStrip(this))
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
    m_direction->setRange(0, 360 / kDegreesPerStep - 1);
    m_direction->setFixedWidth(kDirectionWidth);
    m_direction->setFocusPolicy(Qt::NoFocus);
    m_direction->setToolTip(tr("Direction of the rim point whose field is shown"));
    makeMatchChoice();
    m_legend->keepPlace();
    row->addStrut(m_matches->sizeHint().height()); // the views below stay where they are, whatever appears here
    row->addSpacing(kSpacing);
    row->addWidget(m_matches);
    row->addWidget(m_direction);
    row->addWidget(m_directionText);
    row->addStretch(1);
    m_probe->setTextFormat(Qt::PlainText);
    m_probe->setMinimumWidth(1); // long texts must not widen the window
    column->addWidget(m_probe);
    column->addWidget(m_legend);
    connect(&overlays, &InspectOverlays::shownChanged, this, &InspectLayerBar::showState);
    connect(&overlays, &InspectOverlays::drawn, this, &InspectLayerBar::showLegend);
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

void InspectLayerBar::makeMatchChoice() {
    for (const MatchChoice choice : kMatchChoices)
        m_matches->addItem(matchChoiceText(choice));
    m_matches->setFocusPolicy(Qt::NoFocus);
    m_matches->setAccessibleName(tr("Rim points and matches that are drawn"));
    connect(m_matches, qOverload<int>(&QComboBox::activated), this,
            [this](int index) { m_overlays.setMatchChoice(kMatchChoices[static_cast<std::size_t>(index)]); });
}

void InspectLayerBar::showState() {
    for (const auto& [layer, box] : m_boxes) {
        const QSignalBlocker blocker(box);
        box->setChecked(m_overlays.isShown(layer));
    }
    m_matches->setVisible(m_overlays.isShown(InspectLayer::Matches) || m_overlays.isShown(InspectLayer::Rim));
    m_matches->setCurrentIndex(static_cast<int>(m_overlays.matchChoice()));
    const bool hasField = m_overlays.isShown(InspectLayer::Field);
    m_direction->setVisible(hasField);
    m_directionText->setVisible(hasField);
    const int direction = static_cast<int>(std::lround(degrees(m_overlays.fieldAngleRad())));
    const QSignalBlocker blocker(m_direction);
    m_direction->setValue(direction / kDegreesPerStep);
    m_directionText->setText(tr("direction %1\u00b0").arg(direction));
    showLegend();
}

void InspectLayerBar::setSilhouetteShown(bool shown, bool isNoisy) {
    m_silhouetteShown = shown;
    m_isNoisy = isNoisy;
    showLegend();
}

void InspectLayerBar::showLegend() {
    using Sample = LegendEntry::Sample;
    const MatchChoice matches = m_overlays.matchChoice();
    std::vector<LegendEntry> entries;
    if (m_silhouetteShown)
        entries.push_back({Sample::Line, m_isNoisy ? tr("observed silhouette, with noise") : tr("observed silhouette"),
                           methodColour("recorded")});
    if (m_overlays.isShown(InspectLayer::Contour))
        entries.push_back({Sample::Scale, tr("outline, by direction"), {}, Qt::SolidLine, directionScale()});
    if (m_overlays.isShown(InspectLayer::Rim) && matches != MatchChoice::ByFinger)
        entries.push_back({Sample::Dot, tr("rim, with normals"), Qt::white});
    if (m_overlays.isShown(InspectLayer::Matches) && matches != MatchChoice::ByFinger)
        entries.push_back(scaleEntry(tr("matches 0\u2013%1+ px").arg(kResidualScalePx)));
    if (m_overlays.isShown(InspectLayer::Matches) || m_overlays.isShown(InspectLayer::Rim))
        addFingers(matches, entries);
    addRefusals(m_overlays.refusals(), entries);
    if (m_overlays.isShown(InspectLayer::Difference)) {
        entries.push_back({Sample::Box, tr("missed: seen, not covered"), missedColour()});
        entries.push_back({Sample::Box, tr("extra: covered, not seen"), extraColour()});
        if (m_overlays.isWithoutForearm())
            entries.push_back({Sample::Hatch, tr("forearm: left out, as the fit does"), leftOutColour()});
    }
    if (m_overlays.isShown(InspectLayer::Field))
        entries.push_back(scaleEntry(tr("field 0\u2013%1+ px; clear: no match").arg(kFieldScalePx)));
    const auto& outcome = m_overlays.scene().outcome;
    if (m_overlays.isShown(InspectLayer::Error) && outcome && outcome->truePoses.empty())
        entries.push_back({Sample::Box, tr("error: there is no recorded pose"),
                           palette().color(QPalette::Disabled, QPalette::WindowText)});
    else if (m_overlays.isShown(InspectLayer::Error))
        entries.push_back(scaleEntry(tr("error 0\u2013%1+ mm").arg(kErrorScaleMm)));
    if (m_overlays.isShown(InspectLayer::Uncertainty))
        entries.push_back({Sample::Line, tr("95 % regions"), handPartColour(HandPart::Palm)});
    m_legend->setEntries(entries);
}

void InspectLayerBar::clearProbe() {
    m_probe->setText(tr("Point at a view to see what each method would match there; click to pin it."));
}

void InspectLayerBar::showProbe(const std::optional<InspectProbe>& probe) {
    if (!probe) {
        clearProbe();
        return;
    }
    QStringList parts;
    if (probe->rim)
        parts << jointText(*probe->rim);
    parts << tr("(%1, %2), direction %3\u00b0")
                 .arg(number(probe->px.x(), 1), number(probe->px.y(), 1), number(degrees(probe->angleRad), 0));
    for (const ProbeRow& row : probe->rows) {
        const QString text = row.found() ? tr("%1 px").arg(number(row.probe.distancePx, 1)) : tr("none");
        parts << QStringLiteral("%1 %2").arg(QString::fromStdString(row.method),
                                             row.found() && !row.kept() ? tr("%1, refused").arg(text) : text);
    }
    m_probe->setText(parts.join(QStringLiteral("  \u00b7  ")));
}

} // namespace widgets
