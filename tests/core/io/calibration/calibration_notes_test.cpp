// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/geometry/camera_target.h"
#include "core/io/calibration/calibration.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/io/calibration/cameras_file.h"
#include "tests/support/camera_ring.h"
#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using enum core::ErrorCode;

std::vector<core::Camera> ringInUnits(double mmPerUnit) {
    std::vector<core::Camera> cameras = test::cameraRing(4);
    for (core::Camera& camera : cameras)
        camera.cameraFromWorld.translation /= mmPerUnit;
    return cameras;
}

TEST(UnitNote, NamesTheOptionForMetresAndCentimetres) {
    EXPECT_EQ(core::unitNote(ringInUnits(1)), "");
    EXPECT_NE(core::unitNote(ringInUnits(1000)).find("metres? Then give --mm-per-unit 1000"), std::string::npos)
        << core::unitNote(ringInUnits(1000));
    EXPECT_NE(core::unitNote(ringInUnits(10)).find("centimetres? Then give --mm-per-unit 10"), std::string::npos);
    EXPECT_NE(core::unitNote(ringInUnits(0.001), 1000).find("millimetres? Then give --mm-per-unit 1"),
              std::string::npos);
    EXPECT_EQ(core::unitNote({test::cameraRing(1)[0]}), "");
    // A stereo camera: parallel axes, 65 mm apart.
    std::vector<core::Camera> pair(2, test::cameraRing(1)[0]);
    pair[1].cameraFromWorld.translation.x() -= 65;
    EXPECT_EQ(core::unitNote(pair), "");
    pair[1].cameraFromWorld.translation = pair[0].cameraFromWorld.translation - Eigen::Vector3d(0.065, 0, 0);
    EXPECT_NE(core::unitNote(pair).find("--mm-per-unit 1000"), std::string::npos);
}

TEST(UnitNote, WorksOnAFileAndGoesWithTheOption) {
    const test::TemporaryFolder folder;
    core::writeCameras(folder / "metres.json", ringInUnits(1000));
    core::CalibrationOptions options;
    EXPECT_EQ(
        core::calibrationNotes(folder / "metres.json", options, core::readCalibration(folder / "metres.json", options))
            .size(),
        1u);
    options.mmPerUnit = 1000;
    EXPECT_TRUE(
        core::calibrationNotes(folder / "metres.json", options, core::readCalibration(folder / "metres.json", options))
            .empty());
}

TEST(LensNotes, SayInHowMuchOfTheImageAFoldedLensHolds) {
    std::vector<core::Camera> cameras = test::cameraRing(3);
    EXPECT_TRUE(core::lensNotes(cameras).empty());
    core::Camera& camera = cameras[1];
    camera.size = {1280, 960};
    camera.intrinsics << 1000, 0, 639.5, 0, 1000, 479.5, 0, 0, 1;
    camera.distortion = {-0.96, 0, 0, 0};
    EXPECT_EQ(core::lensNotes(cameras),
              std::vector<std::string>{camera.name + ": the lens model holds in 39 % of the image"});
}

class Handpose3d : public testing::Test {
protected:
    void write(const std::string& intrinsics, const std::string& pose, double tx) {
        test::writeText(m_folder / intrinsics, "intrinsic:\n926.5 0.0 356.25 \n0.0 925.75 355.5 \n0.0 0.0 1.0 "
                                               "\ndistortion:\n-0.01 1.4 -0.003 -0.0035 -6.25 \n\n");
        test::writeText(m_folder / pose,
                        "R:\n0 -1 0\n1 0 0\n0 0 1\nT:\n" + std::to_string(tx) +
                            "\n2\n30\n\n#below is from cam0 to cam1.\nR:\n9 9 9\n9 9 9\n9 9 9\nT:\n7\n7\n7\n");
    }

    test::TemporaryFolder m_folder;
    core::CalibrationOptions m_options{"", core::ImageSize{720, 720}, std::nullopt, ""};
};

