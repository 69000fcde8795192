// SPDX-License-Identifier: MIT
#pragma once

#include "core/benchmark/benchmark_run.h"
#include "core/error.h"

#include "tests/support/camera_ring.h"
#include "tests/support/tiny_hands.h"

namespace test {

/// Two sequences of tiny hands before three small cameras.
inline core::BenchmarkScene tinyScene() {
    core::BenchmarkScene scene{tinyHands(), cameraRing(3), {}};
    for (core::Camera& camera : scene.cameras)
        camera = core::cropped(camera, {-0.5, -0.5}, {54, 96}, 0.05);
    scene.sequences.push_back({"one", tinyMotion(40), {}, {}});
    scene.sequences.push_back({"two", tinyMotion(30), {}, {}});
    return scene;
}

inline std::vector<core::FramePair> tinyPairs(const core::BenchmarkScene& scene) {
    return core::drawPairs(core::pairFrames(scene, core::BenchmarkSetup::Synthetic), {0.2, {1, 5}, 3});
}

/// An estimator that needs no time: it finds a part of the way to the true pose that depends on the method, on the
/// start and on the silhouettes, and so shows whether it was given the right ones.
inline core::FitResult pretendToFit(const std::vector<cv::Mat>& masks, const core::HandPoses& start,
                                    const core::Method& method, std::stop_token) {
    double lit = 0;
    for (const cv::Mat& mask : masks) {
        for (int y = 0; y < mask.rows; ++y)
            for (int x = 0; x < mask.cols; ++x)
                lit += mask.at<uchar>(y, x) != 0 ? 1 + 0.01 * x + 0.02 * y : 0;
    }
    core::FitResult result;
    result.poses = start;
    result.poses[0][0] += 0.001 * lit + 0.1 * method.tauDeg;
    result.poses[1][6] += 0.3 / (1 + method.maxIterations);
    for (int i = 0; i < method.maxIterations; ++i)
        result.history.push_back({i, i == 3 ? 2.0 : 1.0 / (i + 1), 10, 0, 0.1, false, 0, result.poses, nullptr});
    result.seconds = 0.25;
    return result;
}

} // namespace test
