// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "widgets/views/plot_canvas.h"

namespace widgets {

/// One thing in a scatter plot.
struct ScatterPoint {
    QPointF value;
    std::size_t id = 0;    ///< what clicks and highlights mean
    std::size_t group = 0; ///< an index into the groups: its colour
};

/// Points over two axes of the same range with the diagonal where both values are equal. The point under the pointer is
/// named and can be clicked. Tens of thousands of points are fine.
class ScatterPlot : public PlotCanvas {
    Q_OBJECT
public:
    explicit ScatterPlot(QWidget* parent = nullptr);

    void setLabels(const PlotLabels& labels);
    void setPoints(std::vector<ScatterPoint> points, std::vector<PlotLegendEntry> groups);
    /// Drawn larger, with a ring; such as the selected rows of a table.
    void setHighlighted(std::vector<std::size_t> ids);
    /// What is said of the point under the pointer.
    void setNames(std::function<QString(std::size_t id)> names) { m_names = std::move(names); }
    /// By itself where most points would lie in a corner of linear axes; as set from then on.
    bool isLogarithmic() const { return m_isLogarithmic; }
    void setLogarithmic(bool on);

    const std::vector<ScatterPoint>& points() const { return m_points; }
    /// Where a point is drawn, in the widget.
    QPointF placeOf(const ScatterPoint& point) const { return frame(rect()).place(point.value); }

signals:
    void pointClicked(std::size_t id);

protected:
    bool isEmpty() const override { return m_points.empty(); }
    PlotLabels labels() const override { return m_labels; }
    PlotFrame axes() const override;
    std::vector<PlotLegendEntry> legend() const override;
    std::vector<QPointF> takenPlaces(const PlotFrame& frame) const override;
    void paintContent(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const override;
    void paintPointed(QPainter& painter, const PlotFrame& frame) const override;
    void addMenuActions(QMenu& menu) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    std::optional<std::size_t> pointNear(QPointF place) const;
    bool isCrowded() const;

    PlotLabels m_labels;
    std::vector<ScatterPoint> m_points;
    std::vector<PlotLegendEntry> m_groups;
    std::vector<std::size_t> m_highlighted; ///< ids, ascending
    std::function<QString(std::size_t id)> m_names;
    std::optional<std::size_t> m_pointed; ///< an index into m_points
    bool m_isLogarithmic = false, m_isAxisChosen = false;
};

} // namespace widgets
