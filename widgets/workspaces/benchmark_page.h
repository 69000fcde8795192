// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QWidget>

#include "widgets/document/annotation_document.h"
#include "widgets/jobs/benchmark/benchmark_runner.h"
#include "widgets/jobs/fit_pair.h"
#include "widgets/session/annotation_coverage.h"
#include "widgets/session/dataset_session.h"
#include "widgets/views/message_bar.h"
#include "widgets/workspaces/benchmark_results_view.h"

namespace widgets {

/// Many pairs, all methods: what to run on the left, then the results as they come, of one setup at a time. They can be
/// saved, shown as a page and opened again.
/// A double click on a pair opens it for inspection.
class BenchmarkPage : public QWidget {
    Q_OBJECT

public:
    BenchmarkPage(BenchmarkRunner& runner, const DatasetSession& datasets, const AnnotationDocument& document,
                  const AnnotationCoverage& coverage, QWidget* parent = nullptr);

    /// Which test frames the settings draw from the open sequence; none if they make no sense now.
    std::set<int> testFrames() const;

    /// Why it cannot run, in the person's language; empty if it can.
    QString objection(const BenchmarkRequest& request) const;
    /// What the fields say; objection() tells whether it makes sense.
    BenchmarkRequest request() const;
    std::optional<QString> wrongDifference() const;
    core::PairOptions pairOptions() const;

    void runOrStop();
    /// Runs the ticked methods on pairs of the results that are shown, and adds what they find.
    void runPairs(const std::vector<core::FramePair>& pairs);
    /// The same with those that are selected; says so if none is.
    void runSelectedPairs();
    BenchmarkResultsView* results() const { return m_results; }
    /// Asks for a folder, then saves the results there, or shows those of it.
    void askToSave();
    void askToOpen();

signals:
    /// The settings draw other test frames.
    void drawChanged();
    /// The page of saved results shall be shown.
    void reportWanted(const QString& file);
    /// A pair shall be looked at with these methods.
    void pairOpened(const QString& sequence, const widgets::FitRequest& request);

private:
    bool drawsAnnotatedFrames() const;
    QWidget* makeResults();
    void showSetups();
    void offerReport(const QString& folder);
    QWidget* makeSettings();
    QLayout* makeFileRow();
    void connectRunner();
    void takeDataset();
    void takeResults();
    void chooseFolder(const QString& title, const std::function<void(const QString&)>& take);
    void showRunning(bool running);

    BenchmarkRunner& m_runner;
    const DatasetSession& m_datasets;
    const AnnotationDocument& m_document;
    const AnnotationCoverage& m_coverage;
    MessageBar* m_message;
    QListWidget* m_sequences;
    std::vector<QCheckBox*> m_methods;
    QComboBox* m_setup;
    QDoubleSpinBox* m_percent;
    QLineEdit* m_differences;
    QSpinBox* m_seed;
    QPushButton* m_run;
    QProgressBar* m_progress;
    QPushButton* m_save;
    QPushButton* m_open;
    QWidget* m_shownRow;
    QComboBox* m_shown;
    QLabel* m_agreement;
    BenchmarkResultsView* m_results;
    QString m_lastFolder;
};

} // namespace widgets
