// SPDX-License-Identifier: MIT
#include "core/labelling/outline_rig.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contour/rasteriser.h"
#include "core/simulation/simulated_world.h"
#include "tests/support/simulated_pass.h"

namespace {

std::vector<cv::Mat> masksOf(const test::SimulatedPass& scene, const std::vector<core::Camera>& cameras, int frame) {
    std::vector<cv::Mat> masks;
    for (const core::Camera& camera : cameras)
        masks.push_back(core::renderHandsMask(camera, scene.hands, scene.motion[static_cast<std::size_t>(frame)]));
    return masks;
}

std::vector<core::MeasuredFrame> framesSeenBy(const test::SimulatedPass& scene,
                                              const std::vector<core::Camera>& cameras) {
    std::vector<core::MeasuredFrame> frames;
    for (const int frame : {10, 40, 70, 100})
        frames.push_back({scene.motion[static_cast<std::size_t>(frame)], masksOf(scene, cameras, frame)});
    return frames;
}

/// How far the true pixels of joints are from where a calibration brings them together, root mean square, px.
double disagreementPx(const test::SimulatedPass& scene, const std::vector<core::Camera>& real,
                      const std::vector<core::Camera>& cameras) {
    double squares = 0;
    int count = 0;
    for (const int frame : {25, 55, 85}) {
        for (std::size_t h = 0; h < 2; ++h) {
            for (const auto& joint :
                 core::jointPositions(scene.hands[h].skeleton, scene.motion[static_cast<std::size_t>(frame)][h])) {
                std::vector<core::Observation> seen;
                for (std::size_t c = 0; c < real.size(); ++c)
                    seen.push_back({static_cast<int>(c), *core::project(real[c], joint)});
                const auto point = core::refinePoint(cameras, seen, joint);
                for (std::size_t c = 0; c < real.size(); ++c, ++count)
                    squares += (*core::project(cameras[c], *point) - seen[c].px).squaredNorm();
            }
        }
    }
    return std::sqrt(squares / count);
}

TEST(OutlineRig, AShiftIsHowFarASilhouetteLiesBesideTheHands) {
    const test::SimulatedPass scene("shift", 4);
    core::Camera seenBy = scene.cameras[1];
    seenBy.intrinsics(0, 2) += 3.4;
    seenBy.intrinsics(1, 2) -= 5.7;
    const auto shift = core::outlineShift(scene.cameras[1], scene.hands, scene.motion[40],
                                          core::renderHandsMask(seenBy, scene.hands, scene.motion[40]));
    ASSERT_TRUE(shift);
    EXPECT_NEAR(shift->x(), 3.4, 0.3);
    EXPECT_NEAR(shift->y(), -5.7, 0.3);
}

TEST(OutlineRig, CamerasThatAreOffAgreeAgain) {
    const test::SimulatedPass scene("rig", 8);
    // Pictures of half the size: twice the angle moves them as far as a casual rig's.
    const auto real = core::perturbedCameras(scene.cameras, {0.16, 0.7, 0}, 3);
    const auto adjusted = core::camerasByOutlines(scene.cameras, scene.hands, framesSeenBy(scene, real), {});
    ASSERT_TRUE(adjusted);
    EXPECT_GT(disagreementPx(scene, real, scene.cameras), 2);
    EXPECT_GT(adjusted->shiftPx, 2);
    EXPECT_LT(disagreementPx(scene, real, adjusted->cameras), 0.5);
}

TEST(OutlineRig, AGoodCalibrationStays) {
    const test::SimulatedPass scene("good", 8);
    const auto real = core::perturbedCameras(scene.cameras, {0.02, 0.2, 0}, 3);
    EXPECT_FALSE(core::camerasByOutlines(scene.cameras, scene.hands, framesSeenBy(scene, real), {}));
}

} // namespace
