// SPDX-License-Identifier: MIT
#include "core/annotation/bone_lengths.h"

#include "core/hand/hand_chains.h"
#include "core/numeric/median.h"

namespace core {

std::optional<double> boneLength(const JointPoints& points, const JointId& joint) {
    const std::optional<std::string> previous = previousJoint(joint.joint);
    const auto end = points.find(joint);
    const auto begin = previous ? points.find({joint.hand, *previous}) : points.end();
    if (begin == points.end() || end == points.end())
        return std::nullopt;
    return (end->second.pointInWorld - begin->second.pointInWorld).norm();
}

BoneLengths medianBoneLengths(const SequencePoints& points, int leastFrames) {
    std::map<JointId, std::vector<double>> lengths;
    for (const auto& [frame, joints] : points) {
        for (const auto& [id, point] : joints)
            if (const auto length = boneLength(joints, id))
                lengths[id].push_back(*length);
    }
    BoneLengths medians;
    for (auto& [id, values] : lengths)
        if (static_cast<int>(values.size()) >= leastFrames)
            medians[id] = medianOf(std::move(values));
    return medians;
}

} // namespace core
