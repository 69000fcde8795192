// SPDX-License-Identifier: MIT
#include "widgets/session/navigation.h"

#include <algorithm>

namespace widgets {

namespace {

template <class Wanted>
std::optional<int> nearestFrame(const FrameCoverage& coverage, int frame, Direction way, Wanted wanted) {
    if (way == Direction::Forward) {
        const auto at = std::find_if(coverage.upper_bound(frame), coverage.end(), wanted);
        return at == coverage.end() ? std::nullopt : std::optional(at->first);
    }
    const auto begin = std::make_reverse_iterator(coverage.lower_bound(frame));
    const auto at = std::find_if(begin, coverage.rend(), wanted);
    return at == coverage.rend() ? std::nullopt : std::optional(at->first);
}

bool isDone(const FrameCoverage& coverage, const JointList& joints, int frame) {
    const auto found = coverage.find(frame);
    if (found == coverage.end())
        return false;
    const auto handDone = [&](core::Side hand) {
        const auto state = found->second.find(hand);
        return (state == found->second.end() ? 0 : state->second.finished()) >= joints.count(hand);
    };
    return handDone(core::Side::Left) && handDone(core::Side::Right);
}

} // namespace

std::optional<int> nextBadFrame(const FrameCoverage& coverage, int frame, Direction way) {
    return nearestFrame(
        coverage, frame, way,
        [](const FrameCoverage::value_type& entry) {
            return std::any_of(
                entry.second.begin(), entry.second.end(), [](const auto& hand) { return hand.second.bad > 0; });
        });
}

std::optional<int> nextAnnotatedFrame(const FrameCoverage& coverage, int frame, Direction way) {
    return nearestFrame(
        coverage, frame, way,
        [](const FrameCoverage::value_type& entry) {
            return std::any_of(
                entry.second.begin(), entry.second.end(), [](const auto& hand) { return hand.second.marked() > 0; });
        });
}

std::optional<int> nextUnlabelledFrame(const FrameCoverage& coverage, const JointList& joints, int frameCount,
                                       int frame, Direction way) {
    const int step = way == Direction::Forward ? 1 : -1;
    for (int next = frame + step; next >= 0 && next < frameCount; next += step)
        if (!isDone(coverage, joints, next))
            return next;
    return std::nullopt;
}

std::optional<int> nextOf(const std::set<int>& frames, int frame, Direction way) {
    if (way == Direction::Forward) {
        const auto at = frames.upper_bound(frame);
        return at == frames.end() ? std::nullopt : std::optional(*at);
    }
    const auto at = frames.lower_bound(frame);
    return at == frames.begin() ? std::nullopt : std::optional(*std::prev(at));
}

} // namespace widgets
