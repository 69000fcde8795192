// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/io/calibration/cameras_file.h"
#include "core/io/dataset/dataset.h"
#include "core/io/dataset/frames.h"
#include "core/io/footage/image_file.h"
#include "tests/app/batch/program.h"
#include "tests/support/camera_ring.h"
#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::runBatch;

/// Eight calibrated cameras of 64 x 48; footage of two of them, four pictures each, in shots/.
class FootageVerbs : public testing::Test {
protected:
    FootageVerbs() {
        std::vector<core::Camera> cameras = test::cameraRing(8);
        for (core::Camera& camera : cameras)
            camera.size = {64, 48};
        core::writeCameras(m_cameras, cameras);
    }

    void shoot(int camera, cv::Size size) {
        const fs::path folder = m_folder / ("shots/cam" + std::to_string(camera));
        fs::create_directories(folder);
        for (int i = 0; i < 4; ++i) {
            cv::Mat picture(size, CV_8UC3, cv::Scalar::all(10 * i));
            picture.at<cv::Vec3b>(0, 0) = {255, 255, 255};
            core::writePng(folder / (std::to_string(i) + ".png"), picture);
        }
    }
    void writeMask(const std::string& name) {
        fs::create_directories((m_folder / name).parent_path());
        core::writePng(m_folder / name, cv::Mat(48, 64, CV_8U, cv::Scalar(255)));
    }
    Ended make(std::vector<std::string> more) {
        std::vector<std::string> arguments{"new",
                                           "--cameras",
                                           m_cameras,
                                           "--images",
                                           "cam0=" + (m_folder / "shots/cam0").string(),
                                           "--images",
                                           "cam1=" + (m_folder / "shots/cam1").string(),
                                           "--out",
                                           m_set};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runBatch(arguments);
    }

    test::TemporaryFolder m_folder;
    std::string m_cameras = m_folder / "cameras.json", m_set = m_folder / "set";
};

TEST_F(FootageVerbs, NewNamesTheScaleAndTakesIt) {
    shoot(0, {32, 24});
    shoot(1, {48, 64});
    const Ended refused = make({});
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.err.find("use --scale cam0=0.5"), std::string::npos) << refused.err;
    const Ended second = make({"--scale", "cam0=0.5"});
    EXPECT_NE(second.err.find("use --rotate cam1=90 (or 270)"), std::string::npos) << second.err;
    const Ended made = make({"--scale", "cam0=0.5", "--rotate", "cam1=270"});
    ASSERT_EQ(made.status, 0) << made.err;
    const core::Dataset dataset = core::readDataset(m_set);
    const core::Camera before = core::readCameras(m_cameras)[0];
    EXPECT_EQ(dataset.cameras[0].size, (core::ImageSize{32, 24}));
    EXPECT_NEAR(dataset.cameras[0].intrinsics(0, 2), (before.intrinsics(0, 2) + 0.5) * 0.5 - 0.5, 1e-9);
    EXPECT_EQ(dataset.cameras[0].distortion, before.distortion);
    const core::FrameSource frames(dataset, dataset.sequences[0], {});
    EXPECT_EQ(frames.read(1, 3).at<cv::Vec3b>(47, 0)[0], 255) << "the first pixel, turned anticlockwise";
    EXPECT_EQ(runBatch({"check", m_set}).status, 0);
    const Ended added = runBatch({"new", "--add", m_set, "--images", "cam0=" + (m_folder / "shots/cam0").string(),
                                  "--scale", "cam0=0.5", "--sequence", "b"});
    EXPECT_EQ(added.status, 2);
    EXPECT_NE(added.err.find("--scale"), std::string::npos) << added.err;
    for (const char* odd : {"cam0=45", "cam0=", "cam7=90"})
        EXPECT_EQ(make({"--rotate", odd}).status, 2) << odd;
}

TEST_F(FootageVerbs, CamerasWithoutFootageGetNoView) {
    shoot(0, {64, 48});
    shoot(1, {64, 48});
    const Ended made = make({});
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_NE(made.out.find("2 of 8 cameras have footage"), std::string::npos) << made.out;
    const Ended info = runBatch({"info", m_set});
    EXPECT_NE(info.out.find(" 2 views"), std::string::npos) << info.out;
}

