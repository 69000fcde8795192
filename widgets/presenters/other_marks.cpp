// SPDX-License-Identifier: MIT
#include "widgets/presenters/other_marks.h"

#include <algorithm>
#include <map>

namespace widgets {

std::vector<core::RaterWork> workOfOthers(const AnnotationDocument& document) {
    const std::string own = core::ownRaterName(document.rater());
    std::vector<core::RaterWork> others = core::raterWork(document.annotations());
    std::erase_if(others, [&own](const core::RaterWork& work) { return core::ownRaterName(work.rater) == own; });
    return others;
}

QString othersText(const std::vector<core::RaterWork>& others) {
    QStringList sentences;
    for (const core::RaterWork& work : others)
        sentences << OtherMarks::tr("%1 has %2 in %3 of this sequence.")
                         .arg(QString::fromStdString(work.rater), OtherMarks::tr("%n mark(s)", nullptr, work.marks),
                              OtherMarks::tr("%n frame(s)", nullptr, work.frames));
    return sentences.join(QLatin1Char(' '));
}

OtherMarks::OtherMarks(const AnnotationDocument& document, const Selection& selection, const RaterStudy& raters,
                       CameraGrid& grid, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_selection(selection)
    , m_raters(raters)
    , m_grid(grid) {
    connect(&selection, &Selection::frameChanged, this, &OtherMarks::refresh);
    connect(&selection, &Selection::jointChanged, this, &OtherMarks::refresh);
    connect(&document, &AnnotationDocument::raterChanged, this, &OtherMarks::refresh);
    connect(&document, &AnnotationDocument::opened, this, &OtherMarks::refresh);
    connect(&document, &AnnotationDocument::changed, this, [this](const core::Edit& edit) {
        if (std::any_of(edit.marks.begin(), edit.marks.end(),
                        [this](const auto& change) { return change.key.rater != m_document.rater(); }))
            refresh();
    });
}

void OtherMarks::setShown(bool shown) {
    m_shown = shown;
    refresh();
}

void OtherMarks::refresh() {
    std::map<std::string, std::vector<ViewMark>> byCamera;
    if (m_shown && !m_raters.isRepeating()) {
        const std::string own = core::ownRaterName(m_document.rater());
        for (const auto& [key, mark] : core::marksOfFrame(m_document.annotations(), m_selection.frame())) {
            if (core::ownRaterName(key.rater) == own || !mark.isPlaced())
                continue;
            ViewMark shown;
            shown.joint = key.joint;
            shown.px = QPointF(mark.px.x(), mark.px.y());
            shown.occluded = mark.state == core::MarkState::Occluded;
            shown.label = QString::fromStdString(key.rater);
            shown.named = key.joint == m_selection.joint();
            byCamera[key.camera].push_back(shown);
        }
    }
    for (CameraView* view : m_grid.views())
        view->setOtherMarks(byCamera[view->camera().name]);
}

} // namespace widgets
