// SPDX-License-Identifier: MIT
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include "widgets/document/annotation_document.h"
#include "widgets/document/reconstructions.h"
#include "widgets/document/selection.h"

namespace widgets {

/// The line at the bottom: the selected joint's numbers, what to do next, long work with Stop, and when the last edit
/// was saved.
class StatusLine : public QWidget {
    Q_OBJECT

public:
    StatusLine(const AnnotationDocument& document, const Reconstructions& reconstructions, const Selection& selection,
               QWidget* parent = nullptr);

    /// Says something for a few seconds instead of the advice (why a key did nothing).
    void sayBriefly(const QString& text);
    /// While nothing is open.
    void setIdleText(const QString& text);
    /// Says this instead of the selected joint's numbers and the advice, outside the Annotate workspace; both empty:
    /// joint and advice again.
    void setWords(const QString& summary, const QString& advice);

    /// What lasts and is not about the selected joint, such as a camera that moved: said in one place, with a button's
    /// click. Empty: nothing.
    void setNotice(const QString& text);

    /// Long work: with a name and, from its progress, how long it still takes. `fraction` below 0 shows no amount.
    void showWork(const QString& name, double fraction);
    void hideWork();

signals:
    void stopRequested();
    void noticeClicked();
    /// sayBriefly() was asked to say this.
    void said(const QString& text);

private:
    void refresh();
    void refreshSaved();

    const AnnotationDocument& m_document;
    const Reconstructions& m_reconstructions;
    const Selection& m_selection;
    QLabel* m_summary;
    QLabel* m_advice;
    QToolButton* m_notice;
    QLabel* m_work;
    QProgressBar* m_progress;
    QToolButton* m_stop;
    QLabel* m_saved;
    QTimer m_brief;
    QTimer m_clock;
    QElapsedTimer m_workTime;
    QString m_briefText;
    QString m_idleText;
    QString m_workSummary;
    QString m_workAdvice;
};

} // namespace widgets
