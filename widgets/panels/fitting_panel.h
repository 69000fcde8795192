// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QToolButton>
#include <QWidget>

#include "widgets/document/selection.h"
#include "widgets/jobs/fit_runner.h"
#include "widgets/models/result_table_model.h"
#include "widgets/views/curve_plot.h"
#include "widgets/views/message_bar.h"

namespace widgets {

/// Choose a start and a test frame and methods, run them in the background, read the results: a table and how the error
/// fell.
class FittingPanel : public QWidget {
    Q_OBJECT

public:
    FittingPanel(Selection& selection, FitRunner& fits, QWidget* parent = nullptr);

    /// Fits the current frame, from as many frames before it as the panel's start and test frame are apart.
    void fitCurrentFrame();
    /// Runs exactly this, and shows it in the fields.
    void fit(const FitRequest& request);
    std::vector<std::string> chosenMethods() const;
    FitRequest request() const;
    CurvePlot* plot() const { return m_plot; }
    /// Says why something here did not work.
    void showMessage(const QString& text);

signals:
    /// The person wants to give the sequence masks.
    void masksRequested();

private:
    QLayout* makeFrameRow();
    QLayout* makeMethodRows();
    QLayout* makeRunRow();
    void connectFits();
    void showOutcome();
    void showTargets();
    void showRunning(bool running);
    void showPair(int start, int test);
    void takePair();
    void followFrame();
    int usualStart(int test) const;
    std::vector<Curve> curves() const;

    Selection& m_selection;
    FitRunner& m_fits;
    MessageBar* m_message;
    QSpinBox* m_start;
    QSpinBox* m_test;
    QComboBox* m_target;
    std::vector<QCheckBox*> m_methods;
    QPushButton* m_attach;
    QPushButton* m_run;
    QProgressBar* m_progress;
    QTableView* m_table;
    ResultTableModel* m_model;
    CurvePlot* m_plot;
    int m_apart = 5;       ///< test minus start, as a person chose it last
    bool m_follows = true; ///< the fields show the pair of the current frame, until a person chooses another one
};

} // namespace widgets
