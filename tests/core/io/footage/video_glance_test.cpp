// SPDX-License-Identifier: MIT
// What is shown while a frame is decoded, pictures that are read small, and recordings whose frames are irregular.
#include <fstream>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/io/footage/video_file.h"
#include "tests/support/expect_error.h"
#include "tests/support/recordings/numbered_video.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

constexpr const char* kGroupsOf50 = "-c:v libx264 -bf 2 -g 50 -sc_threshold 0 -pix_fmt yuv420p";

class VideoGlances : public testing::Test {
protected:
    void SetUp() override {
        if (!test::hasFfmpeg())
            GTEST_SKIP() << "ffmpeg is not installed";
    }
    fs::path encode(const std::string& name, const std::string& options, int count = 200) {
        EXPECT_TRUE(test::encodeNumbered(m_folder / name, options, test::countTo(count))) << name;
        return m_folder / name;
    }

    test::TemporaryFolder m_folder;
};

TEST_F(VideoGlances, AreOfTheFrameThatTheyClaimAndNoFartherThanAKeyPicture) {
    for (const auto& [name, options] : {std::pair("a.mp4", kGroupsOf50), std::pair("a.ts", kGroupsOf50),
                                        std::pair("b.mkv", "-c:v libx265 -preset ultrafast -pix_fmt yuv420p "
                                                           "-x265-params log-level=none:keyint=50:pools=none")}) {
        core::VideoFile video(encode(name, options), {}, 1);
        video.setBudget(4 << 20);
        std::mt19937 random(3);
        int glances = 0;
        for (int i = 0; i < 40; ++i) {
            const int frame = static_cast<int>(random() % 200);
            if (const auto glance = video.glance(frame)) {
                ++glances;
                EXPECT_EQ(glance->picture.size(), cv::Size(test::kNumberedWidth / 4, test::kNumberedHeight / 4));
                EXPECT_EQ(test::numberInPicture(glance->picture), glance->frame) << name;
                EXPECT_LE(std::abs(glance->frame - frame), 50) << name;
            }
            EXPECT_EQ(test::numberInPicture(video.read(frame)), frame) << name << ", unharmed by the glance";
        }
        EXPECT_GT(glances, 10) << name;
    }
}

TEST_F(VideoGlances, AreNotTakenWhereReadingIsQuick) {
    core::VideoFile video(encode("a.mp4", kGroupsOf50), {}, 1);
    video.setBudget(64 << 20);
    video.read(60);
    EXPECT_FALSE(video.glance(60)) << "kept";
    EXPECT_FALSE(video.glance(61)) << "next";
    EXPECT_TRUE(video.glance(140));
    EXPECT_FALSE(video.glance(-1));
    EXPECT_FALSE(video.glance(200));
}

TEST_F(VideoGlances, FramesThatThereWasNoMoreRoomForAreKeptSmall) {
    core::VideoFile video(encode("a.mp4", kGroupsOf50), {}, 1);
    const std::int64_t bytes = std::int64_t(test::kNumberedWidth) * test::kNumberedHeight * 3 / 2;
    video.setBudget(8 * bytes);
    for (int frame = 0; frame < 48; ++frame)
        video.read(frame);
    ASSERT_FALSE(video.isKept(35));
    const auto glance = video.glance(35);
    ASSERT_TRUE(glance);
    EXPECT_EQ(glance->frame, 35);
    EXPECT_EQ(test::numberInPicture(glance->picture), 35);
}

TEST_F(VideoGlances, SmallPicturesAreTheMeansOfLargeOnes) {
    for (const auto& [name, options] :
         {std::pair("a.mp4", "-c:v libx264 -qp 10 -pix_fmt yuv420p"),
          std::pair("odd.mp4", "-vf crop=153:91:0:0:exact=1 "
                               "-c:v mpeg4 -qscale:v 2"),
          std::pair("grey.mkv", "-c:v ffv1 -pix_fmt gray"),
          std::pair("ten.mkv", "-c:v libx265 -pix_fmt yuv420p10le -x265-params log-level=none")}) {
        core::VideoFile video(encode(name, options, 10), {});
        const cv::Mat whole = video.read(7);
        for (const int shrink : {2, 4}) {
            const cv::Mat small = video.read(7, {}, shrink);
            const cv::Size size((whole.cols + shrink - 1) / shrink, (whole.rows + shrink - 1) / shrink);
            ASSERT_EQ(small.size(), size) << name;
            cv::Mat padded, wanted, difference;
            cv::copyMakeBorder(whole, padded, 0, size.height * shrink - whole.rows, 0, size.width * shrink - whole.cols,
                               cv::BORDER_REPLICATE);
            cv::resize(padded, wanted, size, 0, 0, cv::INTER_AREA);
            cv::absdiff(small, wanted, difference);
            EXPECT_LT(cv::mean(difference)[1], 2.5) << name << " " << shrink;
            EXPECT_GT(cv::norm(small, cv::NORM_INF), 200) << "not blank";
        }
    }
}

