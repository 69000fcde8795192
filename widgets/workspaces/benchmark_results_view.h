// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QComboBox>
#include <QLabel>
#include <QTabWidget>
#include <QTableView>
#include <QWidget>

#include "core/benchmark/benchmark_results.h"
#include "core/benchmark/comparison/benchmark_digest.h"
#include "widgets/models/summary_model.h"
#include "widgets/panels/joint_error_diagram.h"
#include "widgets/views/curve_plot.h"
#include "widgets/workspaces/benchmark_pair_plots.h"
#include "widgets/workspaces/benchmark_pairs_view.h"

namespace widgets {

/// What a benchmark found, finished or not: the table in the paper's layout, the share of pairs below each error, the
/// error of every joint, two methods against each other, and every pair. The plots of two methods follow what the table
/// of pairs shows.
class BenchmarkResultsView : public QWidget {
    Q_OBJECT

public:
    explicit BenchmarkResultsView(QWidget* parent = nullptr);

    /// Null for none; `digest` is of them. While a run goes on, each call brings the rows that
    /// have come since.
    void setResults(std::shared_ptr<const core::BenchmarkResults> results,
                    std::shared_ptr<const core::BenchmarkDigest> digest);
    BenchmarkPairsView* pairs() const { return m_pairs; }
    BenchmarkPairPlots* pairPlots() const { return m_pairPlots; }
    /// Brings the plots of two methods to the front.
    void showPairPlots() { m_pictures->setCurrentWidget(m_pairPlots); }
    /// Asks that this pair is opened.
    void openPair(std::size_t pair);

signals:
    /// A pair was chosen: it shall be looked at with these methods.
    void pairOpened(const core::FramePair& pair, const std::vector<std::string>& methods);
    /// These pairs shall be run.
    void runRequested(const std::vector<core::FramePair>& pairs);

private:
    QWidget* makePictures();
    QWidget* makeJointPart();
    void connectPairs();
    void showCurves();
    void showJointMethods();
    void showJointErrors();
    std::vector<std::string> methodsToInspect() const;

    std::shared_ptr<const core::BenchmarkResults> m_results;
    std::shared_ptr<const core::BenchmarkDigest> m_digest;
    SummaryModel* m_summary;
    QTableView* m_summaryTable;
    BenchmarkPairsView* m_pairs;
    QTabWidget* m_pictures;
    BenchmarkPairPlots* m_pairPlots;
    CurvePlot* m_curves;
    QComboBox* m_jointMethod;
    JointErrorDiagram* m_jointErrors;
};

} // namespace widgets