TEST_F(Handpose3d, FilesComeInPairs) {
    write("c0.dat", "rot_trans_c0.dat", 1.5);
    write("c1.dat", "rot_trans_c1.dat", -4);
    test::writeText(m_folder / "lonely.dat", "nothing");
    for (const fs::path& path : {m_folder.path(), m_folder / "c0.dat", m_folder / "rot_trans_c1.dat"}) {
        EXPECT_EQ(core::sniffCalibration(path), "handpose3d");
        const std::vector<core::Camera> cameras = core::readCalibration(path, m_options);
        ASSERT_EQ(cameras.size(), 2u);
        EXPECT_EQ(cameras[0].name, "c0");
        EXPECT_EQ(cameras[1].name, "c1");
        EXPECT_EQ(cameras[0].size, (core::ImageSize{720, 720}));
        EXPECT_EQ(cameras[0].intrinsics(1, 2), 355.5);
        EXPECT_EQ(cameras[0].distortion, (std::vector<double>{-0.01, 1.4, -0.003, -0.0035, -6.25}));
        EXPECT_EQ(cameras[0].cameraFromWorld.rotation(0, 1), -1) << "the first block, not transposed";
        EXPECT_EQ(cameras[1].cameraFromWorld.translation, Eigen::Vector3d(-40, 20, 300)) << "centimetres";
        EXPECT_NE(core::calibrationNotes(path, m_options, cameras).at(0).find("--mm-per-unit"), std::string::npos);
    }
    m_options.mmPerUnit = 45;
    EXPECT_EQ(core::readCalibration(m_folder.path(), m_options)[1].cameraFromWorld.translation.z(), 1350);
    test::expectError([&] { core::readCalibration(m_folder.path()); }, BadInput, m_folder.path().string(),
                      "--size WxH");
}

TEST_F(Handpose3d, FindsOtherNamesAndRefusesBrokenFiles) {
    write("camera0_intrinsics.dat", "camera0_rot_trans.dat", 0);
    EXPECT_EQ(core::readCalibration(m_folder.path(), m_options).at(0).name, "camera0");
    test::writeText(m_folder / "camera0_rot_trans.dat", "R:\n1 0 0\n0 1 0\n");
    test::expectError([&] { core::readCalibration(m_folder.path(), m_options); }, BadInput, "camera0_rot_trans.dat",
                      "R");
    test::writeText(m_folder / "camera0_rot_trans.dat", "R:\n1 0 x\n0 1 0\n0 0 1\nT:\n1\n2\n3\n");
    test::expectError([&] { core::readCalibration(m_folder.path(), m_options); }, BadInput, "camera0_rot_trans.dat",
                      "'x' is not a finite number");
    test::writeText(m_folder / "camera0_rot_trans.dat", "T:\n1\n2\n3\n");
    test::expectError([&] { core::readCalibration(m_folder.path(), m_options); }, BadInput, "camera0_rot_trans.dat",
                      "R: is missing");
    m_options.kind = "handpose3d";
    const test::TemporaryFolder empty;
    test::expectError([&] { core::readCalibration(empty.path(), m_options); }, NotFound, empty.path().string(),
                      "no pair of files");
}

TEST(Handpose3dFootage, CamerasLookAtOnePlaceAndSeeIt) {
    const fs::path folder = fs::path(HANDLENS_SHARED_DATA) / "handpose3d";
    if (!fs::exists(folder / "c0.dat"))
        GTEST_SKIP() << "the data is not at " << folder;
    core::CalibrationOptions options{"", core::ImageSize{720, 720}, 45.0, ""};
    const std::vector<core::Camera> cameras = core::readCalibration(folder, options);
    ASSERT_EQ(cameras.size(), 2u);
    const auto target = core::commonTarget(cameras);
    ASSERT_TRUE(target);
    for (const core::Camera& camera : cameras) {
        const auto px = core::project(camera, *target);
        ASSERT_TRUE(px);
        EXPECT_TRUE(core::isInside(camera.size, *px)) << camera.name;
        EXPECT_NEAR((camera.centreInWorld() - *target).norm(), 700, 300);
    }
    EXPECT_EQ(core::unitNote(cameras), "");
}

} // namespace
