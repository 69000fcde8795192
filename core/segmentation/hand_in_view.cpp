// SPDX-License-Identifier: MIT
#include "core/segmentation/hand_in_view.h"

#include <algorithm>
#include <vector>

namespace core {

namespace {

constexpr std::array<std::size_t, 4> kFingerBases{5, 9, 13, 17};
constexpr std::array<std::size_t, 5> kTips{4, 8, 12, 16, 20};
constexpr double kTipShare = 0.9;
constexpr double kWristWidth = 0.8;   ///< length of the line across the wrist, in palms
constexpr double kShortestAxis = 0.1; ///< of a forearm that is seen from its end, in palms

/// The mean of the known points of the finger bases, in space or in the picture.
template <class Points>
auto meanBase(const Points& points) -> typename Points::value_type {
    typename Points::value_type sum;
    int count = 0;
    for (const std::size_t i : kFingerBases) {
        if (!points[i])
            continue;
        sum = sum ? *sum + *points[i] : *points[i];
        ++count;
    }
    if (sum)
        *sum /= count;
    return sum;
}

std::optional<ForearmLine> lineAcross(const Eigen::Vector2d& at, const Eigen::Vector2d& axis, double palmPx) {
    if (axis.norm() < kShortestAxis * palmPx)
        return std::nullopt;
    const Eigen::Vector2d away = axis.normalized(), across(-away.y(), away.x());
    const Eigen::Vector2d half = kWristWidth / 2 * palmPx * across;
    return ForearmLine{at - half, at + half, away};
}

} // namespace

LandmarkPoints landmarkPoints(const std::map<std::string, Eigen::Vector3d>& pointsInWorld) {
    LandmarkPoints points;
    for (std::size_t i = 0; i < kLandmarkCount; ++i)
        if (const auto found = pointsInWorld.find(std::string(landmarkName(i))); found != pointsInWorld.end())
            points[i] = found->second;
    return points;
}

void fillFromModel(LandmarkPoints& points, const Skeleton& skeleton, const Pose& pose) {
    const std::vector<Eigen::Vector3d> joints = jointPositions(skeleton, pose);
    for (std::size_t i = 0; i < kLandmarkCount; ++i)
        if (const int bone = skeleton.boneIndex(landmarkName(i)); bone >= 0 && !points[i])
            points[i] = joints[static_cast<std::size_t>(bone)];
    if (!points[kWristLandmark])
        points[kWristLandmark] = joints.front();
    for (const std::size_t tip : kTips)
        if (!points[tip] && points[tip - 1] && points[tip - 2])
            points[tip] = *points[tip - 1] + kTipShare * (*points[tip - 1] - *points[tip - 2]);
}

HandInView handInView(const Camera& camera, const LandmarkPoints& points, double forearmPalms) {
    HandInView hand;
    for (std::size_t i = 0; i < kLandmarkCount; ++i)
        if (points[i])
            hand.px[i] = project(camera, *points[i]);
    const auto& wrist = points[kWristLandmark];
    const std::optional<Eigen::Vector3d> bases = meanBase(points);
    if (!wrist || !bases || !hand.px[kWristLandmark])
        return hand;
    const double depthMm = (camera.cameraFromWorld * *wrist).z();
    hand.palmPx = (*wrist - *bases).norm() * camera.intrinsics(0, 0) / depthMm;
    hand.forearmEnd = project(camera, *wrist + forearmPalms * (*wrist - *bases));
    if (hand.forearmEnd && forearmPalms > 0) {
        const Eigen::Vector2d axis = (*hand.forearmEnd - *hand.px[kWristLandmark]) / forearmPalms;
        hand.wrist = lineAcross(*hand.px[kWristLandmark], axis, hand.palmPx);
    }
    return hand;
}

HandInView handInView(const LandmarkPixels& px, double forearmPalms) {
    HandInView hand;
    std::copy(px.begin(), px.end(), hand.px.begin());
    const Eigen::Vector2d wrist = px[kWristLandmark], bases = *meanBase(hand.px);
    // A palm that points at the camera is short; its width is not.
    hand.palmPx = std::max((bases - wrist).norm(), (px[kIndexBaseLandmark] - px[kLittleBaseLandmark]).norm());
    hand.forearmEnd = wrist + forearmPalms * (wrist - bases);
    hand.wrist = lineAcross(wrist, wrist - bases, hand.palmPx);
    return hand;
}

std::optional<ForearmLine> forearmLine(const HandInView& hand, double palms) {
    if (!hand.wrist)
        return std::nullopt;
    const auto& wrist = *hand.px[kWristLandmark];
    const double foreshortened = hand.forearmEnd ? (*hand.forearmEnd - wrist).norm() : 0;
    ForearmLine line = *hand.wrist;
    const Eigen::Vector2d shift = palms / kForearmPalms * foreshortened * line.away;
    line.from += shift;
    line.to += shift;
    return line;
}

} // namespace core
