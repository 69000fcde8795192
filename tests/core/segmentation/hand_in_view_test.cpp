// SPDX-License-Identifier: MIT
#include "core/segmentation/hand_in_view.h"

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"

namespace core {
namespace {

/// A flat hand of 90 mm palm, fingers along +y of the world, about the origin.
LandmarkPoints flatHand() {
    LandmarkPoints points;
    points[0] = Eigen::Vector3d(0, -90, 0);
    for (int finger = 0; finger < 5; ++finger)
        for (int joint = 0; joint < 4; ++joint)
            points[static_cast<std::size_t>(1 + 4 * finger + joint)] =
                Eigen::Vector3d(20.0 * (finger - 2), 25.0 * joint, 0);
    return points;
}

TEST(HandInView, MeasuresThePalmInPixelsAndProjectsTheForearm) {
    const Camera camera = test::cameraRing(4, false)[1];
    const HandInView hand = handInView(camera, flatHand());
    ASSERT_TRUE(hand.isKnown());
    // The bases of four fingers lie around x = 10 mm.
    const double palmMm = std::hypot(90, 10), depthMm = (camera.cameraFromWorld * *flatHand()[0]).z();
    EXPECT_NEAR(hand.palmPx, palmMm * camera.intrinsics(0, 0) / depthMm, 0.01);
    const Eigen::Vector3d end = Eigen::Vector3d(0, -90, 0) + kForearmPalms * Eigen::Vector3d(-10, -90, 0);
    EXPECT_LT((*hand.forearmEnd - *project(camera, end)).norm(), 1e-9);
}

TEST(HandInView, IsUnknownWithoutTheWrist) {
    LandmarkPoints points = flatHand();
    points[0].reset();
    EXPECT_FALSE(handInView(test::cameraRing(1)[0], points).isKnown());
}

TEST(HandInView, CutsTheForearmAcrossItsAxis) {
    const HandInView hand = handInView(test::cameraRing(4, false)[1], flatHand());
    const auto wrist = forearmLine(hand, 0), end = forearmLine(hand, kForearmPalms);
    ASSERT_TRUE(wrist && end);
    EXPECT_LT(((wrist->from + wrist->to) / 2 - *hand.px[kWristLandmark]).norm(), 1e-9);
    EXPECT_LT(((end->from + end->to) / 2 - *hand.forearmEnd).norm(), 1e-6);
    EXPECT_NEAR((wrist->to - wrist->from).dot(wrist->away), 0, 1e-9);
    EXPECT_GT((*hand.forearmEnd - *hand.px[kWristLandmark]).dot(wrist->away), 0) << "away from the hand";
}

TEST(HandInView, FillsInTheWristAndTipsFromTheModel) {
    Skeleton skeleton;
    skeleton.bones = {{"forearm", -1, {}, 60}, {"index_pip", 0, {}, 30}, {"index_dip", 1, {}, 20}};
    skeleton.bones[1].worldFromBoneAtRest.translation = {0, 50, 0};
    skeleton.bones[2].worldFromBoneAtRest.translation = {0, 80, 0};
    LandmarkPoints points;
    points[6] = Eigen::Vector3d(1, 2, 3); // index_pip is known
    fillFromModel(points, skeleton, skeleton.restPose());
    EXPECT_EQ(*points[6], Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(*points[7], Eigen::Vector3d(0, 80, 0));
    EXPECT_EQ(*points[kWristLandmark], Eigen::Vector3d::Zero());
    EXPECT_LT((*points[8] - (*points[7] + 0.9 * (*points[7] - *points[6]))).norm(), 1e-12);
    EXPECT_FALSE(points[12]);
}

} // namespace
} // namespace core
