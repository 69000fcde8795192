// SPDX-License-Identifier: MIT
#include "widgets/views/box_plot.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>

namespace widgets {

BoxPlot::BoxPlot(QWidget* parent)
    : PlotCanvas(parent) {}

void BoxPlot::setLabels(const PlotLabels& labels) {
    m_labels = labels;
    contentChanged();
}

void BoxPlot::setBoxes(const QStringList& categories, std::vector<Series> series) {
    m_categories = categories;
    m_series = std::move(series);
    m_pointed.reset();
    contentChanged();
}

bool BoxPlot::isEmpty() const {
    return std::all_of(
        m_series.begin(), m_series.end(),
        [](const Series& series) {
            return std::all_of(
                series.boxes.begin(), series.boxes.end(),
                [](const core::BoxStatistics& box) { return box.count == 0; });
        });
}

PlotFrame BoxPlot::axes() const {
    double min = HUGE_VAL, max = -HUGE_VAL;
    for (const Series& series : m_series) {
        for (const core::BoxStatistics& box : series.boxes) {
            if (box.count > 0) {
                min = std::min(min, box.low);
                max = std::max(max, box.high);
            }
        }
    }
    PlotFrame result;
    result.x = {-0.5, m_categories.size() - 0.5, false};
    result.y = roundAxis(min, max, false);
    for (int category = 0; category < m_categories.size(); ++category)
        result.xTicks.push_back(category);
    result.xNames = m_categories;
    return result;
}

QPointF BoxPlot::placeOf(std::size_t category) const {
    const PlotFrame f = frame(rect());
    return {f.place({static_cast<double>(category), f.y.min}).x(), f.plot.center().y()};
}

void BoxPlot::paintBox(QPainter& painter, const PlotFrame& frame, const core::BoxStatistics& box, double x,
                       double width, const QColor& colour, const QColor& ground) const {
    const auto at = [&](double dx, double y) { return QPointF(x + dx * width, frame.place({frame.x.min, y}).y()); };
    constexpr double kWhisker = 0.25, kHalf = 0.5;
    painter.setPen(QPen(colour, 1.4));
    painter.drawLine(at(0, box.low), at(0, box.lowerQuartile));
    painter.drawLine(at(0, box.upperQuartile), at(0, box.high));
    for (const double end : {box.low, box.high})
        painter.drawLine(at(-kWhisker, end), at(kWhisker, end));
    QColor fill = colour;
    fill.setAlphaF(0.35);
    painter.setBrush(fill);
    painter.drawRect(QRectF(at(-kHalf, box.upperQuartile), at(kHalf, box.lowerQuartile)));
    painter.setPen(QPen(plotColour(colour, ground), 2.6));
    painter.drawLine(at(-kHalf, box.median), at(kHalf, box.median));
}

void BoxPlot::paintContent(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const {
    const QColor ground = colours.color(QPalette::Base);
    const double perCategory = frame.plot.width() / std::max(1, m_categories.size());
    const auto count = static_cast<double>(m_series.size());
    constexpr double kUsed = 0.7, kMostWidth = 36, kGap = 0.8;
    const double step = std::min(kMostWidth, kUsed * perCategory / count);
    for (std::size_t s = 0; s < m_series.size(); ++s) {
        for (std::size_t category = 0; category < m_series[s].boxes.size(); ++category) {
            const core::BoxStatistics& box = m_series[s].boxes[category];
            if (box.count == 0)
                continue;
            const double middle = frame.place({static_cast<double>(category), frame.y.min}).x();
            const double x = middle + (static_cast<double>(s) - (count - 1) / 2) * step;
            paintBox(painter, frame, box, x, kGap * step, plotColour(m_series[s].entry.colour, ground), ground);
        }
    }
}

std::vector<PlotLegendEntry> BoxPlot::legend() const {
    std::vector<PlotLegendEntry> entries;
    for (const Series& series : m_series) {
        entries.push_back(series.entry);
        entries.back().sample = PlotLegendEntry::Sample::Bar;
    }
    return entries;
}

std::vector<QPointF> BoxPlot::takenPlaces(const PlotFrame& frame) const {
    std::vector<QPointF> places;
    for (const Series& series : m_series) {
        for (std::size_t category = 0; category < series.boxes.size(); ++category) {
            const core::BoxStatistics& box = series.boxes[category];
            for (const double y : {box.low, box.lowerQuartile, box.median, box.upperQuartile, box.high})
                if (box.count > 0)
                    places.push_back(frame.place({static_cast<double>(category), y}));
        }
    }
    return places;
}

void BoxPlot::paintPointed(QPainter& painter, const PlotFrame& frame) const {
    if (!m_pointed)
        return;
    QStringList texts;
    for (const Series& series : m_series) {
        const core::BoxStatistics& box = series.boxes[static_cast<std::size_t>(*m_pointed)];
        if (box.count > 0)
            texts << tr("%1: median %2").arg(series.entry.name, plotNumber(box.median));
    }
    if (!texts.isEmpty())
        paintTip(painter, frame, placeOf(static_cast<std::size_t>(*m_pointed)), texts.join(QStringLiteral(", ")));
}

std::optional<int> BoxPlot::categoryAt(QPointF place) const {
    if (isEmpty())
        return std::nullopt;
    const PlotFrame f = frame(rect());
    const int category = static_cast<int>(std::lround(f.value(place).x()));
    if (!f.plot.contains(place) || category < 0 || category >= m_categories.size())
        return std::nullopt;
    return category;
}

void BoxPlot::mouseMoveEvent(QMouseEvent* event) {
    m_pointed = categoryAt(event->localPos());
    setCursor(m_pointed ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

void BoxPlot::mousePressEvent(QMouseEvent* event) {
    const auto category = event->button() == Qt::LeftButton ? categoryAt(event->localPos()) : std::nullopt;
    if (category)
        emit categoryClicked(*category);
}

void BoxPlot::leaveEvent(QEvent*) {
    m_pointed.reset();
    update();
}

} // namespace widgets
