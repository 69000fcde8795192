// SPDX-License-Identifier: MIT
#include "core/hand/finger_prior.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Cholesky>

namespace core {

namespace {

constexpr double kChangePerRange = 0.1; ///< of angles of which nothing is learnt
constexpr double kLeastChangeRad = 0.005;
/// Choreographies are more regular than hands: correlations are shrunk to this share, so that no combination of bends
/// is ruled out.
constexpr double kTrust = 0.9;

constexpr std::array<std::string_view, 4> kFingers{"index", "middle", "ring", "little"};
constexpr std::array<std::string_view, 3> kJoints{"mcp", "pip", "dip"};

/// A bend of a long finger: which finger and joint, and the sign of its angle towards the palm.
struct Bend {
    int finger = 0;
    int joint = 0;
    double sign = 1;
};

std::optional<Bend> bendOf(const DegreeOfFreedom& dof) {
    for (int f = 0; f < static_cast<int>(kFingers.size()); ++f)
        for (int j = 0; j < static_cast<int>(kJoints.size()); ++j)
            if (dof.name == std::string(kFingers[f]) + "_" + std::string(kJoints[j]) + ".flexion")
                return Bend{f, j, -dof.minRad > dof.maxRad ? -1.0 : 1.0};
    return std::nullopt;
}

} // namespace

const FingerMotion& learntFingerMotion() {
    static const FingerMotion motion = [] {
        FingerMotion learnt;
        learnt.jointRad = {0.194, 0.266, 0.145};
        learnt.jointCorrelation << 1, 0.927, 0.93, 0.927, 1, 0.993, 0.93, 0.993, 1;
        learnt.fingerCorrelation = {1, 0.63, 0.267, 0.04};
        return learnt;
    }();
    return motion;
}

Eigen::MatrixXd fingerChangePrecision(const Skeleton& skeleton, const FingerMotion& motion) {
    const auto size = static_cast<Eigen::Index>(skeleton.dofs.size());
    std::vector<std::optional<Bend>> bends;
    for (const DegreeOfFreedom& dof : skeleton.dofs)
        bends.push_back(bendOf(dof));
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(size, size);
    for (Eigen::Index k = 0; k < size; ++k) {
        const auto& a = bends[static_cast<std::size_t>(k)];
        const DegreeOfFreedom& dof = skeleton.dofs[static_cast<std::size_t>(k)];
        const double change =
            a ? motion.jointRad[a->joint] : std::max(kLeastChangeRad, kChangePerRange * (dof.maxRad - dof.minRad));
        covariance(k, k) = change * change;
        for (Eigen::Index l = 0; a && l < k; ++l) {
            const auto& b = bends[static_cast<std::size_t>(l)];
            if (!b)
                continue;
            const double correlation = kTrust * motion.fingerCorrelation[std::abs(a->finger - b->finger)] *
                                       motion.jointCorrelation(a->joint, b->joint);
            covariance(k, l) = a->sign * b->sign * correlation * motion.jointRad[a->joint] * motion.jointRad[b->joint];
            covariance(l, k) = covariance(k, l);
        }
    }
    return covariance.llt().solve(Eigen::MatrixXd::Identity(size, size));
}

double fingerChangeCost(const Eigen::MatrixXd& precision, double weight, const Eigen::VectorXd& change) {
    return 0.5 * weight * change.dot(precision * change);
}

void addFingerChange(const Eigen::MatrixXd& precision, double weight, const Eigen::VectorXd& change,
                     Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) {
    const Eigen::MatrixXd pull = weight * precision;
    hessian.bottomRightCorner(pull.rows(), pull.cols()) += pull;
    gradient.tail(pull.rows()) += pull * change;
}

} // namespace core
