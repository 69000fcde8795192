// SPDX-License-Identifier: MIT
#include "core/io/dataset/frames.h"
#include "core/io/files/file_pattern.h"

#include <thread>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "core/contour/rasteriser.h"
#include "core/contour/shaded_image.h"
#include "core/io/footage/image_file.h"
#include "core/io/footage/video_file.h"
#include "tests/support/expect_error.h"
#include "tests/support/small_dataset.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using enum core::ErrorCode;

/// A picture that says which frame it is: four squares of black or white, the bits of the number.
cv::Mat numbered(int number, cv::Size size) {
    cv::Mat image(size, CV_8UC3, cv::Scalar(90, 90, 90));
    for (int bit = 0; bit < 4; ++bit) {
        const cv::Rect square(bit * size.width / 4, 0, size.width / 4, size.height);
        image(square).setTo((number >> bit & 1) ? cv::Scalar(255, 255, 255) : cv::Scalar(0, 0, 0));
    }
    return image;
}

int numberIn(const cv::Mat& image) {
    int number = 0;
    for (int bit = 0; bit < 4; ++bit)
        number |= (image.at<cv::Vec3b>(image.rows / 2, (2 * bit + 1) * image.cols / 8)[1] > 127 ? 1 : 0) << bit;
    return number;
}

class Frames : public testing::Test {
protected:
    Frames() {
        m_small.dataset.folder = m_folder.path();
        for (core::Camera& camera : m_small.dataset.cameras)
            camera.size = {64, 48};
    }

    core::ViewSource& view(std::size_t camera) { return m_small.dataset.sequences[0].views[camera]; }
    core::FrameSource source() { return {m_small.dataset, m_small.dataset.sequences[0], m_small.motions[0]}; }

    /// A video of `count` numbered frames; false if this machine's OpenCV cannot write it.
    bool writeVideo(const std::string& name, int count, const char* codec) {
        cv::VideoWriter writer((m_folder / name).string(),
                               cv::VideoWriter::fourcc(codec[0], codec[1], codec[2], codec[3]), 25, {64, 48});
        for (int i = 0; i < count; ++i)
            writer.write(numbered(i, {64, 48}));
        return writer.isOpened();
    }

    test::TemporaryFolder m_folder;
    test::SmallDataset m_small = test::smallDataset();
};

TEST_F(Frames, ReadImagesByPatternAndOffset) {
    view(0) = {"cam0", core::ViewKind::Images, "pictures/{camera}_{frame:04}.png", 2};
    fs::create_directory(m_folder / "pictures");
    for (int i = 0; i < 7; ++i)
        core::writePng(m_folder / ("pictures/cam0_000" + std::to_string(i) + ".png"), numbered(i, {64, 48}));
    const core::FrameSource frames = source();
    EXPECT_EQ(frames.kind(0), core::ViewKind::Images);
    for (int f = 0; f < 5; ++f)
        EXPECT_EQ(numberIn(frames.read(0, f)), f + 2);
}

TEST_F(Frames, ReadVideosExactlyWhateverTheOrder) {
    for (const auto& [name, codec] : {std::pair("a.avi", "MJPG"), std::pair("a.mp4", "mp4v")}) {
        if (!writeVideo(name, 16, codec))
            GTEST_SKIP() << "OpenCV cannot write " << codec << " here";
        m_small.dataset.sequences[0].frameCount = 14;
        view(1) = {"cam1", core::ViewKind::Video, name, 1};
        const core::FrameSource frames = source();
        for (const int f : {0, 13, 5, 4, 12, 3, 3, 11})
            EXPECT_EQ(numberIn(frames.read(1, f)), f + 1) << name;
    }
}

TEST_F(Frames, KeepTheIndexOfAVideoAndSurviveABrokenOne) {
    if (!writeVideo("a.avi", 8, "MJPG"))
        GTEST_SKIP() << "OpenCV cannot write MJPG here";
    view(0) = {"cam0", core::ViewKind::Video, "a.avi", 0};
    EXPECT_EQ(numberIn(source().read(0, 3)), 3);
    const fs::path index = m_folder / ".cache/first-cam0.videoindex";
    ASSERT_TRUE(fs::exists(index));
    EXPECT_EQ(numberIn(source().read(0, 4)), 4);
    test::writeText(index, "no index");
    EXPECT_EQ(numberIn(source().read(0, 2)), 2);
    // Another video under the same name must not be read with the old index.
    fs::remove(m_folder / "a.avi");
    ASSERT_TRUE(writeVideo("a.avi", 12, "MJPG"));
    m_small.dataset.sequences[0].frameCount = 12;
    EXPECT_EQ(numberIn(source().read(0, 11)), 11);
}

TEST_F(Frames, RenderTheRecordedMotion) {
    for (core::Camera& camera : m_small.dataset.cameras)
        camera.size = {1080, 1920};
    const core::FrameSource frames = source();
    const cv::Mat image = frames.read(2, 3);
    const cv::Mat wanted =
        core::renderHandsShaded(m_small.dataset.cameras[2], m_small.dataset.hands, m_small.motions[0][3]);
    EXPECT_EQ(cv::norm(image, wanted, cv::NORM_INF), 0);
    EXPECT_GT(cv::norm(image, frames.read(2, 0), cv::NORM_INF), 30);
}

TEST_F(Frames, ShowABackdropWhereThereIsNoPicture) {
    view(0).kind = core::ViewKind::None;
    const cv::Mat image = source().read(0, 0);
    EXPECT_EQ(image.size(), cv::Size(64, 48));
    EXPECT_EQ(image.type(), CV_8UC3);
}

