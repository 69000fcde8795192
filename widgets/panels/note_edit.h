// SPDX-License-Identifier: MIT
#pragma once

#include <QLineEdit>

#include "widgets/document/annotation_document.h"
#include "widgets/document/selection.h"

namespace widgets {

/// The note on the current frame, in one line. It is kept when Enter is pressed or the keyboard goes elsewhere; Escape
/// gives up.
class NoteEdit : public QLineEdit {
    Q_OBJECT

public:
    NoteEdit(AnnotationDocument& document, const Selection& selection, QWidget* parent = nullptr);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QString noteOf(int frame) const;
    void showNote();
    void keepNote();

    AnnotationDocument& m_document;
    const Selection& m_selection;
    int m_frame = 0;
};

} // namespace widgets
