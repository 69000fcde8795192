// SPDX-License-Identifier: MIT
#include "core/geometry/camera_faults.h"

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"

namespace {

using core::CameraFault;
using enum core::CameraFaultKind;

class CameraFaults : public testing::Test {
protected:
    std::vector<CameraFault> find() const { return core::findCameraFaults(cameras, sizes); }
    CameraFault only() const {
        const std::vector<CameraFault> all = find();
        EXPECT_EQ(all.size(), 1u);
        return all.empty() ? CameraFault{} : all.front();
    }

    std::vector<core::Camera> cameras = test::cameraRing(6);
    std::vector<std::optional<core::ImageSize>> sizes;
};

TEST_F(CameraFaults, AGoodRigHasNone) {
    EXPECT_TRUE(find().empty());
    sizes = {cameras[0].size, std::nullopt, core::ImageSize{cameras[2].size.height, cameras[2].size.width}};
    EXPECT_TRUE(find().empty()) << "a quarter turn is the footage's own affair";
}

TEST_F(CameraFaults, ARotationThatIsNoneIsFatal) {
    cameras[2].cameraFromWorld.rotation.row(0) *= -1; // a mirror
    EXPECT_EQ(find().front().kind, NotARotation);
    EXPECT_EQ(find().front().value, -1);
    EXPECT_EQ(find().front().camera, 2);
    EXPECT_TRUE(find().front().isFatal());
    cameras = test::cameraRing(6);
    cameras[1].cameraFromWorld.rotation *= 1.01;
    EXPECT_EQ(find().front().kind, NotARotation);
    EXPECT_NEAR(find().front().value, 0.0201, 1e-6);
    cameras[1].cameraFromWorld.rotation(0, 0) = std::nan("");
    EXPECT_EQ(find().front().kind, NotARotation);
}

TEST_F(CameraFaults, PicturesOfAnotherSizeSayByWhatTheyAreScaled) {
    const core::ImageSize size = cameras[3].size;
    sizes.resize(6);
    sizes[3] = core::ImageSize{size.width / 2, size.height / 2};
    EXPECT_EQ(only().kind, OtherScale);
    EXPECT_NEAR(only().value, 0.5, 1e-9);
    EXPECT_EQ(only().camera, 3);
    sizes[3] = core::ImageSize{2 * size.height, 2 * size.width};
    EXPECT_EQ(only().kind, OtherScale) << "turned as well";
    EXPECT_NEAR(only().value, 2, 1e-9);
    sizes[3] = core::ImageSize{size.width, size.height + 40};
    EXPECT_EQ(only().kind, OtherSize);
    EXPECT_EQ(only().pictures, *sizes[3]);
    EXPECT_TRUE(only().isFatal());
}

TEST_F(CameraFaults, ACameraThatLooksAwayOrPastIsNamed) {
    core::RigidMotion& pose = cameras[4].cameraFromWorld;
    const Eigen::Vector3d centre = cameras[4].centreInWorld();
    const Eigen::Matrix3d right = pose.rotation;
    const auto turnBy = [&](double angleRad) {
        pose.rotation = Eigen::AngleAxisd(angleRad, Eigen::Vector3d::UnitY()).toRotationMatrix() * right;
        pose.translation = -pose.rotation * centre;
    };
    turnBy(3.14159);
    EXPECT_EQ(only().kind, LooksAway);
    EXPECT_EQ(only().camera, 4);
    EXPECT_FALSE(only().isFatal());
    turnBy(1.0);
    EXPECT_EQ(only().kind, TargetUnseen);
}

TEST_F(CameraFaults, TwoInOnePlaceAreOneTooMany) {
    cameras[5].cameraFromWorld = cameras[1].cameraFromWorld;
    EXPECT_EQ(only().kind, SamePlace);
    EXPECT_EQ(only().camera, 5);
    EXPECT_EQ(only().other, 1);
}

TEST_F(CameraFaults, LensesAreLookedAt) {
    cameras[0].intrinsics(0, 0) = -1;
    EXPECT_EQ(find().front().kind, NoFocalLength);
    cameras = test::cameraRing(6);
    cameras[0].intrinsics(0, 2) = -400;
    EXPECT_EQ(find().front().kind, CentreOutside);
}

TEST_F(CameraFaults, ARigInMetresIsOdd) {
    for (core::Camera& camera : cameras)
        camera.cameraFromWorld.translation /= 1000;
    EXPECT_EQ(only().kind, OddUnit);
    EXPECT_EQ(only().camera, -1);
    EXPECT_EQ(core::rigScale(cameras).likelyFactor, 1000);
}

} // namespace
