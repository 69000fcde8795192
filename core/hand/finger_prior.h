// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "core/hand/skeleton.h"

namespace core {

/// How the fingers of the demo's choreographies change within up to 15 frames, learnt from their recorded motion
/// (docs/method.md, "Finger prior"): what the fingers that are seen did tells what the hidden ones probably did.
/// The covariance of the changes of the bends of the four long fingers is the Kronecker product of one between fingers
/// and one between the joints of a finger; a bend counts positive towards the palm.
struct FingerMotion {
    Eigen::Vector3d jointRad;          ///< root mean square change of mcp, pip and dip, rad
    Eigen::Matrix3d jointCorrelation;  ///< between mcp, pip and dip of one finger
    Eigen::Vector4d fingerCorrelation; ///< of the same joint of two fingers that lie 0, 1, 2 and 3 fingers apart
};
/// The numbers that the demo's choreographies give.
const FingerMotion& learntFingerMotion();

/// Inverse covariance of the changes of all angles of a hand, degrees of freedom x degrees of freedom, 1 / rad^2.
/// Bends of the long fingers follow `motion`, by the names of their degrees of freedom (index_pip.flexion); every other
/// angle changes on its own, by a tenth of its range. Names that are not known belong to the latter.
Eigen::MatrixXd fingerChangePrecision(const Skeleton& skeleton, const FingerMotion& motion);

/// The prior's cost of a change of all angles, weight / 2 change^T precision change, and its derivatives, added to
/// those of the angles, the last of a pose.
double fingerChangeCost(const Eigen::MatrixXd& precision, double weight, const Eigen::VectorXd& change);
void addFingerChange(const Eigen::MatrixXd& precision, double weight, const Eigen::VectorXd& change,
                     Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient);

} // namespace core
