// SPDX-License-Identifier: MIT
#include "widgets/document/annotator.h"

#include <algorithm>

#include "core/annotation/edits.h"

namespace widgets {

Annotator::Annotator(AnnotationDocument& document, Selection& selection, Reconstructions& reconstructions, JointList& joints,
                     QObject* parent)
    : QObject(parent), m_document(document), m_selection(selection), m_reconstructions(reconstructions), m_joints(joints) {}

core::MarkKey Annotator::keyFor(const std::string& camera, const core::JointId& joint) const {
    return {m_selection.frame(), m_document.rater(), joint, camera};
}

core::MarkKey Annotator::currentKey() const {
    return keyFor(m_selection.camera(), m_selection.joint());
}

const core::ViewReconstruction* Annotator::selectedIn(const std::string& camera) const {
    const auto& views = m_reconstructions.selected().views;
    const auto at = std::find_if(views.begin(), views.end(), [&](const auto& view) { return view.camera == camera; });
    return at == views.end() ? nullptr : &*at;
}

void Annotator::pushAndAdvance(const core::Edit& edit) {
    if (edit.empty())
        return;
    m_nudged.reset();
    m_document.amend(edit, ++m_step);
    const core::JointReconstruction& selected = m_reconstructions.selected();
    const bool isInDoubt = selected.manualViews > 1 && !selected.hasPoint(); // clicks that disagree: stay, and see why
    if (m_autoAdvance && selected.status == core::JointStatus::Done && !isInDoubt && m_joints.contains(m_selection.joint()))
        stepJoint(1);
}

void Annotator::place(const std::string& camera, const Eigen::Vector2d& px) {
    if (!m_document.isOpen() || m_selection.joint().joint.empty())
        return;
    m_selection.setCamera(camera);
    m_jointBeforePlace = m_selection.joint();
    m_lastPlaced = core::placeEdit(m_document.annotations(), currentKey(), px);
    pushAndAdvance(m_lastPlaced);
}

void Annotator::withdrawPlace() {
    if (m_lastPlaced.empty())
        return;
    m_document.amend(core::inverse(m_lastPlaced), m_step);
    m_lastPlaced = {};
    m_selection.setJoint(m_jointBeforePlace);
}

void Annotator::drag(const std::string& camera, const core::JointId& joint, const Eigen::Vector2d& px) {
    m_selection.setCamera(camera);
    m_selection.setJoint(joint);
    m_document.preview(core::placeEdit(m_document.annotations(), keyFor(camera, joint), px));
}

void Annotator::drop(const std::string& camera, const core::JointId& joint, const Eigen::Vector2d& px) {
    m_document.clearPreview();
    m_selection.setCamera(camera);
    m_selection.setJoint(joint);
    m_lastPlaced = {};
    pushAndAdvance(core::placeEdit(m_document.annotations(), keyFor(camera, joint), px));
}

void Annotator::cancelDrag() {
    m_document.clearPreview();
}

void Annotator::accept() {
    if (!m_dataset)
        return;
    const auto canAccept = [&](const std::string& camera) {
        const auto* view = selectedIn(camera);
        const bool isFree = view && !(view->mark && view->mark->isSettled());
        return isFree && view->reprojectionPx && view->reprojectionInside;
    };
    const auto current = std::find(m_cameraOrder.begin(), m_cameraOrder.end(), m_selection.camera());
    auto order = m_cameraOrder;
    if (current != m_cameraOrder.end())
        std::rotate(order.begin(), order.begin() + (current - m_cameraOrder.begin()), order.end());
    const auto target = std::find_if(order.begin(), order.end(), canAccept);
    if (target == order.end()) {
        emit nothingDone(tr("Nothing to accept: click %1 in two views first.")
                             .arg(QString::fromStdString(m_selection.joint().joint)));
        return;
    }
    m_selection.setCamera(*target);
    pushAndAdvance(core::acceptEdit(m_document.annotations(), m_dataset->cameras, m_selection.frame(), m_document.rater(),
                                    m_selection.joint(), *target, m_reconstructions.options()));
}

void Annotator::acceptAllViews() {
    if (!m_dataset)
        return;
    const core::Edit edit = core::acceptEdit(m_document.annotations(), m_dataset->cameras, m_selection.frame(), m_document.rater(), m_selection.joint(),
                                             std::nullopt, m_reconstructions.options());
    if (edit.empty())
        emit nothingDone(m_reconstructions.selected().hasPoint()
                             ? tr("Every view that sees %1 has a mark of it.").arg(QString::fromStdString(m_selection.joint().joint))
                             : tr("Nothing to accept: click %1 in two views first.").arg(QString::fromStdString(m_selection.joint().joint)));
    pushAndAdvance(edit);
}

void Annotator::acceptFrame() {
    if (m_dataset)
        pushAndAdvance(core::acceptFrameEdit(m_document.annotations(), m_dataset->cameras, m_selection.frame(),
                                             m_document.rater(), m_reconstructions.options()));
}

void Annotator::remove() {
    const core::Edit edit = core::removeEdit(m_document.annotations(), currentKey());
    if (edit.empty())
        emit nothingDone(tr("There is no mark of %1 in this view.").arg(QString::fromStdString(m_selection.joint().joint)));
    m_nudged.reset();
    m_document.push(edit);
}

void Annotator::removeInAllViews() {
    m_nudged.reset();
    m_document.push(core::deleteRangeEdit(m_document.annotations(), m_document.rater(), m_selection.frame(),
                                          m_selection.frame(), std::vector{m_selection.joint()}));
}

void Annotator::toggleOccluded() {
    if (!m_dataset || m_selection.camera().empty())
        return;
    core::Edit edit;
    core::AnnotationSet set;
    const auto mark = core::markAt(m_document.annotations(), currentKey());
    if (!mark || mark->isProposal()) {
        edit = core::acceptEdit(m_document.annotations(), m_dataset->cameras, m_selection.frame(), m_document.rater(),
                                m_selection.joint(), m_selection.camera(), m_reconstructions.options());
        if (edit.empty()) {
            emit nothingDone(tr("Click the place where the joint is hidden, then mark it as occluded."));
            return;
        }
        edit.marks.front().after->state = core::MarkState::Occluded;
    } else {
        const bool occluded = mark->state == core::MarkState::Occluded;
        edit = core::stateEdit(m_document.annotations(), currentKey(),
                               occluded ? core::MarkState::Visible : core::MarkState::Occluded);
    }
    pushAndAdvance(edit);
}

void Annotator::toggleUnplaceable() {
    if (m_selection.camera().empty())
        return;
    const auto mark = core::markAt(m_document.annotations(), currentKey());
    if (mark && mark->state == core::MarkState::Unplaceable)
        m_document.push(core::removeEdit(m_document.annotations(), currentKey()));
    else
        pushAndAdvance(core::stateEdit(m_document.annotations(), currentKey(), core::MarkState::Unplaceable));
}

void Annotator::nudge(const Eigen::Vector2d& byPx) {
    const core::MarkKey key = currentKey();
    const auto mark = core::markAt(m_document.annotations(), key);
    const auto* view = selectedIn(key.camera);
    const bool isShownElsewhere = mark && mark->isProposal() && view && view->reprojectionPx; // a guess gives way to what the clicks say
    if (!mark || !mark->hasPlace()) {
        emit nothingDone(tr("There is no mark of %1 in this view.").arg(QString::fromStdString(key.joint.joint)));
        return;
    }
    if (m_nudged != key)
        ++m_step;
    m_nudged = key;
    m_document.amend(core::placeEdit(m_document.annotations(), key, (isShownElsewhere ? *view->reprojectionPx : mark->px) + byPx), m_step);
}

void Annotator::stepFrame(int frames) {
    m_selection.setFrame(m_selection.frame() + frames);
}

void Annotator::stepJoint(int joints) {
    m_selection.setJoint(m_joints.neighbour(m_selection.joint(), joints));
}

void Annotator::stepCamera(int views) {
    if (m_cameraOrder.empty())
        return;
    const auto at = std::find(m_cameraOrder.begin(), m_cameraOrder.end(), m_selection.camera());
    const int size = static_cast<int>(m_cameraOrder.size());
    const int index = at == m_cameraOrder.end() ? (views > 0 ? -1 : 0) : static_cast<int>(at - m_cameraOrder.begin());
    m_selection.setCamera(m_cameraOrder[static_cast<std::size_t>((index + views % size + size) % size)]);
}

} // namespace widgets
