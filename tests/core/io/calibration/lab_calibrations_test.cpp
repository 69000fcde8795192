// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "core/io/calibration/calibration.h"
#include "core/io/matlab/mat_file.h"

// Files that laboratories work with. They are not part of this project; where they are missing, the tests are skipped.
namespace {

namespace fs = std::filesystem;

const fs::path kLabs = fs::path(HANDLENS_SHARED_DATA) / "labs";

/// The point that lies nearest to the cameras' axes, and the largest distance from it to any of them.
std::pair<Eigen::Vector3d, double> meetingPoint(const std::vector<core::Camera>& cameras) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const core::Camera& camera : cameras) {
        const Eigen::Vector3d axis = camera.cameraFromWorld.rotation.row(2);
        const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
        sum += across;
        right += across * camera.centreInWorld();
    }
    const Eigen::Vector3d point = sum.inverse() * right;
    double most = 0;
    for (const core::Camera& camera : cameras) {
        const Eigen::Vector3d axis = camera.cameraFromWorld.rotation.row(2);
        most = std::max(most, axis.cross(point - camera.centreInWorld()).norm());
    }
    return {point, most};
}

TEST(LabCalibrations, PointsOfDannceProjectOnTheirLabels) {
    const fs::path path = kLabs / "dannce_label3d_dannce.mat";
    if (!fs::exists(path))
        GTEST_SKIP() << "the data is not at " << path;
    core::CalibrationOptions options;
    options.assumeSize = true;
    const std::vector<core::Camera> cameras = core::readCalibration(path, options);
    ASSERT_EQ(cameras.size(), 6u);
    EXPECT_NEAR(cameras[0].intrinsics(0, 1), -5.8, 0.05) << "the skew is kept";
    EXPECT_LT(std::abs(cameras[0].size.width - 1152), 200);
    const core::MatFile file(path);
    const core::MatValue labels = file.read("labelData");
    ASSERT_EQ(labels.count(), cameras.size());
    for (std::size_t c = 0; c < cameras.size(); ++c) {
        const core::MatNumbers places = labels.element(c).member("data_2d").numbers(),
                               points = labels.element(c).member("data_3d").numbers();
        double mostPx = 0;
        int count = 0;
        for (std::size_t row = 0; row < places.size(0); ++row) {
            for (std::size_t joint = 0; joint < places.size(1) / 2; ++joint) {
                const Eigen::Vector3d point(points.at(row, 3 * joint), points.at(row, 3 * joint + 1),
                                            points.at(row, 3 * joint + 2));
                const Eigen::Vector2d place(places.at(row, 2 * joint), places.at(row, 2 * joint + 1));
                if (!point.allFinite() || !place.allFinite())
                    continue;
                const auto px = core::project(cameras[c], point);
                ASSERT_TRUE(px);
                mostPx = std::max(mostPx, (*px + Eigen::Vector2d::Ones() - place).norm());
                ++count;
            }
        }
        EXPECT_GT(count, 100);
        EXPECT_LT(mostPx, 0.01) << cameras[c].name << ", " << count << " labels";
    }
}

TEST(LabCalibrations, QualisysCamerasLookIntoTheVolumeFromAboveTheFloor) {
    const fs::path path = kLabs / "pose2sim_Calib.qca.txt";
    if (!fs::exists(path))
        GTEST_SKIP() << "the data is not at " << path;
    const std::vector<core::Camera> cameras = core::readCalibration(path);
    ASSERT_EQ(cameras.size(), 4u);
    const auto [point, distanceMm] = meetingPoint(cameras);
    EXPECT_LT(distanceMm, 400) << "their axes meet";
    for (const core::Camera& camera : cameras) {
        EXPECT_EQ(camera.size, (core::ImageSize{1088, 1920}));
        // A person stands upright there: head above feet in the picture, all of it within.
        const auto feet = core::project(camera, {point.x(), point.y(), 100}),
                   head = core::project(camera, {point.x(), point.y(), 1700});
        ASSERT_TRUE(feet && head) << camera.name;
        EXPECT_TRUE(core::isInside(camera.size, *feet) && core::isInside(camera.size, *head)) << camera.name;
        EXPECT_GT(feet->y() - head->y(), 500) << camera.name;
        EXPECT_LT((camera.intrinsics.topRightCorner<2, 1>() - Eigen::Vector2d(543.5, 959.5)).norm(), 60)
            << camera.name << ": the principal point is near the middle, in pixels";
    }
    EXPECT_TRUE(core::calibrationNotes(path, {}, cameras).empty());
}

} // namespace
