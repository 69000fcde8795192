// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/hand/skeleton.h"

namespace core {

/// Which joint of which hand.
struct JointId {
    Side hand = Side::Left;
    std::string joint; ///< standard name such as index_mcp
    auto operator<=>(const JointId&) const = default;
};

/// Address of one mark: what one rater says of one joint in one camera of one frame.
struct MarkKey {
    int frame = 0;
    std::string rater;
    JointId joint;
    std::string camera;
    auto operator<=>(const MarkKey&) const = default;
};

/// How a mark came to be. Only manual marks are evidence.
enum class Placement { Manual, Auto };
enum class MarkState {
    Visible,
    Occluded,   ///< hidden, its place estimated
    Unplaceable ///< cannot be placed in this view; px is meaningless
};

/// One mark. px in recorded image pixels, centres at integers.
struct Mark {
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    Placement placement = Placement::Manual;
    MarkState state = MarkState::Visible;
    bool operator==(const Mark&) const = default;
};

/// All annotations of one sequence: plain data, changed only by edits (edit.h).
struct AnnotationSet {
    std::map<MarkKey, Mark> marks;      ///< ordered by frame first, so a frame is a range
    std::map<int, std::string> notes;   ///< per frame, free text
    bool operator==(const AnnotationSet&) const = default;
};

/// The mark at `key`, or nothing ("not done yet").
std::optional<Mark> markAt(const AnnotationSet& set, const MarkKey& key);
/// Frames that hold at least one mark, ascending.
std::vector<int> annotatedFrames(const AnnotationSet& set);

} // namespace core
