// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/benchmark/comparison/pair_distribution.h"
#include "widgets/views/plot_canvas.h"

namespace widgets {

/// Boxes from quartile to quartile with the median as a line, and whiskers over the 90 % in the middle: for every
/// category one per series, side by side. A category can be clicked.
class BoxPlot : public PlotCanvas {
    Q_OBJECT
public:
    /// The boxes of one thing that is compared, one per category.
    struct Series {
        PlotLegendEntry entry;
        std::vector<core::BoxStatistics> boxes;
    };

    explicit BoxPlot(QWidget* parent = nullptr);

    void setLabels(const PlotLabels& labels);
    void setBoxes(const QStringList& categories, std::vector<Series> series);
    const std::vector<Series>& series() const { return m_series; }
    /// The middle of a category, in the widget.
    QPointF placeOf(std::size_t category) const;

signals:
    void categoryClicked(int category);

protected:
    bool isEmpty() const override;
    PlotLabels labels() const override { return m_labels; }
    PlotFrame axes() const override;
    std::vector<PlotLegendEntry> legend() const override;
    std::vector<QPointF> takenPlaces(const PlotFrame& frame) const override;
    void paintContent(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const override;
    void paintPointed(QPainter& painter, const PlotFrame& frame) const override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void paintBox(QPainter& painter, const PlotFrame& frame, const core::BoxStatistics& box, double x, double width,
                  const QColor& colour, const QColor& ground) const;
    std::optional<int> categoryAt(QPointF place) const;

    PlotLabels m_labels;
    QStringList m_categories;
    std::vector<Series> m_series;
    std::optional<int> m_pointed;
};

} // namespace widgets
