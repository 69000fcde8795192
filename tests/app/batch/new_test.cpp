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

class New : public testing::Test {
protected:
    New() {
        std::vector<core::Camera> cameras = test::cameraRing(2);
        for (core::Camera& camera : cameras)
            camera.size = {32, 24};
        core::writeCameras(m_cameras, cameras);
        for (int camera = 0; camera < 2; ++camera) {
            const fs::path folder = m_folder / ("shots" + std::to_string(camera));
            fs::create_directory(folder);
            for (int i = 0; i < 12 - 3 * camera; ++i) {
                core::writePng(folder / ("img_" + std::to_string(i + 95) + ".png"),
                               cv::Mat(24, 32, CV_8UC3, cv::Scalar::all(10 * i + camera)));
            }
        }
    }

    test::TemporaryFolder m_folder;
    std::string m_cameras = m_folder / "cameras.json", m_set = m_folder / "set";
};

TEST_F(New, MakesADatasetOfNumberedImages) {
    const Ended made = runBatch({"new", "--cameras", m_cameras, "--images", "cam0=" + (m_folder / "shots0").string(),
                                 "--images", "cam1=" + (m_folder / "shots1/img_{frame}.png").string(), "--offset",
                                 "cam0=2", "--offset", "cam1=95", "--fps", "30", "--out", m_set});
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_NE(made.out.find("note: cam0 has 1 frame more"), std::string::npos) << made.out;
    EXPECT_EQ(runBatch({"check", m_set}).status, 0);
    const core::Dataset dataset = core::readDataset(m_set);
    ASSERT_EQ(dataset.sequences.size(), 1u);
    EXPECT_EQ(dataset.sequences[0].frameCount, 9);
    EXPECT_EQ(dataset.sequences[0].framesPerSecond, 30);
    const core::FrameSource frames(dataset, dataset.sequences[0], {});
    EXPECT_EQ(frames.read(0, 4).at<cv::Vec3b>(5, 5)[0], 60) << "two pictures later, across 99 to 100";
    EXPECT_EQ(frames.read(1, 8).at<cv::Vec3b>(5, 5)[0], 81);
}

TEST_F(New, TakesTheSizeOfTheFootageWhereTheCalibrationHoldsNone) {
    test::writeText(
        m_folder / "Jarvis_cam0.yaml",
        "%YAML:1.0\n---\nintrinsicMatrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [40, 0, "
        "0, 0, 40, 0, 16, 11, 1]\ndistortionCoefficients: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n   "
        "data: [0, 0, 0, 0, 0]\nR: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [1, 0, 0, 0, 1, "
        "0, 0, 0, 1]\nT: !!opencv-matrix\n   rows: 3\n   cols: 1\n   dt: d\n   data: [0, 0, 500]\n");
    const std::string calibration = m_folder / "Jarvis_cam0.yaml";
    const Ended made = runBatch(
        {"new", "--cameras", calibration, "--images", "Jarvis_cam0=" + (m_folder / "shots0").string(), "--out", m_set});
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(core::readDataset(m_set).cameras[0].size, (core::ImageSize{32, 24}));
    EXPECT_EQ(made.out.find("is assumed"), std::string::npos) << made.out;
    const Ended converted =
        runBatch({"calibration", calibration, "--to", "handlens", "--out", m_folder / "assumed.json"});
    ASSERT_EQ(converted.status, 0) << converted.err;
    EXPECT_NE(converted.out.find("note: the file holds no image size: 33 x 23 is assumed"), std::string::npos)
        << converted.out;
    const Ended checked = runBatch({"check", calibration});
    EXPECT_EQ(checked.status, 0) << checked.err;
    EXPECT_NE(checked.out.find("33 x 23 is assumed"), std::string::npos) << checked.out;
}

TEST_F(New, MakesSequencesWithoutFootageForAnnotationsMadeElsewhere) {
    const Ended made = runBatch({"new", "--cameras", m_cameras, "--frames", "40", "--sequence", "s", "--out", m_set});
    ASSERT_EQ(made.status, 0) << made.err;
    const core::Dataset dataset = core::readDataset(m_set);
    EXPECT_EQ(dataset.sequences[0].frameCount, 40);
    EXPECT_EQ(dataset.sequences[0].views[1].kind, core::ViewKind::None);
    EXPECT_EQ(runBatch({"check", m_set}).status, 0);
    EXPECT_EQ(runBatch({"new", "--cameras", m_cameras, "--out", m_folder / "none"}).status, 2)
        << "nothing says how long";
}

