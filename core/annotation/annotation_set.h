// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <string_view>
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
enum class Placement {
    Manual,  ///< a person put it there
    Auto,    ///< an accepted reprojection of the joint's own point
    Proposed ///< a guess from elsewhere (another frame, the hand model, a 3D import) that has not been checked yet
};
std::string_view placementName(Placement placement); ///< "manual", "auto", "proposed"
std::optional<Placement> placementFromName(std::string_view name);

enum class MarkState {
    Visible,
    Occluded,   ///< hidden, its place estimated
    Unplaceable ///< cannot be placed in this view; px is meaningless
};

std::string_view stateName(MarkState state); ///< "visible", "occluded", "unplaceable"
std::optional<MarkState> stateFromName(std::string_view name);

/// "left index_mcp"
std::string jointLabel(const JointId& joint);
/// Names for the axis of a figure: "L index mcp".
std::vector<std::string> readableNames(const std::vector<JointId>& joints);

/// One mark. px in recorded image pixels, centres at integers.
struct Mark {
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    Placement placement = Placement::Manual;
    MarkState state = MarkState::Visible;
    /// How sure the program that guessed it was, usually 0..1; a proposal that was accepted keeps it. Empty for what a
    /// person placed, and for accepted reprojections.
    std::optional<double> likelihood = std::nullopt;

    /// px means something.
    bool hasPlace() const { return state != MarkState::Unplaceable; }
    /// A guess that has not been checked yet: neither evidence nor progress, and not exported.
    bool isProposal() const { return hasPlace() && placement == Placement::Proposed; }
    /// A program's guess that a person has accepted where it was.
    bool isAcceptedGuess() const { return hasPlace() && placement == Placement::Auto && likelihood.has_value(); }
    /// A person decided: placed, or cannot be placed.
    bool isSettled() const { return !isProposal(); }
    /// A person placed the joint: by hand, or by accepting its reprojection.
    bool isPlaced() const { return hasPlace() && isSettled(); }
    /// It may enter triangulation and residuals: a person put it there.
    bool isEvidence() const { return isPlaced() && placement == Placement::Manual; }
    bool operator==(const Mark&) const = default;
};

/// All annotations of one sequence: plain data, changed only by edits (edit.h).
struct AnnotationSet {
    std::map<MarkKey, Mark> marks;    ///< ordered by frame first, so a frame is a range
    std::map<int, std::string> notes; ///< per frame, free text
    bool operator==(const AnnotationSet&) const = default;
};

/// The mark at `key`, or nothing ("not done yet").
std::optional<Mark> markAt(const AnnotationSet& set, const MarkKey& key);
/// The note of a frame; empty if it has none.
std::string noteAt(const AnnotationSet& set, int frame);
/// Frames that hold at least one mark, ascending; O(frames * log(marks)).
std::vector<int> annotatedFrames(const AnnotationSet& set);
/// Frames in which that rater has settled at least one mark, ascending.
std::vector<int> settledFrames(const AnnotationSet& set, const std::string& rater);

/// Neighbouring marks of a set, for range-based loops over (key, mark). Valid while the set is not changed.
struct MarkRange {
    std::map<MarkKey, Mark>::const_iterator first, last;
    auto begin() const { return first; }
    auto end() const { return last; }
    bool empty() const { return first == last; }
};
MarkRange marksOfFrame(const AnnotationSet& set, int frame);
MarkRange marksOfFrame(const AnnotationSet& set, int frame, const std::string& rater);
MarkRange marksOfJoint(const AnnotationSet& set, int frame, const std::string& rater, const JointId& joint);
/// The marks of the frames firstFrame..lastFrame, both included.
MarkRange marksOfFrames(const AnnotationSet& set, int firstFrame, int lastFrame);

} // namespace core
