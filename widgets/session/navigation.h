// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>

#include "widgets/document/joint_list.h"
#include "widgets/session/annotation_coverage.h"

namespace widgets {

/// Directions in time.
enum class Direction { Forward, Back };

/// The nearest frame from `frame` (not itself) in which a joint is bad.
std::optional<int> nextBadFrame(const FrameCoverage& coverage, int frame, Direction way);
/// The nearest frame from `frame` (not itself) in which something is placed; proposals do not count.
std::optional<int> nextAnnotatedFrame(const FrameCoverage& coverage, int frame, Direction way);
/// The nearest frame of [0, frameCount) from `frame` (not itself) in which a joint of the list is not done.
std::optional<int> nextUnlabelledFrame(const FrameCoverage& coverage, const JointList& joints, int frameCount,
                                       int frame, Direction way);
/// The nearest of the given frames from `frame` (not itself).
std::optional<int> nextOf(const std::set<int>& frames, int frame, Direction way);

} // namespace widgets
