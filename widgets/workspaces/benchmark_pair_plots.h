// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QWidget>

#include "widgets/models/pair_table_model.h"
#include "widgets/views/box_plot.h"
#include "widgets/views/histogram_plot.h"
#include "widgets/views/scatter_plot.h"

namespace widgets {

/// Two methods of a benchmark against each other, over the pairs that a table shows: the error of B over that of A, how
/// their difference is spread, and both by how far start and test frame are apart.
class BenchmarkPairPlots : public QWidget {
    Q_OBJECT

public:
    explicit BenchmarkPairPlots(QWidget* parent = nullptr);

    /// Draws what the model shows now.
    void showPairs(const PairTableModel& model);
    /// Rings around these pairs.
    void setSelected(const std::vector<std::size_t>& pairs) { m_scatter->setHighlighted(pairs); }

    ScatterPlot* scatter() const { return m_scatter; }
    HistogramPlot* histogram() const { return m_histogram; }
    BoxPlot* boxes() const { return m_boxes; }

signals:
    void pairClicked(std::size_t pair);
    /// Only these shall be shown: a condition of filters.
    void conditionClicked(const QString& condition);

private:
    void showScatter(const PairTableModel& model);
    void showHistogram(const PairTableModel& model);
    void showBoxes(const PairTableModel& model);

    ScatterPlot* m_scatter;
    HistogramPlot* m_histogram;
    BoxPlot* m_boxes;
    std::vector<int> m_differences; ///< the categories of the boxes
};

} // namespace widgets