TEST_F(VideoGlances, MoreThreadsFromTheNextJumpOnChangeNothing) {
    core::VideoFile video(encode("a.mp4", kGroupsOf50), {}, 1);
    std::mt19937 random(5);
    for (int i = 0; i < 20; ++i) {
        video.setThreads(1 + i % 3);
        const int frame = static_cast<int>(random() % 200);
        EXPECT_EQ(test::numberInPicture(video.read(frame)), frame);
    }
}

/// Frames 10 to 19, 33 and 90 to 97 were never recorded; the times tell.
TEST_F(VideoGlances, FramesOfAVariableRateStayInOrderAndKeepTheirTimes) {
    std::vector<int> left;
    for (int i = 0; i < 130; ++i)
        if (!((i >= 10 && i < 20) || i == 33 || (i >= 90 && i < 98)))
            left.push_back(i);
    for (const char* name : {"a.mp4", "a.mkv"}) {
        const fs::path file = encode(name,
                                     "-vf \"select='not(between(n,10,19)+eq(n,33)+between(n,90,97))'\" -vsync vfr "
                                     "-c:v libx264 -bf 2 -g 25 -pix_fmt yuv420p",
                                     130);
        core::VideoFile video(file, {});
        ASSERT_EQ(video.info().frames, static_cast<int>(left.size())) << name;
        ASSERT_EQ(video.info().timesSec.size(), left.size());
        for (const std::size_t i : {std::size_t(0), std::size_t(9), std::size_t(10), std::size_t(60), std::size_t(22),
                                    std::size_t(23), left.size() - 1, std::size_t(78)}) {
            EXPECT_EQ(test::numberInPicture(video.read(static_cast<int>(i))), left[i]) << name;
            EXPECT_NEAR(video.info().timesSec[i] - video.info().timesSec[0], left[i] / 25.0, 2e-3) << name << " " << i;
        }
    }
}

/// A damaged stretch in the middle of a group: the frames that lean on it are named, all others are right.
TEST_F(VideoGlances, ADamagedStretchIsNamedFrameByFrameAndEndsWithTheGroup) {
    const fs::path file = encode("a.mp4", "-c:v libx264 -bf 0 -g 20 -sc_threshold 0 -pix_fmt yuv420p", 100);
    std::string bytes = test::readText(file);
    {
        core::VideoFile whole(file, {});
        ASSERT_EQ(whole.info().frames, 100);
    }
    // Without B-frames the packets lie in order: some of the group from 40 on, in the middle of the file.
    const std::size_t middle = bytes.find("mdat") + (bytes.size() - bytes.find("mdat")) * 46 / 100;
    for (std::size_t i = middle; i < middle + 600; ++i)
        bytes[i] = '\xff';
    test::writeText(m_folder / "b.mp4", bytes);
    core::VideoFile video(m_folder / "b.mp4", {});
    std::vector<int> damaged;
    for (int frame = 0; frame < video.info().frames; ++frame) {
        try {
            const cv::Mat picture = video.read(frame);
            if (frame < 20 || frame >= 80)
                EXPECT_EQ(test::numberInPicture(picture), frame);
        } catch (const core::Error& error) {
            EXPECT_EQ(error.code(), core::ErrorCode::BadInput);
            EXPECT_EQ(error.field(), "frame " + std::to_string(frame));
            damaged.push_back(frame);
        }
    }
    EXPECT_FALSE(damaged.empty());
    for (const int frame : damaged)
        EXPECT_TRUE(frame >= 20 && frame < 80) << frame;
}

TEST_F(VideoGlances, TheHeadersSizeIsThatOfThePictures) {
    const fs::path file = encode("a.mp4", "-c:v mpeg4", 3);
    EXPECT_EQ(core::readVideoSize(file), (core::ImageSize{test::kNumberedWidth, test::kNumberedHeight}));
    test::writeText(m_folder / "no.mp4", "text");
    test::expectError([&] { core::readVideoSize(m_folder / "no.mp4"); }, core::ErrorCode::BadInput, "no.mp4", "");
}

} // namespace
