// SPDX-License-Identifier: MIT
#include "core/simulation/simulated_clicks.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"
#include "tests/support/tiny_hands.h"

namespace core {
namespace {

/// Distances of all placed marks from where the joints are, squared, and how many there are.
std::pair<double, int> squaredErrors(const AnnotationSet& set, const SimulatedWorld& world, const Motion& motion) {
    double sum = 0;
    int count = 0;
    for (const auto& [key, mark] : set.marks) {
        if (!mark.isPlaced())
            continue;
        const std::size_t h = key.joint.hand == world.hands[0].side ? 0 : 1;
        const Skeleton& skeleton = world.hands[h].skeleton;
        const auto joints = jointPositions(skeleton, motion[static_cast<std::size_t>(key.frame)][h]);
        for (const Camera& camera : world.cameras) {
            if (camera.name == key.camera) {
                const Eigen::Vector3d& joint = joints[static_cast<std::size_t>(skeleton.boneIndex(key.joint.joint))];
                sum += (mark.px - *project(camera, joint)).squaredNorm();
                ++count;
            }
        }
    }
    return {sum, count};
}

TEST(SimulatedClicks, ScatterByTheirNoiseAndAreOneEditPerStep) {
    const SimulatedWorld world = simulatedWorld(test::tinyHands(), test::cameraRing(8), {}, 1);
    const Motion motion = test::tinyMotion(60);
    AnnotationSet set, replayed;
    for (int frame = 0; frame < 60; ++frame) {
        const SimulatedClicks clicks =
            annotateFrame(set, world, motion[static_cast<std::size_t>(frame)], frame, "a", {});
        EXPECT_EQ(clicks.edits.size(), static_cast<std::size_t>(clicks.placed + clicks.unplaceable));
        EXPECT_TRUE(clicks.wrong.empty());
        for (const Edit& edit : clicks.edits)
            apply(replayed, edit);
    }
    EXPECT_EQ(set, replayed);
    const auto [sum, count] = squaredErrors(set, world, motion);
    ASSERT_GT(count, 500);
    EXPECT_NEAR(std::sqrt(sum / (2 * count)), 1, 0.05) << "per axis";
}

TEST(SimulatedClicks, AreWrongAsOftenAsTheyShouldBe) {
    const SimulatedWorld world = simulatedWorld(test::tinyHands(), test::cameraRing(8), {}, 2);
    AnnotatorOptions options;
    options.wrongShare = 0.05;
    int placed = 0;
    std::size_t wrong = 0;
    const Motion motion = test::tinyMotion(80);
    for (int frame = 0; frame < 80; ++frame) {
        AnnotationSet set;
        const SimulatedClicks clicks =
            annotateFrame(set, world, motion[static_cast<std::size_t>(frame)], frame, "a", options);
        placed += clicks.placed;
        wrong += clicks.wrong.size();
    }
    EXPECT_NEAR(static_cast<double>(wrong) / placed, 0.05, 0.02);
}

TEST(SimulatedClicks, SayWhatCannotBeSeen) {
    std::vector<HandModel> hands = test::tinyHands();
    const SimulatedWorld world = simulatedWorld(hands, test::cameraRing(8), {}, 3);
    HandPoses poses = test::tinyMotion(1)[0];
    // The left hand is 120 mm beside the right one: seen along that line one of them hides the other.
    AnnotatorOptions options;
    options.seesOcclusion = true;
    AnnotationSet set;
    const SimulatedClicks clicks = annotateFrame(set, world, poses, 0, "a", options);
    EXPECT_GT(clicks.occluded + clicks.unplaceable, 0);
    EXPECT_GT(clicks.placed, clicks.occluded + clicks.unplaceable) << "most joints are seen";
    AnnotationSet blind;
    EXPECT_EQ(annotateFrame(blind, world, poses, 0, "a", {}).occluded, 0);
    poses[0][0] += 1e4;
    AnnotationSet outside;
    EXPECT_GE(annotateFrame(outside, world, poses, 0, "a", {}).unplaceable, 4);
}

} // namespace
} // namespace core
