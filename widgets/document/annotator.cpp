// SPDX-License-Identifier: MIT
#include "widgets/document/annotator.h"

#include <algorithm>

#include "core/annotation/edits.h"

namespace widgets {

Annotator::Annotator(AnnotationDocument& document, Selection& selection, Reconstructions& reconstructions,
                     JointList& joints, const ShownCameras& cameras, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_selection(selection)
    , m_reconstructions(reconstructions)
    , m_joints(joints)
    , m_cameras(cameras) {
    connect(
        &document, &AnnotationDocument::opened, this, [this] { m_finished.clear(); });
}

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

/// Remembers that the selected joint is done as it is now: whatever follows corrects it.
void Annotator::noteIfFinished() {
    if (m_reconstructions.selected().status == core::JointStatus::Done)
        m_finished.insert(keyFor({}, m_selection.joint()));
}

void Annotator::pushAndAdvance(const core::Edit& edit) {
    m_placeFinished = false;
    if (edit.empty())
        return;
    m_nudged.reset();
    noteIfFinished();
    const bool isCorrection = m_finished.contains(keyFor({}, m_selection.joint()));
    m_document.amend(edit, ++m_step);
    const core::JointReconstruction& selected = m_reconstructions.selected();
    const bool isInDoubt = selected.manualViews > 1 && !selected.hasPoint(); // clicks that disagree: stay, and see why
    if (isCorrection || isInDoubt || selected.status != core::JointStatus::Done)
        return;
    noteIfFinished();
    m_placeFinished = true;
    if (m_autoAdvance && m_joints.contains(m_selection.joint()))
        stepJoint(1);
}

/// True, and why is said, where the joint cannot be seen.
bool Annotator::refusesPlace(const std::string& camera, const Eigen::Vector2d& px) {
    const auto* view = selectedIn(camera);
    const int index = m_dataset ? m_dataset->cameraIndex(camera) : -1;
    if (!view || index < 0)
        return false;
    if (!view->hasPicture) {
        emit nothingDone(
            tr("Nothing was placed: %1 has no picture of this frame.").arg(QString::fromStdString(camera)));
        return true;
    }
    if (core::isInside(m_dataset->cameras[static_cast<std::size_t>(index)].size, px))
        return false;
    emit nothingDone(tr("Nothing was placed: this is outside the picture of %1.").arg(QString::fromStdString(camera)));
    return true;
}

/// The nearest pixel centre's place within the picture: from 0 to size - 1.
Eigen::Vector2d Annotator::withinPicture(const std::string& camera, const Eigen::Vector2d& px) const {
    const int index = m_dataset ? m_dataset->cameraIndex(camera) : -1;
    if (index < 0)
        return px;
    const core::ImageSize& size = m_dataset->cameras[static_cast<std::size_t>(index)].size;
    return px.cwiseMin(Eigen::Vector2d(size.width - 1, size.height - 1)).cwiseMax(0);
}

/// Without the marks in views that have no picture of the frame.
core::Edit Annotator::whereThereArePictures(core::Edit edit) const {
    std::erase_if(edit.marks, [this](const core::MarkChange& change) {
        const auto* view = selectedIn(change.key.camera);
        return view && !view->hasPicture;
    });
    return edit;
}

void Annotator::place(const std::string& camera, const Eigen::Vector2d& px) {
    if (!m_document.isOpen() || m_selection.joint().joint.empty())
        return;
    m_lastPlaced = {};
    if (refusesPlace(camera, px))
        return;
    m_selection.setCamera(camera);
    m_jointBeforePlace = m_selection.joint();
    m_lastPlaced = core::placeEdit(m_document.annotations(), currentKey(), withinPicture(camera, px));
    pushAndAdvance(m_lastPlaced);
}

void Annotator::withdrawPlace() {
    if (m_lastPlaced.empty())
        return;
    m_document.amend(core::inverse(m_lastPlaced), m_step);
    m_lastPlaced = {};
    if (m_placeFinished)
        m_finished.erase(keyFor({}, m_jointBeforePlace));
    m_selection.setJoint(m_jointBeforePlace);
}

void Annotator::drag(const std::string& camera, const core::JointId& joint, const Eigen::Vector2d& px) {
    m_selection.setCamera(camera);
    m_selection.setJoint(joint);
    m_document.preview(core::placeEdit(m_document.annotations(), keyFor(camera, joint), withinPicture(camera, px)));
}

void Annotator::drop(const std::string& camera, const core::JointId& joint, const Eigen::Vector2d& px) {
    m_document.clearPreview();
    m_selection.setCamera(camera);
    m_selection.setJoint(joint);
    m_lastPlaced = {};
    if (refusesPlace(camera, px))
        return;
    noteIfFinished();
    m_nudged.reset();
    m_document.amend(core::placeEdit(m_document.annotations(), keyFor(camera, joint), withinPicture(camera, px)),
                     ++m_step);
    noteIfFinished();
}

void Annotator::cancelDrag() {
    m_document.clearPreview();
}

QString Annotator::nothingToAcceptText() const {
    const QString joint = QString::fromStdString(m_selection.joint().joint);
    const core::JointReconstruction& selected = m_reconstructions.selected();
    if (selected.hasPoint())
        return tr("Every view that sees %1 has a mark of it.").arg(joint);
    return selected.manualViews < 2 ? tr("Nothing to accept: click %1 in two views first.").arg(joint)
                                    : tr("Nothing to accept: the clicks of %1 give no 3D point.").arg(joint);
}

void Annotator::accept() {
    if (!m_dataset)
        return;
    const auto canAccept = [&](const std::string& camera) {
        const auto* view = selectedIn(camera);
        const bool isFree = view && !(view->mark && view->mark->isSettled());
        return isFree && view->hasPicture && view->reprojectionPx && view->reprojectionInside;
    };
    auto order = m_cameras.names();
    const auto current = std::find(order.begin(), order.end(), m_selection.camera());
    if (current != order.end())
        std::rotate(order.begin(), current, order.end());
    const auto target = std::find_if(order.begin(), order.end(), canAccept);
    if (target == order.end()) {
        emit nothingDone(nothingToAcceptText());
        return;
    }
    m_selection.setCamera(*target);
    pushAndAdvance(core::acceptEdit(m_document.annotations(), m_dataset->cameras, m_selection.frame(),
                                    m_document.rater(), m_selection.joint(), *target, m_reconstructions.options()));
}

void Annotator::acceptAllViews() {
    if (!m_dataset)
        return;
    const core::Edit edit = whereThereArePictures(
        core::acceptEdit(m_document.annotations(), m_dataset->cameras, m_selection.frame(), m_document.rater(),
                         m_selection.joint(), std::nullopt, m_reconstructions.options()));
    if (edit.empty())
        emit nothingDone(nothingToAcceptText());
    pushAndAdvance(edit);
}

void Annotator::acceptFrame() {
    if (!m_dataset)
        return;
    const core::Edit edit =
        whereThereArePictures(core::acceptFrameEdit(m_document.annotations(), m_dataset->cameras, m_selection.frame(),
                                                    m_document.rater(), m_reconstructions.options()));
    if (edit.empty())
        emit nothingDone(tr("Nothing to accept in this frame: no joint with a 3D point has a view left that sees it."));
    pushAndAdvance(edit);
}

bool Annotator::acceptProposals() {
    if (!m_dataset)
        return false;
    const core::Edit edit = whereThereArePictures(
        core::acceptProposalsEdit(m_document.annotations(), m_dataset->cameras, m_selection.frame(), m_document.rater(),
                                  m_reconstructions.options()));
    if (edit.empty())
        emit nothingDone(tr("Nothing waits to be accepted in this frame."));
    m_nudged.reset();
    m_document.push(edit);
    return !edit.empty();
}

void Annotator::remove() {
    const core::Edit edit = core::removeEdit(m_document.annotations(), currentKey());
    if (edit.empty())
        emit nothingDone(
            tr("There is no mark of %1 in this view.").arg(QString::fromStdString(m_selection.joint().joint)));
    m_nudged.reset();
    noteIfFinished();
    m_document.push(edit);
}

void Annotator::removeInAllViews() {
    const core::Edit edit = core::deleteRangeEdit(m_document.annotations(), m_document.rater(), m_selection.frame(),
                                                  m_selection.frame(), std::vector{m_selection.joint()});
    if (edit.empty())
        emit nothingDone(
            tr("There is no mark of %1 in this frame.").arg(QString::fromStdString(m_selection.joint().joint)));
    m_nudged.reset();
    noteIfFinished();
    m_document.push(edit);
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
    noteIfFinished();
    if (mark && mark->state == core::MarkState::Unplaceable)
        m_document.push(core::removeEdit(m_document.annotations(), currentKey()));
    else
        pushAndAdvance(core::stateEdit(m_document.annotations(), currentKey(), core::MarkState::Unplaceable));
}

void Annotator::nudge(const Eigen::Vector2d& byPx) {
    const core::MarkKey key = currentKey();
    const auto mark = core::markAt(m_document.annotations(), key);
    const auto* view = selectedIn(key.camera);
    const bool isShownElsewhere =
        mark && mark->isProposal() && view && view->reprojectionPx; // a guess gives way to what the clicks say
    if (!mark || !mark->hasPlace()) {
        emit nothingDone(tr("There is no mark of %1 in this view.").arg(QString::fromStdString(key.joint.joint)));
        return;
    }
    const Eigen::Vector2d from = isShownElsewhere ? *view->reprojectionPx : mark->px;
    const Eigen::Vector2d to = withinPicture(key.camera, from + byPx);
    if (to == from) {
        emit nothingDone(tr("The mark is at the edge of the picture."));
        return;
    }
    noteIfFinished();
    if (m_nudged != key)
        ++m_step;
    m_nudged = key;
    m_document.amend(core::placeEdit(m_document.annotations(), key, to), m_step);
}

void Annotator::stepFrame(int frames) {
    m_selection.setFrame(m_selection.frame() + frames);
}

void Annotator::stepJoint(int joints) {
    m_selection.setJoint(m_joints.neighbour(m_selection.joint(), joints));
}

void Annotator::stepCamera(int views) {
    const std::vector<std::string>& names = m_cameras.names();
    if (names.empty())
        return;
    const auto at = std::find(names.begin(), names.end(), m_selection.camera());
    const int size = static_cast<int>(names.size());
    const int index = at == names.end() ? (views > 0 ? -1 : 0) : static_cast<int>(at - names.begin());
    m_selection.setCamera(names[static_cast<std::size_t>((index + views % size + size) % size)]);
}

} // namespace widgets
