// SPDX-License-Identifier: MIT
#include "core/annotation/annotation_set.h"

#include <algorithm>

#include <limits>

namespace core {

std::string_view placementName(Placement placement) {
    switch (placement) {
    case Placement::Manual:
        return "manual";
    case Placement::Auto:
        return "auto";
    case Placement::Proposed:
        break;
    }
    return "proposed";
}

std::optional<Placement> placementFromName(std::string_view name) {
    for (const Placement placement : {Placement::Manual, Placement::Auto, Placement::Proposed})
        if (placementName(placement) == name)
            return placement;
    return std::nullopt;
}

std::string_view stateName(MarkState state) {
    switch (state) {
    case MarkState::Visible:
        return "visible";
    case MarkState::Occluded:
        return "occluded";
    case MarkState::Unplaceable:
        break;
    }
    return "unplaceable";
}

std::optional<MarkState> stateFromName(std::string_view name) {
    for (const MarkState state : {MarkState::Visible, MarkState::Occluded, MarkState::Unplaceable})
        if (stateName(state) == name)
            return state;
    return std::nullopt;
}

std::string jointLabel(const JointId& joint) {
    return std::string(sideName(joint.hand)) + " " + joint.joint;
}

std::vector<std::string> readableNames(const std::vector<JointId>& joints) {
    std::vector<std::string> names;
    for (const JointId& joint : joints) {
        names.push_back((joint.hand == Side::Left ? "L " : "R ") + joint.joint);
        std::replace(names.back().begin(), names.back().end(), '_', ' ');
    }
    return names;
}

std::optional<Mark> markAt(const AnnotationSet& set, const MarkKey& key) {
    const auto found = set.marks.find(key);
    return found == set.marks.end() ? std::nullopt : std::optional(found->second);
}

std::string noteAt(const AnnotationSet& set, int frame) {
    const auto found = set.notes.find(frame);
    return found == set.notes.end() ? std::string() : found->second;
}

std::vector<int> annotatedFrames(const AnnotationSet& set) {
    std::vector<int> frames;
    for (auto mark = set.marks.begin(); mark != set.marks.end();) {
        frames.push_back(mark->first.frame);
        mark = marksOfFrame(set, mark->first.frame).last;
    }
    return frames;
}

std::vector<int> settledFrames(const AnnotationSet& set, const std::string& rater) {
    std::vector<int> frames = annotatedFrames(set);
    std::erase_if(frames, [&](int frame) {
        const MarkRange marks = marksOfFrame(set, frame, rater);
        return std::none_of(marks.begin(), marks.end(), [](const auto& item) { return item.second.isSettled(); });
    });
    return frames;
}

namespace {

// Empty strings and Side::Left sort before everything else, so these are the lowest keys of their kind. A string's
// successor is itself with a NUL appended.
std::string successor(std::string text) {
    text.push_back('\0');
    return text;
}

} // namespace

MarkRange marksOfFrames(const AnnotationSet& set, int firstFrame, int lastFrame) {
    if (lastFrame < firstFrame)
        return {set.marks.end(), set.marks.end()};
    const auto first = set.marks.lower_bound({.frame = firstFrame, .rater = {}, .joint = {}, .camera = {}});
    auto last = first;
    if (lastFrame < std::numeric_limits<int>::max())
        last = set.marks.lower_bound({.frame = lastFrame + 1, .rater = {}, .joint = {}, .camera = {}});
    else
        last = set.marks.end();
    return {first, last};
}

MarkRange marksOfFrame(const AnnotationSet& set, int frame) {
    return marksOfFrames(set, frame, frame);
}

MarkRange marksOfFrame(const AnnotationSet& set, int frame, const std::string& rater) {
    return {set.marks.lower_bound({.frame = frame, .rater = rater, .joint = {}, .camera = {}}),
            set.marks.lower_bound({.frame = frame, .rater = successor(rater), .joint = {}, .camera = {}})};
}

MarkRange marksOfJoint(const AnnotationSet& set, int frame, const std::string& rater, const JointId& joint) {
    return {set.marks.lower_bound({.frame = frame, .rater = rater, .joint = joint, .camera = {}}),
            set.marks.lower_bound(
                {.frame = frame, .rater = rater, .joint = {joint.hand, successor(joint.joint)}, .camera = {}})};
}

} // namespace core
