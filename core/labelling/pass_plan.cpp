// SPDX-License-Identifier: MIT
#include "core/labelling/pass_plan.h"

#include <algorithm>
#include <cstdlib>

namespace core {

std::vector<int> keyFrames(const std::vector<int>& frames, int every) {
    std::vector<int> keys;
    for (const int frame : frames)
        if (keys.empty() || frame - keys.back() >= every)
            keys.push_back(frame);
    if (!frames.empty() && keys.back() != frames.back())
        keys.push_back(frames.back());
    return keys;
}

std::vector<int> evenlyDrawn(const std::vector<int>& values, std::size_t most) {
    const std::size_t count = std::min(values.size(), most);
    std::vector<int> drawn;
    for (std::size_t i = 0; i < count; ++i)
        drawn.push_back(values[(2 * i + 1) * values.size() / (2 * count)]);
    return drawn;
}

HandPoses predictedPoses(const HandPoses& last, const HandPoses& before, double share) {
    HandPoses poses = last;
    for (std::size_t h = 0; h < poses.size() && h < before.size(); ++h) {
        if (last[h].size() == 0 || before[h].size() != last[h].size())
            continue;
        Eigen::VectorXd step = last[h] - before[h];
        step.segment<3>(3) =
            rotationLog(rotationExp(last[h].segment<3>(3)) * rotationExp(before[h].segment<3>(3)).transpose());
        poses[h] = retract(last[h], share * step);
    }
    return poses;
}

std::optional<int> nextFrame(const std::vector<int>& frames, int frame, int direction, int mostGapFrames) {
    const auto after = std::upper_bound(frames.begin(), frames.end(), frame);
    const auto from = std::lower_bound(frames.begin(), frames.end(), frame);
    if (direction > 0 ? after == frames.end() : from == frames.begin())
        return std::nullopt;
    const int next = direction > 0 ? *after : *(from - 1);
    return std::abs(next - frame) <= mostGapFrames ? std::optional(next) : std::nullopt;
}

void TrackQueue::add(int frame, double doubt, int direction) {
    for (const int way : {1, -1})
        if (const auto to = direction == -way ? std::nullopt : nextFrame(m_frames, frame, way, m_mostGapFrames))
            m_steps.push_back({frame, *to, way, doubt});
}

std::optional<TrackStep> TrackQueue::next() {
    if (m_steps.empty())
        return std::nullopt;
    const auto surest = std::min_element(m_steps.begin(), m_steps.end(),
                                         [](const TrackStep& a, const TrackStep& b) { return a.doubt < b.doubt; });
    const TrackStep step = *surest;
    m_steps.erase(surest);
    return step;
}

} // namespace core
