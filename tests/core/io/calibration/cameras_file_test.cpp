// SPDX-License-Identifier: MIT
#include "core/io/calibration/cameras_file.h"

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"
#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

using test::replaced;

class CamerasFile : public testing::Test {
protected:
    CamerasFile() { core::writeCameras(m_file, test::cameraRing(3)); }

    void expectRefused(const std::string& text, const std::string& field, const std::string& word) {
        test::writeText(m_file, text);
        test::expectError([&] { core::readCameras(m_file); }, core::ErrorCode::BadInput, m_file.string() + ": " + field,
                          word);
    }

    test::TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "cameras.json";
};

TEST_F(CamerasFile, ReadsBackExactlyWhatWasWritten) {
    std::vector<core::Camera> cameras = test::cameraRing(3);
    cameras[1].distortion = {0.1, 0.2, 0.3, 0.4};
    cameras[1].fisheye = true;
    cameras[2].distortion = {};
    core::writeCameras(m_file, cameras);
    const std::vector<core::Camera> read = core::readCameras(m_file);
    ASSERT_EQ(read.size(), cameras.size());
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        EXPECT_EQ(read[i].name, cameras[i].name);
        EXPECT_EQ(read[i].size, cameras[i].size);
        EXPECT_EQ(read[i].intrinsics, cameras[i].intrinsics);
        EXPECT_EQ(read[i].distortion, cameras[i].distortion);
        EXPECT_EQ(read[i].fisheye, cameras[i].fisheye);
        EXPECT_EQ(read[i].cameraFromWorld.rotation, cameras[i].cameraFromWorld.rotation);
        EXPECT_EQ(read[i].cameraFromWorld.translation, cameras[i].cameraFromWorld.translation);
    }
}

TEST_F(CamerasFile, RefusesInvalidCameras) {
    const std::string good = test::readText(m_file);
    expectRefused(replaced(good, "\"cam1\"", "\"cam0\""), "cameras[1].name", "used twice");
    expectRefused(replaced(good, "\"cam1\"", "\"a/b\""), "cameras[1].name", "file name");
    expectRefused(replaced(good, "[1080,1920]", "[0,1920]"), "cameras[0].size", "");
    expectRefused(replaced(good, "[1080,1920]", "[1080.5,1920]"), "cameras[0].size", "");
    expectRefused(replaced(good, "\"K\": [[1800", "\"K\": [[-1800"), "cameras[0].K", "focal");
    expectRefused(replaced(good, "541.3]", "\"x\"]"), "cameras[0].K", "");
    expectRefused(replaced(good, "[0.0,0.0,1.0]]", "[541.0,955.0,1.0]]"), "cameras[0].K", "transposed");
    expectRefused(replaced(good, "-0.0008,0.0]", "-0.0008,0.0,1.0]"), "cameras[0].distortion", "0, 4, 5 or 8");
    expectRefused(replaced(good, "\"fisheye\": false", "\"fisheye\": true"), "cameras[0].distortion", "fisheye");
    expectRefused(replaced(good, "\"t\"", "\"tt\""), "cameras[0]", "'t'");
    expectRefused(replaced(good, "\"cameras\"", "\"camera\""), "", "cameras");
    expectRefused(good.substr(0, good.size() / 2), "", "ends too early");
}

TEST_F(CamerasFile, RefusesReflectionsAndSkewedAxes) {
    std::vector<core::Camera> cameras = test::cameraRing(2);
    const auto refuse = [&](const std::string& word) {
        test::expectError([&] { core::checkCameras(cameras, "f.json"); }, core::ErrorCode::BadInput,
                          "f.json: cameras[1].R", word);
    };
    cameras[1].cameraFromWorld.rotation *= -1;
    refuse("reflection");
    cameras[1].cameraFromWorld.rotation = Eigen::Matrix3d::Identity();
    cameras[1].cameraFromWorld.rotation(0, 1) = 0.01;
    refuse("not a rotation");
    cameras[1].cameraFromWorld.rotation.setConstant(std::nan(""));
    refuse("not a rotation");
}

TEST_F(CamerasFile, WritesNothingThatItWouldNotRead) {
    std::vector<core::Camera> cameras = test::cameraRing(1);
    cameras[0].size = {0, 5};
    const std::filesystem::path other = m_folder / "other.json";
    EXPECT_THROW(core::writeCameras(other, cameras), core::Error);
    EXPECT_FALSE(std::filesystem::exists(other));
}

} // namespace
