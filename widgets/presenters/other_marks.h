// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QObject>

#include "core/annotation/raters.h"
#include "widgets/document/annotation_document.h"
#include "widgets/document/selection.h"
#include "widgets/jobs/rater_study.h"
#include "widgets/views/camera/camera_grid.h"

namespace widgets {

/// What other people have settled in the open sequence: all raters but the document's, whose repeat round does not
/// count as another person.
std::vector<core::RaterWork> workOfOthers(const AnnotationDocument& document);
/// "anna has 1120 marks in 40 frames of this sequence.", one sentence for each; empty if there are none.
QString othersText(const std::vector<core::RaterWork>& others);

/// Shows the marks that other people have made in the current frame, muted and out of reach, in all camera views.
/// Hidden during a repeat round: a rater who repeats must not see earlier marks.
class OtherMarks : public QObject {
    Q_OBJECT

public:
    OtherMarks(const AnnotationDocument& document, const Selection& selection, const RaterStudy& raters,
               CameraGrid& grid, QObject* parent = nullptr);

    void setShown(bool shown);
    bool isShown() const { return m_shown; }
    /// For new views.
    void refresh();

private:
    const AnnotationDocument& m_document;
    const Selection& m_selection;
    const RaterStudy& m_raters;
    CameraGrid& m_grid;
    bool m_shown = false;
};

} // namespace widgets
