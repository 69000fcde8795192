// SPDX-License-Identifier: MIT
#include "core/detection/hand_views.h"

#include <gtest/gtest.h>

#include "core/detection/hand_doubt.h"
#include "core/detection/hand_sides.h"
#include "core/detection/landmark_errors.h"
#include "core/detection/landmark_spread.h"
#include "tests/support/camera_ring.h"
#include "tests/support/random_values.h"

namespace {

using Points = std::array<Eigen::Vector3d, core::kLandmarkCount>;

/// A hand-like set of points around `centre`, mm.
Points handAt(const Eigen::Vector3d& centre, test::RandomValues& random) {
    Points points;
    points[0] = centre;
    for (int finger = 0; finger < 5; ++finger)
        for (int k = 0; k < 4; ++k)
            points[static_cast<std::size_t>(1 + 4 * finger + k)] =
                centre + Eigen::Vector3d(20.0 * (finger - 2), 60 + 25.0 * k, 10.0 * (k % 2)) + random.vector(3, 0.5);
    return points;
}

core::DetectedHand seen(const core::Camera& camera, const Points& points, double rightness, double noisePx,
                        test::RandomValues& random) {
    core::DetectedHand hand;
    for (std::size_t i = 0; i < core::kLandmarkCount; ++i)
        hand.px[i] = *core::project(camera, points[i]) + noisePx * Eigen::Vector2d(random.normal(), random.normal());
    hand.presence = 0.99;
    hand.rightness = rightness;
    hand.sidePx = core::placeOf(hand.px).sidePx;
    return hand;
}

double meanErrorMm(const core::SpatialHand& hand, const Points& truth) {
    double sum = 0;
    for (std::size_t i = 0; i < core::kLandmarkCount; ++i)
        sum += hand.landmarks[i] ? (hand.landmarks[i]->triangulated.pointInWorld - truth[i]).norm() : 1e3;
    return sum / core::kLandmarkCount;
}

struct Scene {
    std::vector<core::Camera> cameras = test::cameraRing(8);
    Points left, right;
    core::ViewDetections detections;
};

/// Two hands 70 mm apart in eight views; in three of them the detector takes each for the other side, in one it sees
/// something else, in another only one hand.
Scene twoHands(const std::string& name, const Eigen::Vector3d& shift = Eigen::Vector3d::Zero()) {
    test::RandomValues random(name);
    Scene scene;
    scene.left = handAt(Eigen::Vector3d(-75, -60, 10) + shift, random);
    scene.right = handAt(Eigen::Vector3d(75, -60, -10) + shift, random);
    for (std::size_t c = 0; c < scene.cameras.size(); ++c) {
        const double wrong = c % 3 == 0 ? 0.9 : 0.02;
        auto& list = scene.detections.emplace_back();
        list.push_back(seen(scene.cameras[c], scene.right, 1 - wrong, 3, random));
        if (c != 5)
            list.push_back(seen(scene.cameras[c], scene.left, wrong, 3, random));
        if (c == 2)
            list.insert(list.begin(), seen(scene.cameras[c], handAt({0, 150, 0}, random), 0.5, 3, random));
    }
    return scene;
}

TEST(HandViews, JoinsTheViewsOfEachHandWhateverSideTheDetectorSays) {
    const Scene scene = twoHands("two hands");
    const auto hands = core::groupDetections(scene.cameras, scene.detections);
    ASSERT_EQ(hands.size(), 2u);
    EXPECT_EQ(hands[0].views.size(), 8u);
    EXPECT_EQ(hands[1].views.size(), 7u);
    EXPECT_LT(meanErrorMm(hands[0], scene.right), 2);
    EXPECT_LT(meanErrorMm(hands[1], scene.left), 2);
    EXPECT_GT(hands[0].rightnessLogOdds(), 0);
    EXPECT_LT(hands[1].rightnessLogOdds(), 0);
}

TEST(HandViews, FindsNothingWhereNoTwoViewsAgree) {
    test::RandomValues random("no agreement");
    const auto cameras = test::cameraRing(4);
    core::ViewDetections detections;
    for (std::size_t c = 0; c < cameras.size(); ++c)
        detections.push_back({seen(cameras[c], handAt(random.vector(3, 200), random), 0.5, 60, random)});
    EXPECT_TRUE(core::groupDetections(cameras, detections).empty());
    EXPECT_TRUE(core::groupDetections(cameras, core::ViewDetections(4)).empty());
}

TEST(HandViews, ProjectsAHandIntoOtherCameras) {
    const Scene scene = twoHands("projected hands");
    const auto hands = core::groupDetections(scene.cameras, scene.detections);
    ASSERT_FALSE(hands.empty());
    const auto px = core::projectHand(scene.cameras[5], hands[0]);
    ASSERT_TRUE(px);
    EXPECT_NEAR(((*px)[8] - *core::project(scene.cameras[5], scene.right[8])).norm(), 0, 8);
}

TEST(HandSides, AreDecidedByAllViewsOfAllFramesTogether) {
    std::map<int, std::vector<core::SpatialHand>> frames;
    for (int frame = 0; frame < 4; ++frame) {
        Scene scene = twoHands("frame " + std::to_string(frame), {3.0 * frame, 0, 0});
        if (frame == 2) // a frame in which the detector takes both for the other side
            for (auto& list : scene.detections)
                for (core::DetectedHand& hand : list)
                    hand.rightness = 1 - hand.rightness;
        frames[frame] = core::groupDetections(scene.cameras, scene.detections);
        if (frame % 2 == 1)
            std::swap(frames[frame][0], frames[frame][1]);
    }
    const auto sided = core::giveSides(frames);
    for (const auto& [frame, hands] : sided) {
        ASSERT_EQ(hands.size(), 2u);
        for (const core::SidedHand& hand : hands) {
            const double x = hand.hand.landmarks[9]->triangulated.pointInWorld.x();
            EXPECT_EQ(hand.side, x > 0 ? core::Side::Right : core::Side::Left) << "frame " << frame;
            EXPECT_LT(hand.sideDoubt, 0.01);
        }
    }
}

TEST(LandmarkErrors, MirrorBetweenLeftAndRightHands) {
    test::RandomValues random("bias");
    const Points points = handAt({0, 0, 0}, random);
    core::SpatialHand right, left;
    for (std::size_t i = 0; i < core::kLandmarkCount; ++i) {
        core::SpatialLandmark landmark;
        landmark.triangulated.pointInWorld = points[i];
        right.landmarks[i] = landmark;
        landmark.triangulated.pointInWorld.x() *= -1;
        left.landmarks[i] = landmark;
    }
    const core::SpatialHand a = core::withoutBias(right, core::Side::Right),
                            b = core::withoutBias(left, core::Side::Left);
    const double palmMm = (points[core::kMiddleBaseLandmark] - points[0]).norm();
    for (std::size_t i = 0; i < core::kLandmarkCount; ++i) {
        Eigen::Vector3d mirrored = b.landmarks[i]->triangulated.pointInWorld;
        mirrored.x() *= -1;
        const Eigen::Vector3d moved = a.landmarks[i]->triangulated.pointInWorld - points[i];
        EXPECT_NEAR((a.landmarks[i]->triangulated.pointInWorld - mirrored).norm(), 0, 1e-9);
        EXPECT_NEAR(moved.norm(), palmMm * core::landmarkSpread(i).bias.norm(), 1e-9);
    }
    // along the finger: y points from the joint before
    const Eigen::Vector3d along = (points[7] - points[6]).normalized();
    EXPECT_NEAR((a.landmarks[7]->triangulated.pointInWorld - points[7]).dot(along),
                -palmMm * core::landmarkSpread(7).bias.y(), 1e-9);
    left.landmarks[core::kMiddleBaseLandmark].reset();
    EXPECT_EQ(core::withoutBias(left, core::Side::Left).landmarks[7]->triangulated.pointInWorld,
              left.landmarks[7]->triangulated.pointInWorld)
        << "no palm";
}

TEST(HandDoubt, GrowsWhereBonesChangeAndViewsDisagree) {
    std::map<int, std::vector<core::SpatialHand>> frames;
    for (int frame = 0; frame < 5; ++frame) {
        Scene scene = twoHands("doubt");
        if (frame == 3)
            for (auto& list : scene.detections)
                for (core::DetectedHand& hand : list)
                    hand.px[8] = hand.px[5] + 0.2 * (hand.px[8] - hand.px[5]); // a finger that shrank
        if (frame == 4)
            scene.detections.resize(2);
        scene.detections.resize(8);
        frames[frame] = core::groupDetections(scene.cameras, scene.detections);
    }
    const auto doubts = core::doubtsOf(core::giveSides(frames), 8);
    EXPECT_LT(doubts.at(0)[0], 0.5);
    EXPECT_GT(doubts.at(3)[0], 0.5) << "a bone of another length";
    EXPECT_GT(doubts.at(4)[0], 0.5) << "two views of eight";
}

} // namespace