TEST_F(FootageVerbs, MasksAreAttachedAtOnceOrLater) {
    shoot(0, {64, 48});
    shoot(1, {64, 48});
    writeMask("m/cam0/2.png");
    writeMask("late/cam1_0003.png");
    const Ended made = make({"--masks", "cam0=" + (m_folder / "m/cam0/{frame}.png").string()});
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_NE(made.out.find("cam0: 1 of 4 frames have a mask"), std::string::npos) << made.out;
    const Ended later = runBatch({"masks", m_set, "--sequence", "1", "--from", "cam1=" + (m_folder / "late").string()});
    ASSERT_EQ(later.status, 0) << later.err;
    const core::Dataset dataset = core::readDataset(m_set);
    EXPECT_FALSE(core::readFrameMasks(dataset.folder, dataset.sequences[0], dataset.cameras, 2)[0].empty());
    EXPECT_FALSE(core::readFrameMasks(dataset.folder, dataset.sequences[0], dataset.cameras, 3)[1].empty());
    const Ended none = runBatch(
        {"masks", m_set, "--sequence", "1", "--from", (m_folder / "shots").string() + "/{camera}_{frame}.png"});
    EXPECT_EQ(none.status, 1);
    EXPECT_EQ(std::count(none.err.begin(), none.err.end(), '\n'), 1) << none.err;
}

TEST_F(FootageVerbs, RelinkFindsWhatHasMoved) {
    shoot(0, {64, 48});
    shoot(1, {64, 48});
    ASSERT_EQ(make({}).status, 0);
    fs::create_directories(m_folder / "archive/2024");
    fs::rename(m_folder / "shots", m_folder / "archive/2024/shots");
    EXPECT_EQ(runBatch({"check", m_set}).status, 1);
    const Ended found = runBatch({"relink", m_set, "--root", m_folder / "archive"});
    ASSERT_EQ(found.status, 0) << found.err;
    EXPECT_NE(found.out.find("1, cam0: found: ../shots/cam0/{frame}.png -> ../archive/2024/shots/cam0/{frame}.png"),
              std::string::npos)
        << found.out;
    EXPECT_EQ(runBatch({"check", m_set}).status, 0);
    EXPECT_NE(runBatch({"relink", m_set, "--root", m_folder / "archive"}).out.find("1, cam1: unchanged"),
              std::string::npos);
    fs::remove_all(m_folder / "archive/2024/shots/cam1");
    const std::string before = test::readText(m_folder / "set/dataset.json");
    const Ended lost = runBatch({"relink", m_set, "--root", m_folder / "archive"});
    EXPECT_EQ(lost.status, 1);
    EXPECT_NE(lost.out.find("1, cam1: not found"), std::string::npos) << lost.out;
    EXPECT_EQ(test::readText(m_folder / "set/dataset.json"), before);
}

TEST_F(FootageVerbs, ACalibrationInMetresIsNoticed) {
    std::vector<core::Camera> cameras = core::readCameras(m_cameras);
    for (core::Camera& camera : cameras)
        camera.cameraFromWorld.translation /= 1000;
    core::writeCameras(m_cameras, cameras);
    shoot(0, {64, 48});
    shoot(1, {64, 48});
    const Ended converted = runBatch({"calibration", m_cameras, "--to", "handlens", "--out", m_folder / "out.json"});
    EXPECT_NE(converted.out.find("note: the cameras are 0.9"), std::string::npos) << converted.out;
    EXPECT_NE(converted.out.find("--mm-per-unit 1000"), std::string::npos) << converted.out;
    const Ended made = make({});
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_NE(made.out.find("--mm-per-unit 1000"), std::string::npos) << made.out;
    EXPECT_NE(runBatch({"check", m_set}).out.find("--mm-per-unit 1000"), std::string::npos);
    fs::remove_all(m_set);
    EXPECT_EQ(make({"--mm-per-unit", "1000"}).out.find("--mm-per-unit"), std::string::npos);
}

TEST_F(FootageVerbs, NamesThatAreNotFileNamesAreRefused) {
    shoot(0, {64, 48});
    shoot(1, {64, 48});
    const Ended refused = make({"--sequence", "../x"});
    EXPECT_NE(refused.status, 0);
    EXPECT_NE(refused.err.find("must be usable as a file name"), std::string::npos) << refused.err;
    EXPECT_FALSE(fs::exists(m_set));
}

} // namespace