TEST_F(New, AddsSequencesToADataset) {
    const std::string shots = "cam0=" + (m_folder / "shots0").string();
    ASSERT_EQ(runBatch({"new", "--cameras", m_cameras, "--images", shots, "--sequence", "a", "--out", m_set}).status,
              0);
    ASSERT_EQ(runBatch({"new", "--add", m_set, "--images", shots, "--sequence", "b"}).status, 0);
    const core::Dataset dataset = core::readDataset(m_set);
    ASSERT_EQ(dataset.sequences.size(), 2u);
    EXPECT_EQ(dataset.sequences[1].views[1].kind, core::ViewKind::None);
    const Ended again = runBatch({"new", "--add", m_set, "--images", shots, "--sequence", "b"});
    EXPECT_EQ(again.status, 1);
    EXPECT_NE(again.err.find("used twice"), std::string::npos) << again.err;
    EXPECT_EQ(core::readDataset(m_set).sequences.size(), 2u);
}

TEST_F(New, RefusesFootageThatDoesNotFit) {
    const auto refuse = [&](std::vector<std::string> footage, const std::string& word) {
        footage.insert(footage.begin(), {"new", "--cameras", m_cameras, "--out", m_set});
        const Ended ended = runBatch(footage);
        EXPECT_NE(ended.status, 0);
        EXPECT_NE(ended.err.find(word), std::string::npos) << ended.err;
        EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
        EXPECT_FALSE(fs::exists(m_set));
    };
    const std::string shots = (m_folder / "shots0").string();
    refuse({}, "no video and no images");
    refuse({"--images", "cam9=" + shots}, "cam9");
    refuse({"--images", "cam0"}, "CAMERA=VALUE");
    refuse({"--video", "cam0=" + (m_folder / "none.mp4").string()}, "no such video");
    refuse({"--video", "cam0=" + m_cameras}, "not a readable video");
    refuse({"--images", "cam0=" + shots, "--offset", "cam1=3"}, "--offset");
    refuse({"--images", "cam0=" + shots, "--images", "cam1=" + (m_folder / "shots1").string(), "--offset", "cam1=40"},
           "no such file");
    core::writePng(m_folder / "shots1/img_95.png", cv::Mat(24, 33, CV_8UC3, cv::Scalar::all(0)));
    refuse({"--images", "cam1=" + (m_folder / "shots1").string()}, "33 x 24, but cam1 is calibrated for 32 x 24");
    test::writeText(m_folder / "shots0/other.png", "x");
    refuse({"--images", "cam0=" + shots}, "not numbered like the other images");
}

TEST(RealFootage, BecomesADataset) {
    const fs::path footage = fs::path(HANDLENS_SHARED_DATA) / "handpose3d";
    if (!fs::exists(footage / "cam0_test.mp4"))
        GTEST_SKIP() << "the footage is not at " << footage;
    const test::TemporaryFolder folder;
    std::vector<core::Camera> cameras = test::cameraRing(2);
    for (core::Camera& camera : cameras)
        camera.size = {720, 720};
    core::writeCameras(folder / "cameras.json", cameras);
    const Ended made = runBatch({"new", "--cameras", folder / "cameras.json", "--video",
                                 "cam0=" + (footage / "cam0_test.mp4").string(), "--video",
                                 "cam1=" + (footage / "cam1_test.mp4").string(), "--out", folder / "set"});
    ASSERT_EQ(made.status, 0) << made.err;
    const core::Dataset dataset = core::readDataset(folder / "set");
    EXPECT_EQ(dataset.sequences[0].frameCount, 378);
    EXPECT_EQ(dataset.sequences[0].framesPerSecond, 30);
    const core::FrameSource frames(dataset, dataset.sequences[0], {});
    EXPECT_EQ(frames.read(1, 377).size(), cv::Size(720, 720));
}

} // namespace
