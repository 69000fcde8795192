// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/annotation/edit.h"
#include "core/annotation/interpolation.h"
#include "core/annotation/reconstruction.h"

/// Factories of edits. None of them changes the set: each returns what an annotator's step would change, as one undo
/// step, and an empty edit if it would change nothing.
namespace core {

/// Places a manual mark at `px`, or moves the one that is there. An occluded mark stays occluded; an auto mark becomes
/// manual (the annotator has put it there); an unplaceable one becomes visible. Throws Error(Usage) if px is not
/// finite.
Edit placeEdit(const AnnotationSet& set, const MarkKey& key, const Eigen::Vector2d& px);
/// Takes the mark away: the view is "not done yet" again.
Edit removeEdit(const AnnotationSet& set, const MarkKey& key);
/// Sets the state. Visible and Occluded need a mark there (otherwise the edit is empty); Unplaceable does not, and its
/// px is 0, 0.
Edit stateEdit(const AnnotationSet& set, const MarkKey& key, MarkState state);
/// Replaces the note of a frame; an empty text takes it away.
Edit noteEdit(const AnnotationSet& set, int frame, const std::string& text);

/// Accepts the reprojection of the joint's point as an auto mark in `camera`, or with no camera in every view; only
/// views without a mark (a proposed mark makes way) and whose image contains the reprojection. Empty while
/// there is no point.
Edit acceptEdit(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame, const std::string& rater,
                const JointId& joint, const std::optional<std::string>& camera = std::nullopt,
                const TriangulationOptions& options = {});
/// acceptEdit in every view for every joint of the frame.
Edit acceptFrameEdit(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame, const std::string& rater,
                     const TriangulationOptions& options = {});

/// acceptFrameEdit for joints that have a point; where a joint has proposals alone, they become auto marks where they
/// are and keep their likelihoods (0.5 if there is none): a person has looked at them.
Edit acceptProposalsEdit(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
                         const std::string& rater, const TriangulationOptions& options = {});

/// A joint with a place in the world, mm.
struct JointPoint {
    JointId joint;
    Eigen::Vector3d pointInWorld;
};
/// Puts given 3D joints into a frame as proposed marks: only views without a mark whose image contains the
/// projection. For proposals of a hand model and for imports of 3D joints.
Edit proposeEdit(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame, const std::string& rater,
                 const std::vector<JointPoint>& joints);

/// Copies the 3D joints that `rater` has in `fromFrame` (all of them, or only `joints`) to `toFrame`, as proposed
/// marks.
Edit copyPoseEdit(const AnnotationSet& set, const std::vector<Camera>& cameras, int fromFrame, int toFrame,
                  const std::string& rater, const std::optional<std::vector<JointId>>& joints = std::nullopt,
                  const TriangulationOptions& options = {});

/// Interpolates each joint in 3D between the frames of [firstFrame, lastFrame] in which it has a point, and puts it as
/// proposed marks into the frames between them; never extrapolates. Cubic also uses the nearest such frame on either
/// side of the range.
Edit interpolateEdit(const AnnotationSet& set, const std::vector<Camera>& cameras, int firstFrame, int lastFrame,
                     const std::string& rater, Interpolation kind,
                     const std::optional<std::vector<JointId>>& joints = std::nullopt,
                     const TriangulationOptions& options = {});

/// Exchanges left and right in all marks of `rater` from `firstFrame` to the last annotated frame (or to `lastFrame`).
Edit swapHandsEdit(const AnnotationSet& set, const std::string& rater, int firstFrame,
                   const std::optional<int>& lastFrame = std::nullopt);
/// Deletes the marks of `rater` in the frames firstFrame..lastFrame (inclusive), of all joints or only of `joints`.
Edit deleteRangeEdit(const AnnotationSet& set, const std::string& rater, int firstFrame, int lastFrame,
                     const std::optional<std::vector<JointId>>& joints = std::nullopt);

} // namespace core
