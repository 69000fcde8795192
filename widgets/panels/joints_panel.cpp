// SPDX-License-Identifier: MIT
#include "widgets/panels/joints_panel.h"

#include <algorithm>

#include <QHeaderView>
#include <QScrollBar>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/panels/table_style.h"

namespace widgets {

JointsPanel::JointsPanel(JointList& joints, AnnotationDocument& document, const Reconstructions& reconstructions,
                         Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_joints(joints)
    , m_selection(selection)
    , m_diagram(new HandDiagram(joints, reconstructions, selection, this))
    , m_table(new QTableView(this))
    , m_model(new JointTableModel(joints, reconstructions, this))
    , m_note(new NoteEdit(document, selection, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_diagram);
    column->addWidget(m_table, 1);
    column->addWidget(m_note);
    m_table->setModel(m_model);
    styleTable(*m_table);
    m_widthOfNumbers = m_table->fontMetrics().horizontalAdvance(QStringLiteral("00.00")) + kSpacing;
    for (const int wide : {JointTableModel::Views, JointTableModel::ErrorPx, JointTableModel::SigmaMm}) {
        m_table->horizontalHeader()->setSectionResizeMode(wide, QHeaderView::Fixed);
        m_table->setColumnWidth(wide, m_widthOfNumbers);
    }
    m_table->setFocusPolicy(Qt::NoFocus);
    m_table->horizontalHeader()->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(
        m_table->horizontalHeader(), &QWidget::customContextMenuRequested, this,
        [this](const QPoint& position) { emit listMenuRequested(m_table->horizontalHeader()->mapToGlobal(position)); });
    connect(m_table, &QTableView::clicked, this,
            [this](const QModelIndex& index) { m_selection.setJoint(m_model->jointAt(index.row())); });
    connect(&m_selection, &Selection::jointChanged, this, &JointsPanel::selectRow);
    connect(m_model, &QAbstractItemModel::modelReset, this, &JointsPanel::selectRow);
    connect(m_model, &QAbstractItemModel::modelReset, this, &JointsPanel::fitColumns);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &JointsPanel::fitColumns); // states have other widths
}

void JointsPanel::setBadRmsPx(double px) {
    m_model->setBadRmsPx(px);
    m_diagram->setBadRmsPx(px);
}

void JointsPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitColumns();
}

/// In a narrow window, columns give way until the joints' names can be read: the drawing above shows the state, too.
void JointsPanel::fitColumns() {
    const QAbstractItemView& cells = *m_table; // whose size hints are public
    const QHeaderView* header = m_table->horizontalHeader();
    const int optional[] = {JointTableModel::State, JointTableModel::SigmaMm, JointTableModel::Views};
    for (const int column : optional)
        m_table->setColumnHidden(column, false); // a hidden one has no width
    const auto width = [&](int column) {
        return header->sectionResizeMode(column) == QHeaderView::Fixed
                   ? m_widthOfNumbers
                   : std::max(cells.sizeHintForColumn(column), header->sectionSizeHint(column));
    };
    const int scrollBar = m_table->verticalScrollBar()->sizeHint().width();
    int room = m_table->width() - scrollBar - width(JointTableModel::Joint);
    for (int column = 0; column < JointTableModel::ColumnCount; ++column)
        room -= column == JointTableModel::Joint ? 0 : width(column);
    for (const int column : optional) {
        m_table->setColumnHidden(column, room < 0);
        room += room < 0 ? width(column) : 0;
    }
}

void JointsPanel::selectRow() {
    const int row = m_model->rowOf(m_selection.joint());
    if (row < 0) {
        m_table->clearSelection();
        return;
    }
    m_table->selectRow(row);
    m_table->scrollTo(m_model->index(row, 0));
}

} // namespace widgets
