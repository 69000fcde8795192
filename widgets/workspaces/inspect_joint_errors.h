// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QComboBox>
#include <QWidget>

#include "core/io/dataset/dataset.h"
#include "widgets/panels/joint_error_diagram.h"
#include "widgets/presenters/inspect/inspect_joint_marks.h"
#include "widgets/presenters/inspect_columns.h"

namespace widgets {

/// The error of every joint of the current column at the iteration that is shown, on the drawing of the hands; one
/// scale for all columns. A click on a joint marks it in every view, a second one takes the marks away.
class InspectJointErrors : public QWidget {
    Q_OBJECT

public:
    InspectJointErrors(InspectColumns& columns, InspectJointMarks& marks, QWidget* parent = nullptr);

    void showIteration(std::shared_ptr<const core::Dataset> dataset, int iteration);
    JointErrorDiagram* diagram() const { return m_diagram; }

signals:
    void jointChosen(const core::JointId& joint);

private:
    void refresh();
    void showColumns();
    std::vector<JointError> errorsOf(std::size_t column, int iteration) const;

    InspectColumns& m_columns;
    InspectJointMarks& m_marks;
    std::shared_ptr<const core::Dataset> m_dataset;
    int m_iteration = 0;
    QComboBox* m_column;
    JointErrorDiagram* m_diagram;
};

} // namespace widgets
