// SPDX-License-Identifier: MIT
#include "widgets/views/histogram_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QMouseEvent>
#include <QPainter>

namespace widgets {

HistogramPlot::HistogramPlot(QWidget* parent)
    : PlotCanvas(parent) {}

void HistogramPlot::setLabels(const PlotLabels& labels) {
    m_labels = labels;
    contentChanged();
}

void HistogramPlot::setHistogram(core::Histogram histogram, const PlotLegendEntry& below,
                                 const PlotLegendEntry& above) {
    m_histogram = std::move(histogram);
    m_below = below;
    m_above = above;
    m_pointed.reset();
    contentChanged();
}

PlotFrame HistogramPlot::axes() const {
    PlotFrame result;
    result.x = {m_histogram.from, edge(m_histogram.counts.size()), false};
    const int most = *std::max_element(m_histogram.counts.begin(), m_histogram.counts.end());
    constexpr double kHeadroom = 1.04; // the highest bar ends below the frame
    result.y = roundAxis(0, kHeadroom * most, false);
    result.y.whole = true;
    return result;
}

QRectF HistogramPlot::bar(const PlotFrame& frame, std::size_t bin) const {
    const QPointF top = frame.place({edge(bin), static_cast<double>(m_histogram.counts[bin])});
    const QPointF bottom = frame.place({edge(bin + 1), 0});
    constexpr double kGap = 0.5;
    return QRectF(top, bottom).adjusted(kGap, 0, -kGap, 0);
}

QPointF HistogramPlot::placeOf(std::size_t bin) const {
    return bar(frame(rect()), bin).center();
}

void HistogramPlot::paintContent(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const {
    const QColor ground = colours.color(QPalette::Base);
    painter.setPen(Qt::NoPen);
    for (std::size_t bin = 0; bin < m_histogram.counts.size(); ++bin) {
        const bool isBelow = edge(bin) < -m_histogram.width / 2;
        const QRectF area = bar(frame, bin);
        painter.setBrush(plotColour(isBelow ? m_below.colour : m_above.colour, ground));
        painter.drawRect(area);
    }
    painter.setPen(QPen(colours.color(QPalette::Text), 1));
    painter.drawLine(frame.place({0, 0}), frame.place({0, frame.y.max}));
}

std::vector<PlotLegendEntry> HistogramPlot::legend() const {
    std::vector<PlotLegendEntry> entries = {m_below, m_above};
    for (PlotLegendEntry& entry : entries)
        entry.sample = PlotLegendEntry::Sample::Bar;
    return entries;
}

std::vector<QPointF> HistogramPlot::takenPlaces(const PlotFrame& frame) const {
    std::vector<QPointF> places;
    for (std::size_t bin = 0; bin < m_histogram.counts.size(); ++bin) {
        const QRectF area = bar(frame, bin);
        for (double y = area.top(); y < area.bottom(); y += 8) // a bar takes the whole way down
            places.emplace_back(area.center().x(), y);
    }
    return places;
}

void HistogramPlot::paintPointed(QPainter& painter, const PlotFrame& frame) const {
    if (!m_pointed || *m_pointed >= m_histogram.counts.size())
        return;
    const QRectF area = bar(frame, *m_pointed);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
    painter.drawRect(area);
    paintTip(painter, frame, area.center(),
             tr("%1 to %2, pairs: %3")
                 .arg(plotNumber(edge(*m_pointed)), plotNumber(edge(*m_pointed + 1)))
                 .arg(m_histogram.counts[*m_pointed]));
}

std::optional<std::size_t> HistogramPlot::binAt(QPointF place) const {
    if (isEmpty())
        return std::nullopt;
    const PlotFrame f = frame(rect());
    const double bin = std::floor((f.value(place).x() - m_histogram.from) / m_histogram.width);
    if (!f.plot.contains(place) || bin < 0 || bin >= static_cast<double>(m_histogram.counts.size()))
        return std::nullopt;
    return static_cast<std::size_t>(bin);
}

void HistogramPlot::mouseMoveEvent(QMouseEvent* event) {
    m_pointed = binAt(event->localPos());
    setCursor(m_pointed ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

void HistogramPlot::mousePressEvent(QMouseEvent* event) {
    const auto bin = event->button() == Qt::LeftButton ? binAt(event->localPos()) : std::nullopt;
    if (!bin)
        return;
    constexpr double kNoLimit = std::numeric_limits<double>::infinity();
    emit rangeClicked(*bin == 0 ? -kNoLimit : edge(*bin),
                      *bin + 1 == m_histogram.counts.size() ? kNoLimit : edge(*bin + 1));
}

void HistogramPlot::leaveEvent(QEvent*) {
    m_pointed.reset();
    update();
}

} // namespace widgets
