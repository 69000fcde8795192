// SPDX-License-Identifier: MIT
#include "core/detection/landmark_errors.h"

#include <Eigen/Geometry>

#include "core/detection/landmark_spread.h"

namespace core {

namespace {

constexpr double kShortestMm = 1; ///< directions between nearer points are not known

std::optional<Eigen::Vector3d> direction(const SpatialHand& hand, std::size_t from, std::size_t to) {
    if (!hand.landmarks[from] || !hand.landmarks[to])
        return std::nullopt;
    const Eigen::Vector3d way =
        hand.landmarks[to]->triangulated.pointInWorld - hand.landmarks[from]->triangulated.pointInWorld;
    return way.norm() < kShortestMm ? std::nullopt : std::optional(way);
}

} // namespace

std::optional<Eigen::Matrix3d> landmarkFrame(const SpatialHand& hand, std::size_t landmark, Side side) {
    const bool isBase = landmark % 4 == 1;
    const auto along = landmark == kWristLandmark ? direction(hand, kWristLandmark, kMiddleBaseLandmark)
                                                  : direction(hand, isBase ? kWristLandmark : landmark - 1, landmark);
    const auto palm = direction(hand, kWristLandmark, kMiddleBaseLandmark);
    const auto across = direction(hand, kLittleBaseLandmark, kIndexBaseLandmark);
    if (!along || !palm || !across)
        return std::nullopt;
    const double sign = side == Side::Right ? 1 : -1;
    const Eigen::Vector3d y = along->normalized();
    Eigen::Vector3d z = sign * across->cross(*palm).normalized();
    z -= y * y.dot(z);
    if (!(z.norm() > 1e-3))
        return std::nullopt;
    z.normalize();
    Eigen::Matrix3d frame;
    frame << sign * y.cross(z), y, z;
    return frame;
}

SpatialHand withoutBias(SpatialHand hand, Side side) {
    const auto palm = direction(hand, kWristLandmark, kMiddleBaseLandmark);
    if (!palm)
        return hand;
    const SpatialHand detected = hand;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        const auto frame = detected.landmarks[i] ? landmarkFrame(detected, i, side) : std::nullopt;
        if (frame)
            hand.landmarks[i]->triangulated.pointInWorld -= palm->norm() * (*frame * landmarkSpread(i).bias);
    }
    return hand;
}

} // namespace core
