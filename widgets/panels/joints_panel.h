// SPDX-License-Identifier: MIT
#pragma once

#include <QTableView>
#include <QWidget>

#include "widgets/document/joint_list.h"
#include "widgets/document/reconstructions.h"
#include "widgets/document/selection.h"
#include "widgets/models/joint_table_model.h"
#include "widgets/panels/hand_diagram.h"
#include "widgets/panels/note_edit.h"

namespace widgets {

/// A drawing of both hands, the table of their joints and the note: all about the current frame. Drawing and table
/// select a joint.
class JointsPanel : public QWidget {
    Q_OBJECT

public:
    JointsPanel(JointList& joints, AnnotationDocument& document, const Reconstructions& reconstructions,
                Selection& selection, QWidget* parent = nullptr);

    void setBadRmsPx(double px);
    QTableView* table() const { return m_table; }
    HandDiagram* diagram() const { return m_diagram; }
    NoteEdit* note() const { return m_note; }

signals:
    /// The table's header asks for the menu that changes the list of joints.
    void listMenuRequested(const QPoint& globalPosition);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void selectRow();
    void fitColumns();

    JointList& m_joints;
    Selection& m_selection;
    HandDiagram* m_diagram;
    QTableView* m_table;
    JointTableModel* m_model;
    NoteEdit* m_note;
    int m_widthOfNumbers = 0;
};

} // namespace widgets
