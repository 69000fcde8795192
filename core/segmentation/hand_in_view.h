// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "core/detection/hand_landmarks.h"
#include "core/geometry/camera.h"
#include "core/hand/skeleton.h"

namespace core {

/// The landmarks of one hand in space, by landmark (landmarkName), world, mm; those that are not known are empty.
using LandmarkPoints = std::array<std::optional<Eigen::Vector3d>, kLandmarkCount>;

/// The named points as landmarks; other names are left out.
LandmarkPoints landmarkPoints(const std::map<std::string, Eigen::Vector3d>& pointsInWorld);

/// Fills in what is not known by the joints of the posed hand model: bones of the same name, its root for the wrist; a
/// finger's tip lies as far beyond its last joint as 0.9 of the bone before.
void fillFromModel(LandmarkPoints& points, const Skeleton& skeleton, const Pose& pose);

/// Where a forearm ends in a picture: a line across it, px.
struct ForearmLine {
    Eigen::Vector2d from, to;
    Eigen::Vector2d away; ///< unit, from the hand towards the elbow
};

/// One hand as seeds need it in one picture: its landmarks, px, and how large it is there.
struct HandInView {
    std::array<std::optional<Eigen::Vector2d>, kLandmarkCount> px;
    double palmPx = 0;                         ///< length of the palm, from the wrist to the base of the middle finger
    std::optional<Eigen::Vector2d> forearmEnd; ///< as far along the forearm as was asked for
    std::optional<ForearmLine> wrist;          ///< across the wrist

    bool isKnown() const { return palmPx > 0; }
};

/// How far from the wrist a forearm is looked for, in lengths of the palm.
inline constexpr double kForearmPalms = 1.2;

/// The landmarks of a hand seen by a camera. Unknown (palmPx = 0) if the wrist or the bases of the fingers are not
/// known or not in front of the camera.
HandInView handInView(const Camera& camera, const LandmarkPoints& points, double forearmPalms = kForearmPalms);
/// The same for landmarks of this picture alone, such as the detector gives.
HandInView handInView(const LandmarkPixels& px, double forearmPalms = kForearmPalms);

/// The line across a hand's forearm, `palms` lengths of the palm beyond the wrist; none if it is not known where that
/// is.
std::optional<ForearmLine> forearmLine(const HandInView& hand, double palms);

} // namespace core
