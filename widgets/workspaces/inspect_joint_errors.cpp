// SPDX-License-Identifier: MIT
#include "widgets/workspaces/inspect_joint_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QSignalBlocker>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/views/method_chip.h"

namespace widgets {

InspectJointErrors::InspectJointErrors(InspectColumns& columns, InspectJointMarks& marks, QWidget* parent)
    : QWidget(parent)
    , m_columns(columns)
    , m_marks(marks)
    , m_column(new QComboBox(this))
    , m_diagram(new JointErrorDiagram(this)) {
    m_column->setFocusPolicy(Qt::NoFocus);
    m_column->setToolTip(tr("The column whose error is drawn, joint by joint, at the iteration that is shown"));
    m_diagram->setClickable(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpacing / 2);
    column->addWidget(m_column);
    column->addWidget(m_diagram, 1);
    connect(m_column, qOverload<int>(&QComboBox::activated), this,
            [this](int index) { m_columns.setCurrent(static_cast<std::size_t>(index)); });
    connect(&columns, &InspectColumns::changed, this, &InspectJointErrors::showColumns);
    connect(&columns, &InspectColumns::currentChanged, this, &InspectJointErrors::refresh);
    connect(&marks, &InspectJointMarks::jointChanged, this, [this] { m_diagram->setSelected(m_marks.joint()); });
    connect(m_diagram, &JointErrorDiagram::jointClicked, this, [this](const core::JointId& joint) {
        const bool again = m_marks.joint() == joint;
        m_marks.setJoint(again ? std::nullopt : std::optional(joint));
        if (!again)
            emit jointChosen(joint);
    });
    showColumns();
}

void InspectJointErrors::showIteration(std::shared_ptr<const core::Dataset> dataset, int iteration) {
    m_dataset = std::move(dataset);
    m_iteration = iteration;
    refresh();
}

void InspectJointErrors::showColumns() {
    const QSignalBlocker blocker(m_column);
    m_column->clear();
    for (const InspectColumn& column : m_columns.columns())
        m_column->addItem(methodChip(columnId(column)), columnTitle(column));
    refresh();
}

std::vector<JointError> InspectJointErrors::errorsOf(std::size_t column, int iteration) const {
    std::vector<JointError> errors;
    const auto& outcome = m_columns.outcome();
    if (!outcome || !m_dataset)
        return errors;
    const core::JointPositions joints = inspectedJoints(*m_dataset, *outcome, column, iteration);
    for (const auto& [joint, place] : joints) {
        const auto truth = outcome->reference.find(joint);
        errors.push_back({joint, truth == outcome->reference.end() ? std::numeric_limits<double>::quiet_NaN()
                                                                   : (place - truth->second).norm()});
    }
    return errors;
}

void InspectJointErrors::refresh() {
    const QSignalBlocker blocker(m_column);
    m_column->setCurrentIndex(static_cast<int>(m_columns.current()));
    double largestMm = 0; // over all columns: the scale stays when another one is looked at
    for (std::size_t column = 0; column < m_columns.count(); ++column)
        for (const JointError& error : errorsOf(column, m_iteration))
            largestMm = std::isfinite(error.errorMm) ? std::max(largestMm, error.errorMm) : largestMm;
    m_diagram->setErrors(errorsOf(m_columns.current(), m_iteration), largestMm);
}

} // namespace widgets
