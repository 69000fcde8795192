// SPDX-License-Identifier: MIT
#pragma once

#include <QTableView>
#include <QWidget>

#include "widgets/document/joint_list.h"
#include "widgets/document/reconstructions.h"
#include "widgets/document/selection.h"
#include "widgets/models/joint_table_model.h"
#include "widgets/panels/hand_diagram.h"

namespace widgets {

/// A drawing of both hands and the table of their joints: both show the current frame, and both select a joint.
class JointsPanel : public QWidget {
    Q_OBJECT

public:
    JointsPanel(JointList& joints, const Reconstructions& reconstructions, Selection& selection, QWidget* parent = nullptr);

    void setBadRmsPx(double px);
    QTableView* table() const { return m_table; }
    HandDiagram* diagram() const { return m_diagram; }

signals:
    /// The table's header asks for the menu that changes the list of joints.
    void listMenuRequested(const QPoint& globalPosition);

private:
    void selectRow();

    JointList& m_joints;
    Selection& m_selection;
    HandDiagram* m_diagram;
    QTableView* m_table;
    JointTableModel* m_model;
};

} // namespace widgets
