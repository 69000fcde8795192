// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

#include "tests/support/camera_ring.h"
#include "tests/support/two_finger_hand.h"

namespace test {

/// Adds 12 specks to each mask and makes as many holes in it, all 6 px wide, at places that are the same every time.
void speckle(std::vector<cv::Mat>& masks);

/// Two small hands seen by a ring of cameras of about one pixel per mm: where they are, what the cameras see and a pose
/// some way off to start from.
struct FittingScene {
    std::vector<core::HandModel> hands = twoFingerHands();
    std::vector<core::Camera> cameras;
    core::HandPoses truth, start;
    std::vector<cv::Mat> masks;

    explicit FittingScene(std::string_view seed, int cameraCount = 6, bool withLens = true);

    std::vector<cv::Mat> seen(const core::HandPoses& poses) const;
    double errorMm(const core::HandPoses& poses) const;
};

/// A forearm of the wrist's width beyond the cut of every hand, where the hands are in truth.
void drawForearms(const FittingScene& scene, std::vector<cv::Mat>& masks);

} // namespace test
