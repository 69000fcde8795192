// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/benchmark/comparison/pair_distribution.h"
#include "widgets/views/plot_canvas.h"

namespace widgets {

/// How often the difference of two things lies where: bars below 0 and above it in two colours. A bar under the pointer
/// says its range and can be clicked.
class HistogramPlot : public PlotCanvas {
    Q_OBJECT
public:
    explicit HistogramPlot(QWidget* parent = nullptr);

    void setLabels(const PlotLabels& labels);
    /// `below` and `above` are what values below and above 0 mean.
    void setHistogram(core::Histogram histogram, const PlotLegendEntry& below, const PlotLegendEntry& above);
    const core::Histogram& histogram() const { return m_histogram; }
    /// The middle of a bar, in the widget.
    QPointF placeOf(std::size_t bin) const;

signals:
    /// A bar was clicked: the values from `low` to below `high`; the bars at the ends have no outer limit (infinity).
    void rangeClicked(double low, double high);

protected:
    bool isEmpty() const override { return m_histogram.counts.empty(); }
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
    double edge(std::size_t bin) const { return m_histogram.from + static_cast<double>(bin) * m_histogram.width; }
    QRectF bar(const PlotFrame& frame, std::size_t bin) const;
    std::optional<std::size_t> binAt(QPointF place) const;

    PlotLabels m_labels;
    core::Histogram m_histogram;
    PlotLegendEntry m_below, m_above;
    std::optional<std::size_t> m_pointed;
};

} // namespace widgets
