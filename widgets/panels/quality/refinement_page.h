// SPDX-License-Identifier: MIT
#pragma once

#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QTableView>
#include <QWidget>

#include "widgets/jobs/rig_study.h"
#include "widgets/models/refinement_model.h"
#include "widgets/session/calibration_choice.h"
#include "widgets/views/message_bar.h"

namespace widgets {

/// Refines the calibration, shows what it does to every camera, and lets a person use the result, or any calibration
/// that the dataset had before.
class RefinementPage : public QWidget {
    Q_OBJECT

public:
    RefinementPage(RigStudy& rig, CalibrationChoice& calibrations, QWidget* parent = nullptr);

    /// Refines at once if there is a dataset.
    void refine();
    /// Uses the refined calibration; says so if there is none.
    void apply();

private:
    void build();
    QLayout* makeButtons();
    void showProposal();
    void showRunning();
    void showFiles();

    RigStudy& m_rig;
    CalibrationChoice& m_calibrations;
    MessageBar* m_message;
    QLabel* m_summary;
    QTableView* m_table;
    RefinementModel* m_model;
    QPushButton* m_refine;
    QProgressBar* m_progress;
    QPushButton* m_stop;
    QPushButton* m_discard;
    QPushButton* m_apply;
    QListWidget* m_files;
    QPushButton* m_use;
};

} // namespace widgets
