// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QComboBox>
#include <QLabel>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QWidget>

#include "core/benchmark/benchmark_results.h"
#include "widgets/models/pair_table_model.h"
#include "widgets/models/summary_model.h"
#include "widgets/panels/joint_error_diagram.h"
#include "widgets/views/curve_plot.h"

namespace widgets {

/// What a benchmark found, finished or not: the table in the paper's layout, the share of pairs below each error, the
/// error of every joint, and every pair.
class BenchmarkResultsView : public QWidget {
    Q_OBJECT

public:
    explicit BenchmarkResultsView(QWidget* parent = nullptr);

    /// Null for none. While a run goes on, each call brings the rows that have come since.
    void setResults(std::shared_ptr<const core::BenchmarkResults> results);

signals:
    /// A pair was double-clicked: it shall be looked at with these methods.
    void pairOpened(const core::FramePair& pair, const std::vector<std::string>& methods);

private:
    QWidget* makeJointPart();
    void showCurves();
    void showJointMethods();
    void showJointErrors();
    std::vector<std::string> methodsToInspect(const std::string& clicked) const;

    std::shared_ptr<const core::BenchmarkResults> m_results;
    SummaryModel* m_summary;
    QTableView* m_summaryTable;
    PairTableModel* m_pairs;
    QSortFilterProxyModel* m_sortedPairs;
    QTableView* m_pairTable;
    CurvePlot* m_curves;
    QComboBox* m_jointMethod;
    JointErrorDiagram* m_jointErrors;
};

} // namespace widgets
