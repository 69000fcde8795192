// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include <Eigen/Core>

namespace core {

/// The detector's joints of a hand: the wrist, then four per finger from the thumb to the little finger.
constexpr std::size_t kLandmarkCount = 21;
constexpr std::size_t kWristLandmark = 0, kIndexBaseLandmark = 5, kMiddleBaseLandmark = 9, kLittleBaseLandmark = 17;
/// Its name among our joints: wrist, thumb_cmc, thumb_mcp, thumb_ip, thumb_tip, index_mcp, ...
std::string_view landmarkName(std::size_t landmark);

using LandmarkPixels = std::array<Eigen::Vector2d, kLandmarkCount>; ///< centres at integers

/// A square of the picture, turned so that the fingers of the hand in it point to its upper side.
struct HandPlace {
    Eigen::Vector2d centrePx = Eigen::Vector2d::Zero();
    Eigen::Vector2d up{0, -1}; ///< unit vector from the wrist to the fingers
    double sidePx = 0;

    Eigen::Vector2d right() const { return {-up.y(), up.x()}; }
    /// The pixel of a point of the square: (0, 0) is its upper left corner, (1, 1) its lower right one.
    Eigen::Vector2d pixel(double across, double down) const {
        return centrePx + sidePx * ((across - 0.5) * right() - (down - 0.5) * up);
    }
};

/// The square around a hand whose landmarks are known from elsewhere (a first look, the last frame, other views): twice
/// their box without finger tips, as the landmark network was trained on.
HandPlace placeOf(const LandmarkPixels& landmarks);

/// What the detector says of one hand in one picture.
struct DetectedHand {
    LandmarkPixels px;
    double presence = 0;  ///< 0..1: that there is a hand
    double rightness = 0; ///< 0..1: that it is a right one; often wrong
    double sidePx = 0;    ///< of the square that it was found in: the measure of its errors
};

/// Mean distance of the landmarks of two hands in the same picture, px.
double meanDistancePx(const LandmarkPixels& a, const LandmarkPixels& b);

} // namespace core
