// SPDX-License-Identifier: MIT
#include "core/segmentation/silhouette.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/contour/forearm.h"
#include "core/contour/rasteriser.h"
#include "core/simulation/forearm_surface.h"
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

/// A world as a dataset's: in sleeves, before a cluttered room.
struct SleevedWorld {
    test::SimulatedPass scene{"sleeves", 4};
    core::SimulatedWorld world;
    const core::HandPoses& poses = scene.motion[40];

    SleevedWorld() {
        core::Imperfection arms;
        arms.forearm = true;
        world = core::simulatedWorld(scene.hands, scene.cameras, arms, 5);
    }
    std::vector<cv::Mat> pictures() const {
        std::vector<cv::Mat> list;
        for (std::size_t c = 0; c < world.cameras.size(); ++c)
            list.push_back(core::simulatedPicture(world, c, scene.motion, 40,
                                                  core::backgroundPicture(world.cameras[c], 5), {}, "sleeves"));
        return list;
    }
    /// Where a camera sees the arm of a hand, up to 50 mm beyond the end of its model, outside both hands.
    cv::Mat armMask(std::size_t camera, std::size_t hand) const {
        const core::ForearmCut cut = core::forearmCut(world.hands[hand]);
        const double lengthMm = cut.endMm + 50;
        const core::ForearmSurface arm = core::forearmSurface(world.hands[hand], poses[hand], lengthMm);
        return core::renderMask(world.cameras[camera], {{&arm.verticesInWorld, &arm.triangles}}) &
               ~core::renderHandsMask(world.cameras[camera], world.hands, poses);
    }
};

TEST(SilhouettesByModel, HoldSleevesAsMuchAsBareArms) {
    const SleevedWorld sleeved;
    const auto masks =
        core::silhouettesByModel(sleeved.scene.cameras, sleeved.pictures(), sleeved.scene.hands, sleeved.poses);
    int armsInSight = 0;
    for (std::size_t c = 0; c < masks.size(); ++c) {
        for (std::size_t h = 0; h < 2; ++h) {
            const cv::Mat arm = sleeved.armMask(c, h);
            if (cv::countNonZero(arm) < 300) // seen from its end
                continue;
            ++armsInSight;
            EXPECT_GT(cv::countNonZero(masks[c] & arm), 0.65 * cv::countNonZero(arm)) << c << " " << h;
        }
        const cv::Mat hands = core::renderHandsMask(sleeved.scene.cameras[c], sleeved.scene.hands, sleeved.poses);
        EXPECT_GT(cv::countNonZero(masks[c] & hands), 0.93 * cv::countNonZero(hands)) << c;
        EXPECT_LT(cv::countNonZero(masks[c]), 0.6 * static_cast<double>(masks[c].total())) << c;
    }
    EXPECT_GE(armsInSight, 5);
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
