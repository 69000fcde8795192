// SPDX-License-Identifier: MIT
#include "core/segmentation/silhouette.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/contour/rasteriser.h"
#include "core/simulation/simulated_pictures.h"
#include "tests/support/simulated_pass.h"

namespace {

TEST(SilhouettesByModel, FindTheHandsOutlineFromAPoseThatIsOff) {
    test::SimulatedPass scene("silhouettes", 4);
    const core::HandPoses& truth = scene.motion[40];
    core::HandPoses off = truth;
    for (core::Pose& pose : off)
        pose.head<3>() += Eigen::Vector3d(3, -3, 3);
    const auto masks = core::silhouettesByModel(scene.cameras, scene.evidence(40).pictures, scene.hands, off);
    ASSERT_EQ(masks.size(), scene.cameras.size());
    for (std::size_t c = 0; c < masks.size(); ++c) {
        const cv::Mat seen = core::renderHandsMask(scene.cameras[c], scene.hands, truth);
        const cv::Mat model = core::renderHandsMask(scene.cameras[c], scene.hands, off);
        EXPECT_GT(core::maskOverlap(masks[c], seen), 0.97) << c;
        EXPECT_LT(core::maskOverlap(model, seen), 0.95) << c; // what it starts from
    }
}

TEST(SilhouettesByModel, FindItBeforeAClutteredNoisyBackground) {
    test::SimulatedPass scene("clutter", 4);
    const core::HandPoses& truth = scene.motion[40];
    core::HandPoses off = truth;
    for (core::Pose& pose : off)
        pose.head<3>() += Eigen::Vector3d(2, 2, -2);
    std::vector<cv::Mat> pictures = scene.evidence(40).pictures;
    for (std::size_t c = 0; c < pictures.size(); ++c) {
        cv::Mat picture = core::backgroundPicture(scene.cameras[c], 3 + c);
        pictures[c].copyTo(picture, core::renderHandsMask(scene.cameras[c], scene.hands, truth));
        pictures[c] = core::withSensorNoise(picture, {}, c);
    }
    const auto masks = core::silhouettesByModel(scene.cameras, pictures, scene.hands, off);
    for (std::size_t c = 0; c < masks.size(); ++c)
        EXPECT_GT(core::maskOverlap(masks[c], core::renderHandsMask(scene.cameras[c], scene.hands, truth)), 0.93) << c;
}

TEST(SilhouettesByModel, LeaveOutCamerasWithoutAPictureAndHandsThatAreNotThere) {
    test::SimulatedPass scene("one hand", 4);
    auto pictures = scene.evidence(40).pictures;
    pictures[1] = cv::Mat();
    const auto masks =
        core::silhouettesByModel(scene.cameras, pictures, scene.hands, {scene.motion[40][0], core::Pose()});
    EXPECT_TRUE(masks[1].empty());
    EXPECT_GT(cv::countNonZero(masks[0]), 500);
    const auto none = core::silhouettesByModel(scene.cameras, pictures, scene.hands, {core::Pose(), core::Pose()});
    EXPECT_TRUE(none[0].empty());
}

} // namespace