TEST_F(Frames, AreTheSameFromSeveralThreads) {
    if (!writeVideo("a.avi", 16, "MJPG"))
        GTEST_SKIP() << "OpenCV cannot write MJPG here";
    m_small.dataset.sequences[0].frameCount = 16;
    view(0) = {"cam0", core::ViewKind::Video, "a.avi", 0};
    view(1) = {"cam1", core::ViewKind::Video, "a.avi", 0};
    const core::FrameSource frames = source();
    std::vector<std::thread> threads;
    std::atomic<int> wrong{0};
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&, t] {
            for (int i = 0; i < 20; ++i) {
                const int frame = (7 * i + 3 * t) % 16;
                wrong += numberIn(frames.read(t % 2, frame)) != frame;
            }
        });
    }
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(wrong, 0);
}

TEST_F(Frames, SayWhatIsMissingOrWrong) {
    view(0) = {"cam0", core::ViewKind::Images, "none_{frame}.png", 0};
    view(1) = {"cam1", core::ViewKind::Video, "text.avi", 0};
    view(2) = {"cam2", core::ViewKind::Images, "large.png", 0};
    test::writeText(m_folder / "text.avi", "some text");
    core::writePng(m_folder / "large.png", numbered(0, {65, 48}));
    const core::FrameSource frames = source();
    test::expectError([&] { frames.read(0, 3); }, NotFound, "none_3.png", "no such file");
    test::expectError([&] { frames.read(1, 0); }, BadInput, "text.avi", "not a readable video");
    test::expectError([&] { frames.read(2, 0); }, BadInput, "large.png", "65 x 48, but cam2 is calibrated for 64 x 48");
    test::expectError([&] { frames.read(2, 5); }, NotFound, "frame 5", "0 to 4");
    test::expectError([&] { frames.read(2, -1); }, NotFound, "frame -1", "0 to 4");
    test::writeText(m_folder / "none_0.png", "");
    test::expectError([&] { frames.read(0, 0); }, BadInput, "none_0.png", "not a readable picture");
}

TEST_F(Frames, EndWhereTheVideoEnds) {
    if (!writeVideo("short.avi", 4, "MJPG"))
        GTEST_SKIP() << "OpenCV cannot write MJPG here";
    view(0) = {"cam0", core::ViewKind::Video, "short.avi", 0};
    test::expectError([&] { source().read(0, 4); }, NotFound, "short.avi: frame 4", "frames 0 to 3");
    const core::VideoInfo info = core::readVideoInfo(m_folder / "short.avi");
    EXPECT_EQ(info.frames, 4);
    EXPECT_EQ(info.size, (core::ImageSize{64, 48}));
    EXPECT_NEAR(info.framesPerSecond, 25, 1e-6);
    test::expectError([&] { core::readVideoInfo(m_folder / "none.avi"); }, NotFound, "none.avi", "no such video");
}

TEST(Video, OfRealFootageIsReadFrameExactly) {
    const fs::path file = fs::path(HANDLENS_SHARED_DATA) / "handpose3d/cam0_test.mp4";
    if (!fs::exists(file))
        GTEST_SKIP() << "the footage is not at " << file;
    core::VideoFile video(file, {});
    EXPECT_EQ(video.info().frames, 378);
    EXPECT_EQ(video.info().size, (core::ImageSize{720, 720}));
    // Decoding from the start is the oracle of jumping about.
    cv::VideoCapture capture(file.string());
    std::vector<cv::Mat> straight;
    for (cv::Mat frame; straight.size() < 60 && capture.read(frame);)
        straight.push_back(frame.clone());
    ASSERT_EQ(straight.size(), 60u);
    for (const int f : {50, 0, 37, 36, 59, 1}) {
        const cv::Mat frame = video.read(f);
        const auto difference = [&](int other) {
            return cv::norm(frame, straight[static_cast<std::size_t>(other)], cv::NORM_L1) /
                   static_cast<double>(frame.total());
        };
        EXPECT_LT(difference(f), 6) << f; // two conversions from YUV differ a little
        EXPECT_LT(difference(f), difference(f < 59 ? f + 1 : f - 1)) << f;
    }
}

TEST(FillPattern, ReplacesCameraAndFrame) {
    EXPECT_EQ(core::fillPattern("{camera}/{frame}.png", "cam3", 7), "cam3/7.png");
    EXPECT_EQ(core::fillPattern("a_{frame:06}_{frame:3}.jpg", "c", 42), "a_000042_042.jpg");
    EXPECT_EQ(core::fillPattern("plain.png", "c", 1), "plain.png");
    EXPECT_EQ(core::fillPattern("{camera}", "{camera}", 1), "{camera}");
}

TEST(ImageFile, MasksAreBinary) {
    const test::TemporaryFolder folder;
    cv::Mat grey(4, 6, CV_8U, cv::Scalar(0));
    grey.at<uchar>(1, 2) = 1;
    grey.at<uchar>(3, 5) = 200;
    core::writePng(folder / "m.png", grey);
    const cv::Mat mask = core::readMask(folder / "m.png");
    EXPECT_EQ(cv::countNonZero(mask), 2);
    EXPECT_EQ(mask.at<uchar>(1, 2), 255);
    EXPECT_EQ(core::readImage(folder / "m.png").type(), CV_8UC3);
}

} // namespace
