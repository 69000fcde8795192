// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "core/rig/click_sigma_estimate.h"
#include "tests/core/rig/rig_scene.h"

namespace test {

/// Points made from clicks beside the true ones.
struct TruthComparison {
    double rawMm = 0, alignedMm = 0; ///< mean error, as it is and after the best rigid motion
    double neesRaw = 0,
           neesAligned = 0; ///< mean of e^T C^-1 e, as it is and aligned; 3 where the covariances are right
    double statedMm = 0;    ///< mean of the expected error, sqrt(trace C)
    double dropped = 0;     ///< share of the clicks taken for outliers
};

/// Triangulates each joint with the rater's sigmas. Expects that every joint gets a point. `world` is what is stated of
/// the world as a whole: it adds to the covariances before the rigid motion.
inline TruthComparison compareWithTruth(const RigScene& scene, const std::vector<core::Camera>& cameras,
                                        const std::vector<core::RigJoint>& joints, const core::ClickSigmas& sigmas,
                                        const Eigen::Matrix3d& world = Eigen::Matrix3d::Zero()) {
    const auto count = static_cast<Eigen::Index>(joints.size());
    Eigen::Matrix3Xd made(3, count), wanted(3, count);
    std::vector<Eigen::Matrix3d> information, inWorld;
    const core::TriangulationOptions options = sigmas.optionsFor("ann");
    TruthComparison result;
    double clicks = 0;
    for (Eigen::Index j = 0; j < count; ++j) {
        const core::RigJoint& joint = joints[static_cast<std::size_t>(j)];
        const auto point = core::triangulate(cameras, joint.clicks, options).point.value();
        made.col(j) = point.pointInWorld;
        wanted.col(j) = scene.pointAt(std::stoi(joint.joint.joint.substr(5)), joint.frame);
        information.emplace_back(point.covariance.inverse());
        inWorld.emplace_back((point.covariance + world).inverse());
        result.statedMm += std::sqrt(point.covariance.trace()) / static_cast<double>(count);
        for (const bool isInlier : point.inlier)
            result.dropped += !isInlier;
        clicks += static_cast<double>(point.inlier.size());
    }
    result.dropped /= clicks;
    const Eigen::Matrix4d motion = Eigen::umeyama(made, wanted, false);
    const Eigen::Matrix3Xd aligned = (motion.topLeftCorner<3, 3>() * made).colwise() + motion.topRightCorner<3, 1>();
    for (Eigen::Index j = 0; j < count; ++j) {
        const Eigen::Vector3d raw = made.col(j) - wanted.col(j), rest = aligned.col(j) - wanted.col(j);
        const double share = 1 / static_cast<double>(count);
        const Eigen::Matrix3d& inverse = information[static_cast<std::size_t>(j)];
        result.rawMm += share * raw.norm();
        result.alignedMm += share * rest.norm();
        result.neesRaw += share * raw.dot(inWorld[static_cast<std::size_t>(j)] * raw);
        result.neesAligned += share * rest.dot(inverse * rest);
    }
    return result;
}

/// Adds up results of several seeds.
inline void add(TruthComparison& sum, const TruthComparison& one, double share) {
    sum.rawMm += share * one.rawMm;
    sum.alignedMm += share * one.alignedMm;
    sum.neesRaw += share * one.neesRaw;
    sum.neesAligned += share * one.neesAligned;
    sum.statedMm += share * one.statedMm;
    sum.dropped += share * one.dropped;
}

} // namespace test
