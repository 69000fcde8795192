// SPDX-License-Identifier: MIT
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>
#include <QWidget>

#include "widgets/document/selection.h"
#include "widgets/jobs/review_queue.h"
#include "widgets/models/review_model.h"
#include "widgets/panels/review/first_pass_form.h"

class QAction;

namespace widgets {

/// What the review panel works with.
struct ReviewSources {
    const ReviewQueue& queue;
    Selection& selection;
    FirstPass& firstPass;
    DatasetSession& datasets;
    JointList& joints;
};

/// The first pass, and the review queue that it fills: frames that a program labelled, those first whose look teaches
/// most, how many are left and what error is to be expected of them. A row jumps to its frame.
class ReviewPanel : public QWidget {
    Q_OBJECT

public:
    explicit ReviewPanel(const ReviewSources& sources, QWidget* parent = nullptr);

    /// The actions behind the buttons.
    void setActions(QAction* accept, QAction* correct, QAction* next, QAction* firstPass);
    QTableView* table() const { return m_table; }
    FirstPassForm* firstPass() const { return m_form; }
    /// Whether the first pass can be set up here; it always can while no frame waits.
    void setFormShown(bool shown);

signals:
    /// A row was clicked; the selection is there already.
    void frameChosen(int frame);

private:
    void build();
    void refresh();
    void showCurrent();

    const ReviewQueue& m_queue;
    Selection& m_selection;
    QLabel* m_progress;
    QLabel* m_nothing;
    QTableView* m_table;
    ReviewModel* m_model;
    QToolButton* m_accept;
    QToolButton* m_correct;
    QToolButton* m_next;
    QToolButton* m_firstPass;
    FirstPassForm* m_form;
    bool m_isFormWanted = false;
};

} // namespace widgets
