// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/annotation/click_sigmas.h"
#include "core/annotation/reconstruction.h"

namespace core {

/// All joints of one frame that have a 3D point.
using JointPoints = std::map<JointId, TriangulatedPoint>;
/// The same for every frame of a sequence in which there are any.
using SequencePoints = std::map<int, JointPoints>;

/// Triangulates everything that one rater has marked.
SequencePoints sequencePoints(const AnnotationSet& set, const std::vector<Camera>& cameras, const std::string& rater,
                              const TriangulationOptions& options = {});

/// Where the joints of a frame are, mm: the mean over the points that its raters' marks give, each by its sigmas.
std::map<JointId, Eigen::Vector3d> meanJointPoints(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                                   int frame, const ClickSigmas& sigmas = {});

} // namespace core
