// SPDX-License-Identifier: MIT
#include "widgets/panels/review/review_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/panels/table_style.h"
#include "widgets/text/review_text.h"

namespace widgets {

ReviewPanel::ReviewPanel(const ReviewSources& sources, QWidget* parent)
    : QWidget(parent)
    , m_queue(sources.queue)
    , m_selection(sources.selection)
    , m_progress(new QLabel(this))
    , m_nothing(new QLabel(this))
    , m_table(new QTableView(this))
    , m_model(new ReviewModel(this))
    , m_accept(new QToolButton(this))
    , m_correct(new QToolButton(this))
    , m_next(new QToolButton(this))
    , m_firstPass(new QToolButton(this))
    , m_form(new FirstPassForm(sources.firstPass, sources.datasets, sources.joints, this)) {
    build();
    connect(m_form, &FirstPassForm::closeRequested, this, [this] { setFormShown(false); });
    connect(&m_queue, &ReviewQueue::changed, this, &ReviewPanel::refresh);
    connect(&m_selection, &Selection::frameChanged, this, &ReviewPanel::showCurrent);
    connect(m_table, &QTableView::clicked, this, [this](const QModelIndex& index) {
        const int frame = m_model->frame(index.row());
        m_selection.setFrame(frame);
        emit frameChosen(frame);
    });
    refresh();
}

void ReviewPanel::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpacing, kSpacing, kSpacing, kSpacing);
    column->setSpacing(kSpacing);
    for (QLabel* label : {m_progress, m_nothing})
        label->setWordWrap(true);
    QPalette quiet = palette();
    quiet.setColor(QPalette::WindowText, quietTextColour(quiet));
    m_nothing->setPalette(quiet);
    m_nothing->setAlignment(Qt::AlignCenter);
    m_table->setModel(m_model);
    styleTable(*m_table);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpacing);
    for (QToolButton* button : {m_accept, m_correct, m_next, m_firstPass}) {
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        row->addWidget(button);
    }
    for (QWidget* widget : std::initializer_list<QWidget*>{m_table, m_accept, m_correct, m_next, m_firstPass})
        widget->setFocusPolicy(Qt::NoFocus);
    row->addStretch(1);
    column->addWidget(m_form);
    column->addWidget(m_progress);
    column->addWidget(m_nothing, 1);
    column->addWidget(m_table, 1);
    column->addLayout(row);
}

void ReviewPanel::setActions(QAction* accept, QAction* correct, QAction* next, QAction* firstPass) {
    m_accept->setDefaultAction(accept);
    m_correct->setDefaultAction(correct);
    m_next->setDefaultAction(next);
    m_firstPass->setDefaultAction(firstPass);
    m_accept->setText(tr("Accept")); // shorter than in the menu: the panel is narrow
    m_correct->setText(tr("Correct"));
    m_next->setText(tr("Next"));
    m_firstPass->setText(tr("First pass..."));
}

void ReviewPanel::refresh() {
    m_model->setRows(m_queue.rows());
    const bool any = m_model->rowCount() > 0;
    const QString text = reviewProgressText(m_queue.progress(), m_queue.reviewed());
    m_progress->setText(text);
    m_progress->setVisible(!text.isEmpty());
    m_nothing->setText(m_queue.reviewed() > 0
                           ? tr("No frame waits for a look.")
                           : tr("Frames that the first pass has labelled wait here for a look, doubtful ones first."));
    m_nothing->setVisible(!any);
    m_table->setVisible(any);
    for (QToolButton* button : {m_accept, m_correct, m_next})
        button->setVisible(any);
    m_form->setVisible(!any || m_isFormWanted);
    m_form->setClosable(any);
    m_firstPass->setVisible(any && !m_isFormWanted);
    showCurrent();
}

void ReviewPanel::setFormShown(bool shown) {
    m_isFormWanted = shown;
    refresh();
}

/// The row of the current frame is the selected one.
void ReviewPanel::showCurrent() {
    const int row = m_model->rowOf(m_selection.frame());
    if (row < 0) {
        m_table->clearSelection();
        return;
    }
    m_table->selectRow(row);
    m_table->scrollTo(m_model->index(row, 0));
}

} // namespace widgets
