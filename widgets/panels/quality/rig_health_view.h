// SPDX-License-Identifier: MIT
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>
#include <QWidget>

#include "widgets/jobs/rig_study.h"
#include "widgets/models/rig_health_model.h"

class QAction;

namespace widgets {

/// What all clicks of the dataset say of its calibration: findings in words, a row per camera, and when refining it is
/// worth it.
class RigHealthView : public QWidget {
    Q_OBJECT

public:
    explicit RigHealthView(const RigStudy& rig, QWidget* parent = nullptr);

    /// The action that shows residual arrows in the views gets a button here.
    void setArrowsAction(QAction* action);

signals:
    void refineRequested();
    /// A row was clicked.
    void cameraChosen(const std::string& camera);

private:
    void build();
    void refresh();

    const RigStudy& m_rig;
    QLabel* m_findings;
    QTableView* m_table;
    RigHealthModel* m_model;
    QLabel* m_hint;
    QPushButton* m_refine;
    QToolButton* m_arrows;
};

} // namespace widgets
