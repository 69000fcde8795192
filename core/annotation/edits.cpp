// SPDX-License-Identifier: MIT
#include "core/annotation/edits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/error.h"

namespace core {

namespace {

/// Notes that the mark of `key` becomes `after`, unless it already is that.
void change(Edit& edit, const AnnotationSet& set, const MarkKey& key, const std::optional<Mark>& after) {
    const auto before = markAt(set, key);
    if (before != after)
        edit.marks.push_back({key, before, after});
}

Edit single(const AnnotationSet& set, EditKind kind, const MarkKey& key, const std::optional<Mark>& after) {
    Edit edit{{.kind = kind, .joint = key.joint, .camera = key.camera}, {}, {}};
    change(edit, set, key, after);
    return edit;
}

bool isChosen(const std::optional<std::vector<JointId>>& joints, const JointId& joint) {
    return !joints || std::find(joints->begin(), joints->end(), joint) != joints->end();
}

Edit overFrames(EditKind kind, int first, const std::optional<int>& last = std::nullopt) {
    return {{.kind = kind, .firstFrame = first, .lastFrame = last}, {}, {}};
}

/// Marks for a point in the views that would see it and have no mark yet; older proposals make way.
void addMarks(Edit& edit, const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
              const std::string& rater, const JointPoint& joint, const std::optional<std::string>& onlyCamera,
              Placement placement) {
    for (const Camera& camera : cameras) {
        const MarkKey key{frame, rater, joint.joint, camera.name};
        const auto before = markAt(set, key);
        if ((onlyCamera && *onlyCamera != camera.name) || (before && before->isSettled()))
            continue;
        const auto px = project(camera, joint.pointInWorld);
        const Mark mark{px.value_or(Eigen::Vector2d::Zero()), placement, MarkState::Visible};
        if (px && isInside(camera.size, *px) && before != mark)
            edit.marks.push_back({key, before, mark});
    }
}

/// A guess that waits to be looked at.
void propose(Edit& edit, const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
             const std::string& rater, const JointPoint& joint) {
    addMarks(edit, set, cameras, frame, rater, joint, std::nullopt, Placement::Proposed);
}

std::optional<Eigen::Vector3d> pointOf(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
                                       const std::string& rater, const JointId& joint,
                                       const TriangulationOptions& options) {
    const auto found = reconstruct(set, cameras, frame, rater, joint, {options, false, std::nullopt});
    return found.result.point ? std::optional(found.result.point->pointInWorld) : std::nullopt;
}

} // namespace

Edit placeEdit(const AnnotationSet& set, const MarkKey& key, const Eigen::Vector2d& px) {
    if (!px.allFinite())
        throw Error(ErrorCode::Usage, "", key.camera, "a mark needs a finite pixel position");
    const auto before = markAt(set, key);
    const bool isMove = before && before->isPlaced();
    const bool staysOccluded = before && before->state == MarkState::Occluded;
    return single(set, isMove ? EditKind::Move : EditKind::Place, key,
                  Mark{px, Placement::Manual, staysOccluded ? MarkState::Occluded : MarkState::Visible});
}

Edit removeEdit(const AnnotationSet& set, const MarkKey& key) {
    return single(set, EditKind::Delete, key, std::nullopt);
}

Edit stateEdit(const AnnotationSet& set, const MarkKey& key, MarkState state) {
    std::optional<Mark> mark = markAt(set, key);
    if (state == MarkState::Unplaceable)
        mark = Mark{Eigen::Vector2d::Zero(), Placement::Manual, state};
    else if (mark && mark->hasPlace())
        mark->state = state;
    Edit edit = single(set, EditKind::SetState, key, mark);
    edit.description.state = state;
    return edit;
}

Edit noteEdit(const AnnotationSet& set, int frame, const std::string& text) {
    Edit edit = overFrames(EditKind::Note, frame);
    const auto found = set.notes.find(frame);
    const std::string before = found == set.notes.end() ? std::string() : found->second;
    if (before != text)
        edit.notes.push_back({frame, before, text});
    return edit;
}

Edit acceptEdit(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame, const std::string& rater,
                const JointId& joint, const std::optional<std::string>& camera, const TriangulationOptions& options) {
    Edit edit{{.kind = EditKind::AcceptJoint, .joint = joint, .camera = camera.value_or("")}, {}, {}};
    if (const auto point = pointOf(set, cameras, frame, rater, joint, options))
        addMarks(edit, set, cameras, frame, rater, {joint, *point}, camera, Placement::Auto);
    return edit;
}

Edit acceptFrameEdit(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame, const std::string& rater,
                     const TriangulationOptions& options) {
    Edit edit = overFrames(EditKind::AcceptFrame, frame);
    for (const auto& [id, joint] : reconstructFrame(set, cameras, frame, rater, {options, false, std::nullopt})) {
        if (joint.result.point) {
            addMarks(edit, set, cameras, frame, rater, {id, joint.result.point->pointInWorld}, std::nullopt,
                     Placement::Auto);
        }
    }
    return edit;
}

Edit acceptProposalsEdit(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
                         const std::string& rater, const TriangulationOptions& options) {
    constexpr double kUnknownLikelihood = 0.5; // it tells an accepted proposal from an accepted reprojection
    Edit edit = acceptFrameEdit(set, cameras, frame, rater, options);
    std::set<MarkKey> accepted;
    for (const MarkChange& change : edit.marks)
        accepted.insert(change.key);
    for (const auto& [key, mark] : marksOfFrame(set, frame, rater)) {
        if (!mark.isProposal() || accepted.contains(key))
            continue;
        Mark looked = mark;
        looked.placement = Placement::Auto;
        looked.likelihood = mark.likelihood.value_or(kUnknownLikelihood);
        edit.marks.push_back({key, mark, looked});
    }
    return edit;
}

Edit proposeEdit(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame, const std::string& rater,
                 const std::vector<JointPoint>& joints) {
    Edit edit{{.kind = EditKind::Propose}, {}, {}};
    for (const JointPoint& joint : joints)
        propose(edit, set, cameras, frame, rater, joint);
    return edit;
}

Edit copyPoseEdit(const AnnotationSet& set, const std::vector<Camera>& cameras, int fromFrame, int toFrame,
                  const std::string& rater, const std::optional<std::vector<JointId>>& joints,
                  const TriangulationOptions& options) {
    Edit edit = overFrames(EditKind::CopyPose, fromFrame, toFrame);
    if (fromFrame == toFrame)
        return edit;
    for (const auto& [id, joint] : reconstructFrame(set, cameras, fromFrame, rater, {options, false, std::nullopt}))
        if (joint.result.point && isChosen(joints, id))
            propose(edit, set, cameras, toFrame, rater, {id, joint.result.point->pointInWorld});
    return edit;
}

namespace {

using JointCurves = std::map<JointId, std::map<int, Eigen::Vector3d>>;

/// Frames of the set in [first, last] and the nearest annotated ones on either side, which a cubic needs for its
/// slopes.
std::vector<int> framesAround(const AnnotationSet& set, int first, int last) {
    std::vector<int> frames;
    std::optional<int> below;
    for (const int frame : annotatedFrames(set)) {
        if (frame < first) {
            below = frame;
        } else {
            frames.push_back(frame);
            if (frame > last)
                break;
        }
    }
    if (below)
        frames.insert(frames.begin(), *below);
    return frames;
}

} // namespace

Edit interpolateEdit(const AnnotationSet& set, const std::vector<Camera>& cameras, int firstFrame, int lastFrame,
                     const std::string& rater, Interpolation kind, const std::optional<std::vector<JointId>>& joints,
                     const TriangulationOptions& options) {
    Edit edit = overFrames(EditKind::Interpolate, firstFrame, lastFrame);
    JointCurves curves;
    for (const int frame : framesAround(set, firstFrame, lastFrame)) {
        const bool isOutside = frame < firstFrame || frame > lastFrame;
        if (isOutside && kind == Interpolation::Linear)
            continue;
        for (const auto& [id, joint] : reconstructFrame(set, cameras, frame, rater, {options, false, std::nullopt}))
            if (joint.result.point && isChosen(joints, id))
                curves[id].emplace(frame, joint.result.point->pointInWorld);
    }
    for (const auto& [id, points] : curves) {
        const auto firstInside = points.lower_bound(firstFrame);
        const auto pastInside = points.upper_bound(lastFrame);
        if (firstInside == pastInside)
            continue;
        const int lastInside = std::prev(pastInside)->first;
        for (int frame = firstInside->first + 1; frame < lastInside; ++frame)
            if (!points.contains(frame))
                propose(edit, set, cameras, frame, rater, {id, *interpolated(points, frame, kind)});
    }
    return edit;
}

Edit swapHandsEdit(const AnnotationSet& set, const std::string& rater, int firstFrame,
                   const std::optional<int>& lastFrame) {
    const int last = lastFrame.value_or(std::numeric_limits<int>::max());
    Edit edit = overFrames(EditKind::SwapHands, firstFrame, lastFrame);
    std::set<MarkKey> keys;
    for (const auto& [key, mark] : marksOfFrames(set, firstFrame, last)) {
        if (key.rater == rater) {
            MarkKey other = key;
            other.joint.hand = key.joint.hand == Side::Left ? Side::Right : Side::Left;
            keys.insert(key);
            keys.insert(other);
        }
    }
    for (const MarkKey& key : keys) {
        MarkKey other = key;
        other.joint.hand = key.joint.hand == Side::Left ? Side::Right : Side::Left;
        change(edit, set, key, markAt(set, other));
    }
    return edit;
}

Edit deleteRangeEdit(const AnnotationSet& set, const std::string& rater, int firstFrame, int lastFrame,
                     const std::optional<std::vector<JointId>>& joints) {
    Edit edit = overFrames(EditKind::DeleteRange, firstFrame, lastFrame);
    for (const auto& [key, mark] : marksOfFrames(set, firstFrame, lastFrame))
        if (key.rater == rater && isChosen(joints, key.joint))
            change(edit, set, key, std::nullopt);
    return edit;
}

} // namespace core
