// SPDX-License-Identifier: MIT
#include "core/detection/hand_landmarks.h"

#include <limits>

namespace core {

namespace {

/// Wrist, thumb without its tip, and of each finger its base and the next joint.
constexpr std::array<std::size_t, 12> kPalmarLandmarks{0, 1, 2, 3, 5, 6, 9, 10, 13, 14, 17, 18};
constexpr double kPlaceScale = 2.0;
constexpr double kPlaceShift = 0.1; ///< towards the fingers, share of the box

} // namespace

std::string_view landmarkName(std::size_t landmark) {
    constexpr std::array<std::string_view, kLandmarkCount> kNames{
        "wrist",     "thumb_cmc", "thumb_mcp",  "thumb_ip",   "thumb_tip",  "index_mcp",  "index_pip",
        "index_dip", "index_tip", "middle_mcp", "middle_pip", "middle_dip", "middle_tip", "ring_mcp",
        "ring_pip",  "ring_dip",  "ring_tip",   "little_mcp", "little_pip", "little_dip", "little_tip"};
    return kNames.at(landmark);
}

HandPlace placeOf(const LandmarkPixels& landmarks) {
    HandPlace place;
    const Eigen::Vector2d bases = landmarks[5] / 4 + landmarks[13] / 4 + landmarks[kMiddleBaseLandmark] / 2;
    const Eigen::Vector2d axis = bases - landmarks[kWristLandmark];
    if (axis.norm() > 1e-6)
        place.up = axis.normalized();
    Eigen::Array2d least = Eigen::Array2d::Constant(std::numeric_limits<double>::max()), most = -least;
    for (const std::size_t i : kPalmarLandmarks) {
        const Eigen::Array2d at(landmarks[i].dot(place.right()), landmarks[i].dot(place.up));
        least = least.min(at);
        most = most.max(at);
    }
    const Eigen::Array2d centre = (least + most) / 2, size = most - least;
    place.centrePx = centre.x() * place.right() + (centre.y() + kPlaceShift * size.y()) * place.up;
    place.sidePx = kPlaceScale * size.maxCoeff();
    return place;
}

double meanDistancePx(const LandmarkPixels& a, const LandmarkPixels& b) {
    double sum = 0;
    for (std::size_t i = 0; i < kLandmarkCount; ++i)
        sum += (a[i] - b[i]).norm();
    return sum / static_cast<double>(kLandmarkCount);
}

} // namespace core
