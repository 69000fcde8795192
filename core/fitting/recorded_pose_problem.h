// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/hand/skeleton.h"

namespace core {

/// Recorded bone poses as a least-squares problem over poses. Nine residuals per bone b with recorded pose (R_b',
/// o_b'): its origin o_b - o_b' (mm), its end e_b - e_b' (mm) and kRotationWeightMm log(R_b R_b'^T).
///
/// The Jacobian of origins and ends is exact. That of the rotation is w_k, the axis of degree of freedom k; exact would
/// be J_l^-1(log(R_b R_b'^T)) w_k, J_l the left Jacobian of SO(3), which is I + O(angle): right where the bones fit,
/// and near enough for descent elsewhere.
class RecordedPoseProblem {
public:
    static constexpr double kRotationWeightMm = 5; ///< 1 rad of rotation counts as much as this many mm

    /// `skeleton` and `worldFromBone`, one recorded pose per bone, must outlive the problem.
    RecordedPoseProblem(const Skeleton& skeleton, const std::vector<RigidMotion>& worldFromBone);

    double cost(const Pose& pose) const { return 0.5 * residuals(pose).squaredNorm(); }
    void linearise(const Pose& pose, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const;
    Pose retract(const Pose& pose, const Eigen::VectorXd& step) const { return core::retract(pose, step); }

    /// 9 per bone: origin, end, rotation.
    Eigen::VectorXd residuals(const Pose& pose) const;
    /// The residuals' derivative by the tangent step, rows as in residuals().
    Eigen::MatrixXd jacobian(const Pose& pose) const;

private:
    const Skeleton& m_skeleton;
    const std::vector<RigidMotion>& m_recorded;
    std::vector<std::vector<bool>> m_moved; ///< [bone][dof]: whether that degree of freedom moves the bone
};

} // namespace core
