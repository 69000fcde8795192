// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/fitting/joint_problem.h"
#include "core/hand/skeleton.h"
#include "core/numeric/levenberg_marquardt.h"

namespace core {

struct JointFitOptions : JointProblemOptions {
    int maxIterations = 60;
    double minStep = 1e-7; ///< converged when no entry of a step (mm, rad) reaches it
};

struct JointFit {
    Pose pose;
    std::vector<double> residualMm; ///< per target
    double rmsMm = 0;
    SolverSummary summary;
};

/// The rigid part of a pose that brings the joints nearest to their targets while the angles stay as in `pose`: closed
/// form (Umeyama 1991, without scale). No value with fewer than three targets or with targets on a line.
std::optional<Pose> alignedToJoints(const Skeleton& skeleton, const std::vector<JointTarget>& targets,
                                    const Pose& pose);

/// The pose whose bone origins explain annotated joints: minimises JointProblem by Levenberg-Marquardt with box
/// constraints on the angles, from `start` aligned to the targets. A start angle outside its limits is moved onto them
/// first. No value with fewer than three targets or with targets on a line.
std::optional<JointFit> fitPoseToJoints(const Skeleton& skeleton, const std::vector<JointTarget>& targets,
                                        const Pose& start, const JointFitOptions& options = {});

} // namespace core
