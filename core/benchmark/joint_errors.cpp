// SPDX-License-Identifier: MIT
#include "core/benchmark/joint_errors.h"

#include <cmath>
#include <limits>

namespace core {

double toMillionths(double value) {
    return std::round(value * 1e6) / 1e6;
}

std::vector<JointId> jointNames(const std::vector<HandModel>& hands) {
    std::vector<JointId> joints;
    for (const HandModel& hand : hands)
        for (const Bone& bone : hand.skeleton.bones)
            joints.push_back({hand.side, bone.name});
    return joints;
}

JointPositions namedJointPositions(const std::vector<HandModel>& hands, const HandPoses& poses) {
    JointPositions joints;
    for (std::size_t h = 0; h < hands.size() && h < poses.size(); ++h) {
        if (poses[h].size() == 0)
            continue;
        const std::vector<Eigen::Vector3d> positions = jointPositions(hands[h].skeleton, poses[h]);
        for (std::size_t b = 0; b < positions.size(); ++b)
            joints[{hands[h].side, hands[h].skeleton.bones[b].name}] = positions[b];
    }
    return joints;
}

JointErrors jointErrors(const std::vector<JointId>& joints, const JointPositions& estimate,
                        const JointPositions& reference) {
    JointErrors errors;
    double sum = 0;
    int count = 0;
    for (const JointId& id : joints) {
        const auto found = estimate.find(id);
        const auto truth = reference.find(id);
        if (found == estimate.end() || truth == reference.end()) {
            errors.perJointMm.push_back(std::numeric_limits<double>::quiet_NaN());
            continue;
        }
        const double errorMm = (found->second - truth->second).norm();
        errors.perJointMm.push_back(toMillionths(errorMm));
        sum += errorMm;
        ++count;
    }
    errors.meanMm = count > 0 ? toMillionths(sum / count) : std::numeric_limits<double>::quiet_NaN();
    return errors;
}

} // namespace core
