// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QSpinBox>
#include <QTableView>
#include <QWidget>

#include "widgets/jobs/workbench.h"
#include "widgets/models/pair_table_model.h"
#include "widgets/models/summary_model.h"
#include "widgets/panels/joint_error_diagram.h"
#include "widgets/views/curve_plot.h"
#include "widgets/views/message_bar.h"

namespace widgets {

/// Many pairs, all methods: what to run on the left, then the table in the paper's layout, the share of pairs below each error, the error
/// of every joint, and every pair. A double click on a pair opens it for inspection.
class BenchmarkPage : public QWidget {
    Q_OBJECT

public:
    explicit BenchmarkPage(Workbench& workbench, QWidget* parent = nullptr);

    /// Which test frames the settings draw from the open sequence; none if they make no sense now.
    std::set<int> testFrames() const;

    /// What the fields say. Throws core::Error(Usage) if the differences are no whole numbers, or nothing is chosen.
    BenchmarkRequest request() const;
    core::PairOptions pairOptions() const;

signals:
    /// The settings draw other test frames.
    void drawChanged();
    /// A pair shall be looked at with this method.
    void pairOpened(const QString& sequence, const widgets::FitRequest& request);

private:
    core::BenchmarkSetup setup() const;
    QWidget* makeSettings();
    QWidget* makeResults();
    void connectRunner();
    void runOrStop();
    void takeDataset();
    void takeResults();
    void showJointErrors();
    void showRunning(bool running);

    Workbench& m_workbench;
    MessageBar* m_message;
    QListWidget* m_sequences;
    std::vector<QCheckBox*> m_methods;
    QComboBox* m_setup;
    QDoubleSpinBox* m_percent;
    QLineEdit* m_differences;
    QSpinBox* m_seed;
    QPushButton* m_run;
    QProgressBar* m_progress;
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
