// SPDX-License-Identifier: MIT
#include "widgets/views/scatter_plot.h"

#include <algorithm>
#include <cmath>

#include <QMenu>
#include <QMouseEvent>
#include <QPainter>

namespace widgets {

namespace {

constexpr double kDot = 5, kHighlightedDot = 7; ///< diameters
constexpr double kReach = 8;                    ///< of the pointer

} // namespace

ScatterPlot::ScatterPlot(QWidget* parent)
    : PlotCanvas(parent) {}

void ScatterPlot::setLabels(const PlotLabels& labels) {
    m_labels = labels;
    contentChanged();
}

void ScatterPlot::setPoints(std::vector<ScatterPoint> points, std::vector<PlotLegendEntry> groups) {
    m_points = std::move(points);
    std::erase_if(m_points, [](const ScatterPoint& point) {
        return !std::isfinite(point.value.x()) || !std::isfinite(point.value.y());
    });
    m_groups = std::move(groups);
    m_pointed.reset();
    if (!m_isAxisChosen)
        m_isLogarithmic = isCrowded();
    contentChanged();
}

/// Half of the points take less than a twentieth of linear axes, and logarithmic ones can show all.
bool ScatterPlot::isCrowded() const {
    constexpr double kShare = 0.05;
    std::vector<double> values;
    for (const ScatterPoint& point : m_points)
        values.push_back(std::max(point.value.x(), point.value.y()));
    const bool isPositive = std::all_of(m_points.begin(), m_points.end(), [](const ScatterPoint& point) {
        return point.value.x() > 0 && point.value.y() > 0;
    });
    if (values.empty() || !isPositive)
        return false;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2] < kShare * values.back();
}

void ScatterPlot::setHighlighted(std::vector<std::size_t> ids) {
    std::sort(ids.begin(), ids.end());
    m_highlighted = std::move(ids);
    contentChanged();
}

void ScatterPlot::setLogarithmic(bool on) {
    m_isLogarithmic = on;
    m_isAxisChosen = true;
    contentChanged();
}

PlotFrame ScatterPlot::axes() const {
    double min = HUGE_VAL, max = -HUGE_VAL;
    for (const ScatterPoint& point : m_points) {
        for (const double v : {point.value.x(), point.value.y()}) {
            if (m_isLogarithmic && v <= 0)
                continue;
            min = std::min(min, v);
            max = std::max(max, v);
        }
    }
    PlotFrame result;
    result.x = result.y = roundAxis(min, max, m_isLogarithmic);
    return result;
}

void ScatterPlot::paintContent(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const {
    const QColor ground = colours.color(QPalette::Base);
    painter.save();
    painter.setClipRect(frame.plot.adjusted(-kDot, -kDot, kDot, kDot));
    painter.setPen(QPen(colours.color(QPalette::PlaceholderText), 1, Qt::DashLine));
    painter.drawLine(frame.place({frame.x.min, frame.x.min}), frame.place({frame.x.max, frame.x.max}));
    for (std::size_t group = 0; group < m_groups.size(); ++group) {
        std::vector<QPointF> ofGroup;
        for (const ScatterPoint& point : m_points)
            if (point.group == group)
                ofGroup.push_back(frame.place(point.value));
        QColor colour = plotColour(m_groups[group].colour, ground);
        colour.setAlphaF(m_points.size() > 2000 ? 0.5 : 0.85);
        painter.setPen(QPen(colour, kDot, Qt::SolidLine, Qt::RoundCap));
        painter.drawPoints(ofGroup.data(), static_cast<int>(ofGroup.size()));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.color(QPalette::Highlight), 1.6));
    for (const ScatterPoint& point : m_points)
        if (std::binary_search(m_highlighted.begin(), m_highlighted.end(), point.id))
            painter.drawEllipse(frame.place(point.value), kHighlightedDot / 2 + 1, kHighlightedDot / 2 + 1);
    painter.restore();
}

std::vector<PlotLegendEntry> ScatterPlot::legend() const {
    std::vector<PlotLegendEntry> entries = m_groups;
    for (PlotLegendEntry& entry : entries)
        entry.sample = PlotLegendEntry::Sample::Dot;
    return entries;
}

std::vector<QPointF> ScatterPlot::takenPlaces(const PlotFrame& frame) const {
    std::vector<QPointF> places;
    for (const ScatterPoint& point : m_points)
        places.push_back(frame.place(point.value));
    return places;
}

void ScatterPlot::paintPointed(QPainter& painter, const PlotFrame& frame) const {
    if (!m_pointed || *m_pointed >= m_points.size())
        return;
    const ScatterPoint& point = m_points[*m_pointed];
    const QPointF place = frame.place(point.value);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
    painter.drawEllipse(place, kHighlightedDot / 2, kHighlightedDot / 2);
    const QString values = QStringLiteral("%1 / %2").arg(plotNumber(point.value.x()), plotNumber(point.value.y()));
    paintTip(painter, frame, place, m_names ? QStringLiteral("%1: %2").arg(m_names(point.id), values) : values);
}

std::optional<std::size_t> ScatterPlot::pointNear(QPointF place) const {
    if (m_points.empty())
        return std::nullopt;
    const PlotFrame f = frame(rect());
    std::optional<std::size_t> nearest;
    double least = kReach;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const QPointF offset = f.place(m_points[i].value) - place;
        const double distance = std::hypot(offset.x(), offset.y());
        if (distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

void ScatterPlot::mouseMoveEvent(QMouseEvent* event) {
    const auto pointed = pointNear(event->localPos());
    if (pointed == m_pointed)
        return;
    m_pointed = pointed;
    setCursor(pointed ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

void ScatterPlot::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    if (const auto pointed = pointNear(event->localPos()))
        emit pointClicked(m_points[*pointed].id);
}

void ScatterPlot::leaveEvent(QEvent*) {
    m_pointed.reset();
    update();
}

void ScatterPlot::addMenuActions(QMenu& menu) {
    QAction* logarithmic = menu.addAction(tr("Logarithmic axes"));
    logarithmic->setCheckable(true);
    logarithmic->setChecked(m_isLogarithmic);
    connect(logarithmic, &QAction::toggled, this, &ScatterPlot::setLogarithmic);
}

} // namespace widgets
