// SPDX-License-Identifier: MIT
#include "widgets/views/legend_strip.h"

#include <algorithm>
#include <cstdlib>

#include <QPainter>

namespace widgets {

namespace {

constexpr int kGap = 14, kSampleGap = 5, kPadding = 2;
constexpr int kWide = 1200;          ///< windows this wide are high enough to spare a line
const QColor kInk(0x20, 0x22, 0x25); ///< on paper
constexpr int kLineWidth = 30, kScaleWidth = 60, kBoxWidth = 12, kDotWidth = 6;

int sampleWidth(LegendEntry::Sample sample) {
    switch (sample) {
    case LegendEntry::Sample::Line:
        return kLineWidth;
    case LegendEntry::Sample::Scale:
        return kScaleWidth;
    case LegendEntry::Sample::Dot:
        return kDotWidth;
    case LegendEntry::Sample::Box:
    case LegendEntry::Sample::Hatch:
        break;
    }
    return kBoxWidth;
}

/// A dark edge lets pale samples stand on a pale ground.
QColor edgeColour(const QPalette& palette) {
    QColor edge = palette.color(QPalette::WindowText);
    edge.setAlphaF(0.45);
    return edge;
}

/// Hardly told from the ground.
bool isPale(const QColor& colour, const QPalette& palette) {
    constexpr int kLeast = 60;
    return std::abs(qGray(colour.rgb()) - qGray(palette.color(QPalette::Window).rgb())) < kLeast;
}

void paintScale(QPainter& painter, const QRect& place, const std::vector<QColor>& scale) {
    for (int x = 0; x < place.width() && !scale.empty(); ++x) {
        const auto step = static_cast<std::size_t>(x) * scale.size() / static_cast<std::size_t>(place.width());
        painter.fillRect(place.left() + x, place.top(), 1, place.height(), scale[step]);
    }
}

void paintHatch(QPainter& painter, const QRect& place, const QColor& colour) {
    painter.save();
    painter.setClipRect(place);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1.6));
    for (int x = place.left() - place.height(); x < place.right(); x += 5)
        painter.drawLine(x, place.bottom() + 1, x + place.height(), place.top());
    painter.restore();
}

void paintSample(QPainter& painter, const QRect& place, const LegendEntry& entry, const QPalette& palette) {
    const QRect box(place.left(), place.center().y() - 4, place.width(), 9);
    switch (entry.sample) {
    case LegendEntry::Sample::Line:
        if (isPale(entry.colour, palette)) {
            painter.setPen(QPen(edgeColour(palette), 4, entry.line, Qt::FlatCap));
            painter.drawLine(box.left(), box.center().y(), box.right(), box.center().y());
        }
        painter.setPen(QPen(entry.colour, 2, entry.line));
        painter.drawLine(box.left(), box.center().y(), box.right(), box.center().y());
        return;
    case LegendEntry::Sample::Dot:
        if (isPale(entry.colour, palette))
            painter.fillRect(QRect(box.left() - 1, box.center().y() - 3, 7, 7), edgeColour(palette));
        painter.fillRect(QRect(box.left(), box.center().y() - 2, 5, 5), entry.colour);
        return;
    case LegendEntry::Sample::Box:
        painter.fillRect(box, entry.colour);
        break;
    case LegendEntry::Sample::Hatch:
        paintHatch(painter, box, entry.colour);
        break;
    case LegendEntry::Sample::Scale:
        paintScale(painter, box, entry.scale);
        break;
    }
    painter.setPen(edgeColour(palette));
    painter.drawRect(box.adjusted(0, 0, -1, -1));
}

} // namespace

LegendStrip::LegendStrip(QWidget* parent)
    : QWidget(parent) {
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    hide();
}

void LegendStrip::setEntries(const std::vector<LegendEntry>& entries) {
    if (entries == m_entries)
        return;
    m_entries = entries;
    setAccessibleName(texts().join(QStringLiteral(", ")));
    setVisible(m_keepsPlace || !m_entries.empty());
    updateGeometry();
    update();
}

void LegendStrip::keepPlace() {
    m_keepsPlace = true;
    show();
}

QStringList LegendStrip::texts() const {
    QStringList texts;
    for (const LegendEntry& entry : m_entries)
        texts << entry.text;
    return texts;
}

int LegendStrip::lineHeight() const {
    return fontMetrics().height() + kPadding;
}

std::vector<QRect> LegendStrip::places(int width) const {
    std::vector<QRect> places;
    const int line = lineHeight();
    int x = 0, y = 0;
    for (const LegendEntry& entry : m_entries) {
        const int wanted = sampleWidth(entry.sample) + kSampleGap + fontMetrics().horizontalAdvance(entry.text);
        if (x > 0 && x + wanted > width) {
            x = 0;
            y += line;
        }
        places.emplace_back(x, y, wanted, line);
        x += wanted + kGap;
    }
    return places;
}

int LegendStrip::heightForWidth(int width) const {
    const std::vector<QRect> all = places(width);
    const int kept = m_keepsPlace ? lineHeight() * (width >= kWide ? 2 : 1) : 0;
    return all.empty() ? kept : std::max(kept, all.back().bottom() + 1);
}

QSize LegendStrip::sizeHint() const {
    return {200, heightForWidth(width())};
}

QSize LegendStrip::minimumSizeHint() const {
    return {1, lineHeight()};
}

void LegendStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintEntries(painter, width(), palette());
}

int LegendStrip::heightOnPaper(int width) const {
    const std::vector<QRect> all = places(width);
    return all.empty() ? 0 : all.back().bottom() + 1;
}

void LegendStrip::paintOnPaper(QPainter& painter, int width) const {
    QPalette paper = palette();
    paper.setColor(QPalette::WindowText, kInk);
    paper.setColor(QPalette::Window, Qt::white);
    painter.setFont(font());
    paintEntries(painter, width, paper);
}

void LegendStrip::paintEntries(QPainter& painter, int width, const QPalette& colours) const {
    const std::vector<QRect> all = places(width);
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        const int sample = sampleWidth(m_entries[i].sample);
        paintSample(painter, QRect(all[i].left(), all[i].top(), sample, all[i].height()), m_entries[i], colours);
        painter.setPen(colours.color(QPalette::WindowText));
        painter.drawText(all[i].adjusted(sample + kSampleGap, 0, 2, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         m_entries[i].text);
    }
}

} // namespace widgets
