// SPDX-License-Identifier: MIT
#include "core/fitting/known_joints.h"

#include <limits>

namespace core {

namespace {

/// Targets alone: no prior on the angles, no limits.
JointProblem problemOf(const Skeleton& skeleton, const std::vector<JointTarget>& joints, const Pose& pose) {
    JointProblemOptions options;
    options.modelSigmaMm = 1;
    options.priorSigmaRad = std::numeric_limits<double>::infinity();
    options.withLimits = false;
    return {skeleton, joints, pose, options};
}

} // namespace

KnownJointEquations knownJointEquations(const Skeleton& skeleton, const std::vector<JointTarget>& joints,
                                        const Pose& pose) {
    KnownJointEquations equations;
    problemOf(skeleton, joints, pose).linearise(pose, equations.hessian, equations.gradient);
    return equations;
}

double knownJointMisfit(const std::vector<HandModel>& hands, const KnownJoints& known, const HandPoses& poses) {
    double sum = 0;
    for (std::size_t h = 0; h < known.size() && h < hands.size(); ++h)
        if (!known[h].empty())
            sum += 2 * problemOf(hands[h].skeleton, known[h], poses[h]).cost(poses[h]);
    return sum;
}

} // namespace core
