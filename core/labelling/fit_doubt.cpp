// SPDX-License-Identifier: MIT
#include "core/labelling/fit_doubt.h"

#include <algorithm>
#include <cmath>

#include "core/labelling/landmark_fit.h"

namespace core {

namespace {

// Values at which a sign alone makes a doubt of one half.
constexpr double kHalfLandmarkMm = 16;
constexpr double kHalfUncovered = 0.16; ///< 1 - overlap
constexpr double kHalfMisfit = 3;
constexpr double kHalfRaySine = 0.26; ///< 15 degrees
constexpr std::size_t kFewestCompared = 5;

/// Doubt of one sign: 0 at 0, one half at `half`, towards 1 beyond.
double signDoubt(double value, double half) {
    const double share = value / half;
    return 1 - std::exp2(-share * share * share * share);
}

} // namespace

std::optional<double> landmarkDistanceMm(const HandModel& hand, const Pose& pose, const SpatialHand& detected,
                                         bool areJoints) {
    const auto joints = jointPositions(hand.skeleton, pose);
    double sum = 0;
    std::size_t count = 0;
    for (const JointTarget& target : landmarkTargets(hand, detected, areJoints)) {
        if (target.bone == 0)
            continue;
        sum += (joints[static_cast<std::size_t>(target.bone)] - target.pointInWorld).norm();
        ++count;
    }
    return count < kFewestCompared ? std::nullopt : std::optional(sum / static_cast<double>(count));
}

double widestRaySine(const std::vector<Camera>& cameras, const SpatialHand& hand) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    const int landmarks = std::max(hand.landmarkCount(), 1);
    for (const auto& landmark : hand.landmarks)
        if (landmark)
            mean += landmark->triangulated.pointInWorld / landmarks;
    std::vector<Eigen::Vector3d> rays;
    for (const auto& [camera, view] : hand.views)
        rays.push_back((mean - cameras[static_cast<std::size_t>(camera)].centreInWorld()).normalized());
    double widest = 0;
    for (std::size_t a = 0; a < rays.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            widest = std::max(widest, rays[a].cross(rays[b]).norm());
    return widest;
}

double doubtOf(const FitSigns& signs) {
    double trust = 1 - 1 / (1 + std::exp(7.1 - 15 * signs.deepPx - 0.9 * signs.worstSigmaMm));
    trust *= 1 - signDoubt(1 - signs.overlap, kHalfUncovered);
    if (signs.landmarkMm)
        trust *= 1 - signDoubt(*signs.landmarkMm, kHalfLandmarkMm);
    trust *= 1 - signDoubt(signs.misfit, kHalfMisfit);
    trust *= 1 - signDoubt(kHalfRaySine / std::max(signs.raySine, 1e-6), 1);
    return std::clamp(1 - trust, 0.0, 1.0);
}

} // namespace core
