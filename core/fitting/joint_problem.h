// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/hand/hand_model.h"
#include "core/hand/skeleton.h"
#include "core/numeric/levenberg_marquardt.h"

namespace core {

/// Where a joint was annotated, and how surely.
struct JointTarget {
    int bone = 0;                 ///< whose origin it is
    Eigen::Vector3d pointInWorld; ///< mm
    Eigen::Matrix3d covariance;   ///< mm^2, positive definite
};

struct JointProblemOptions {
    double modelSigmaMm = 1.5;  ///< how far the model's joints are from the person's, added to every covariance
    double priorSigmaRad = 0.6; ///< how far angles are expected from those of the start: decides what no target does
    bool withLimits = true;     ///< angles stay within the skeleton's limits
};

/// Annotated joints as a least-squares problem over poses:
/// 1/2 sum_i (b_i(x) - y_i)^T (C_i + sigma_m^2 I)^-1 (b_i(x) - y_i) + 1/2 |angles(x) - angles(start)|^2 / sigma_p^2,
/// b_i the origin of bone i, y_i and C_i its target. The Jacobian of b_i is exact in every pose (retract's tangent
/// step).
class JointProblem {
public:
    /// `skeleton` and `targets` must outlive the problem.
    JointProblem(const Skeleton& skeleton, const std::vector<JointTarget>& targets, const Pose& start,
                 const JointProblemOptions& options);

    double cost(const Pose& pose) const;
    void linearise(const Pose& pose, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const;
    Pose retract(const Pose& pose, const Eigen::VectorXd& step) const { return core::retract(pose, step); }
    /// Steps stay within the limits of the angles; without limits every step is allowed.
    StepBox stepBox(const Pose& pose) const;

    /// Per target, |b_i - y_i| in mm.
    std::vector<double> distancesMm(const Pose& pose) const;

private:
    Eigen::Vector3d residualOf(std::size_t target, const std::vector<Eigen::Vector3d>& joints) const;
    Eigen::VectorXd anglesFromStart(const Pose& pose) const;

    const Skeleton& m_skeleton;
    const std::vector<JointTarget>& m_targets;
    Pose m_start;
    bool m_withLimits;
    double m_priorWeight;                       ///< 1 / sigma_p^2
    std::vector<Eigen::Matrix3d> m_information; ///< (C_i + sigma_m^2 I)^-1
};

/// Joints that are known beside the silhouettes, such as those that a person has placed, per hand. Fewer lists than
/// hands: nothing is known of the others.
using KnownJoints = std::vector<std::vector<JointTarget>>;

/// What known joints add to the normal equations of a hand's pose, sum_i J_i^T W_i J_i and sum_i J_i^T W_i r_i with
/// W_i = (C_i + (1 mm)^2 I)^-1: the model's joints are not quite the person's.
struct KnownJointEquations {
    Eigen::MatrixXd hessian;  ///< poseSize x poseSize, per mm^2 or rad^2
    Eigen::VectorXd gradient; ///< by a tangent step of the pose
};
KnownJointEquations knownJointEquations(const Skeleton& skeleton, const std::vector<JointTarget>& joints,
                                        const Pose& pose);

/// Sum over the known joints of all hands of their squared Mahalanobis distances from the models' joints, by W_i.
double knownJointMisfit(const std::vector<HandModel>& hands, const KnownJoints& known, const HandPoses& poses);

} // namespace core
