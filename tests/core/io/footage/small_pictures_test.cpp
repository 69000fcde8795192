// SPDX-License-Identifier: MIT
// Small pictures that outlast the program, and the survey of a video that makes them.
#include "core/io/footage/small_pictures.h"

#include <fstream>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/io/footage/video_file.h"
#include "tests/support/recordings/numbered_video.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

constexpr core::FileStamp kVideo{1000, 7};
const cv::Size kSize(64, 48);

/// A picture that compresses badly, so that all take about as much room; its corner tells the frame.
cv::Mat pictureOf(int frame) {
    cv::Mat picture(kSize, CV_8UC3);
    cv::RNG(static_cast<std::uint64_t>(frame + 1)).fill(picture, cv::RNG::UNIFORM, 0, 255);
    picture(cv::Rect(0, 0, 32, 32)).setTo(cv::Scalar::all(frame));
    return picture;
}

int frameOf(const cv::Mat& picture) {
    return picture.empty() ? -1 : static_cast<int>(cv::mean(picture(cv::Rect(0, 0, 16, 16)))[0] + 0.5);
}

class SmallPictures : public testing::Test {
protected:
    core::SmallPictures open(const core::FileStamp& video = kVideo) { return {m_file, video, kSize}; }
    void keep(int first, int count) {
        core::SmallPictures pictures = open();
        pictures.setBudget(1 << 20, 1 << 20);
        for (int frame = first; frame < first + count; ++frame)
            pictures.keep(frame, pictureOf(frame), 0);
    }

    test::TemporaryFolder m_folder;
    fs::path m_file = m_folder / "a.smallpictures";
};

TEST_F(SmallPictures, OutlastTheProgram) {
    keep(10, 5);
    keep(100, 3);
    core::SmallPictures pictures = open();
    for (const int frame : {10, 12, 14, 100, 102})
        EXPECT_EQ(frameOf(pictures.find(frame)), frame);
    EXPECT_EQ(pictures.find(12).size(), kSize);
    EXPECT_TRUE(pictures.find(15).empty());
    EXPECT_FALSE(pictures.has(15));
}

TEST_F(SmallPictures, OfAnotherVideoOrSizeAreForgotten) {
    keep(10, 5);
    EXPECT_TRUE(open({1001, 7}).find(10).empty());
    keep(10, 5);
    EXPECT_TRUE(open({1000, 8}).find(10).empty());
    keep(10, 5);
    EXPECT_TRUE(core::SmallPictures(m_file, kVideo, cv::Size(64, 47)).find(10).empty());
    EXPECT_EQ(fs::file_size(m_file), std::string("handlens-small-pictures-1\n").size() + 24);
}

TEST_F(SmallPictures, OfAFileThatBreaksOffAreThoseBefore) {
    keep(0, 4);
    fs::resize_file(m_file, fs::file_size(m_file) - 5);
    {
        core::SmallPictures pictures = open();
        EXPECT_EQ(frameOf(pictures.find(2)), 2);
        EXPECT_FALSE(pictures.has(3));
    }
    keep(3, 1);
    core::SmallPictures pictures = open();
    for (int frame = 0; frame < 4; ++frame)
        EXPECT_EQ(frameOf(pictures.find(frame)), frame);
}

TEST_F(SmallPictures, AreNotShownDamaged) {
    keep(0, 3);
    const auto each = (fs::file_size(m_file) - 50) / 3;
    std::fstream stream(m_file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(50 + each + each / 2)); // in the middle of the second
    stream.put('\x11').put('\x22');
    stream.close();
    core::SmallPictures pictures = open();
    EXPECT_EQ(frameOf(pictures.find(0)), 0);
    EXPECT_TRUE(pictures.find(1).empty());
    EXPECT_FALSE(pictures.has(1));
    EXPECT_EQ(frameOf(pictures.find(2)), 2);
    pictures.setBudget(1 << 20, 1 << 20);
    pictures.keep(1, pictureOf(1), 0);
    EXPECT_EQ(frameOf(pictures.find(1)), 1) << "kept anew";
}

TEST_F(SmallPictures, AnyFileInTheirPlaceIsBegunAnew) {
    for (const std::string& text : {std::string(), std::string("text"), std::string(500, 'x')}) {
        test::writeText(m_file, text);
        keep(5, 1);
        EXPECT_EQ(frameOf(open().find(5)), 5) << text.size();
    }
}

TEST_F(SmallPictures, FarOnesGoWhereRoomIsShort) {
    for (const bool isInFile : {true, false}) {
        core::SmallPictures pictures(isInFile ? m_file : fs::path(), kVideo, kSize);
        pictures.setBudget(isInFile ? 0 : 100'000, isInFile ? 100'000 : 0);
        int kept = 0;
        while (pictures.hasRoomFor(kept, 0)) {
            pictures.keep(kept, pictureOf(kept), 0);
            ASSERT_LT(++kept, 200);
        }
        ASSERT_GT(kept, 10);
        EXPECT_FALSE(pictures.hasRoomFor(kept, 0));
        EXPECT_TRUE(pictures.hasRoomFor(200, 205)) << "who looks elsewhere wants others";
        for (int frame = 200; frame < 200 + kept; ++frame)
            pictures.keep(frame, pictureOf(frame), 205);
        EXPECT_FALSE(pictures.has(0));
        for (int frame = 205; frame < 200 + kept / 2; ++frame)
            EXPECT_EQ(frameOf(pictures.find(frame)), frame) << isInFile;
        if (isInFile)
            EXPECT_LE(fs::file_size(m_file), 100'100u);
    }
    core::SmallPictures pictures = open();
    EXPECT_EQ(frameOf(pictures.find(206)), 206) << "the file that was written anew is whole";
}

TEST_F(SmallPictures, StayInMemoryWhereTheFileIsInUseOrCannotBeWritten) {
    core::SmallPictures first = open();
    first.setBudget(1 << 20, 1 << 20);
    first.keep(1, pictureOf(1), 0);
    const auto size = fs::file_size(m_file);
    for (const fs::path& file : {m_file, m_folder / "nowhere" / "b.smallpictures"}) {
        core::SmallPictures second(file, kVideo, kSize);
        second.setBudget(1 << 20, 1 << 20);
        second.keep(2, pictureOf(2), 0);
        EXPECT_EQ(frameOf(second.find(2)), 2);
    }
    EXPECT_EQ(fs::file_size(m_file), size);
    EXPECT_EQ(frameOf(first.find(1)), 1);
}

class VideoSurvey : public testing::Test {
protected:
    void SetUp() override {
        if (!test::hasFfmpeg())
            GTEST_SKIP() << "ffmpeg is not installed";
    }
    fs::path encode(const std::string& name, const std::string& options) {
        EXPECT_TRUE(test::encodeNumbered(m_folder / name, options, test::countTo(120))) << name;
        return m_folder / name;
    }
    test::TemporaryFolder m_folder;
};

TEST_F(VideoSurvey, KeepsEveryFrameSmallForTheNextRun) {
    for (const auto& [name, options] :
         {std::pair("a.mp4", "-c:v libx264 -bf 2 -g 30 -sc_threshold 0 -pix_fmt yuv420p"),
          std::pair("a.ts", "-c:v libx264 -bf 3 -x264-params open-gop=1:keyint=30 -pix_fmt yuv420p"),
          std::pair("a.avi", "-c:v mpeg4 -g 40 -qscale:v 2")}) {
        const fs::path file = encode(name, options), index = m_folder / (std::string(name) + ".videoindex");
        {
            core::VideoFile video(file, index, 1);
            video.setBudget(4 << 20);
            EXPECT_EQ(test::numberInPicture(video.read(70)), 70);
            int steps = 0;
            while (video.survey(20, 1000, {}))
                ASSERT_LT(++steps, 200);
            EXPECT_EQ(test::numberInPicture(video.read(71)), 71) << "reading goes on";
        }
        core::VideoFile video(file, index, 1);
        video.setBudget(4 << 20);
        for (int frame = 20; frame < 120; ++frame)
            ASSERT_EQ(test::numberInPicture(video.keptSmall(frame)), frame) << name;
        const auto glance = video.glance(100);
        ASSERT_TRUE(glance) << name;
        EXPECT_EQ(glance->frame, 100);
        EXPECT_FALSE(video.survey(20, 1000, {})) << "nothing is left to do";
        video.read(100);
        EXPECT_FALSE(video.glance(101)) << "reading it is quick";
        EXPECT_TRUE(video.glance(101, true)) << "but not as quick";
        EXPECT_FALSE(video.glance(100, true)) << "it is decoded";
    }
}

TEST_F(VideoSurvey, BeginsWhereSomeoneLooksAndStaysInTheRange) {
    core::VideoFile video(encode("a.mp4", "-c:v libx264 -bf 0 -g 20 -sc_threshold 0 -pix_fmt yuv420p"), {}, 1);
    EXPECT_FALSE(video.survey(0, 119, {})) << "without a budget";
    video.setBudget(4 << 20);
    video.read(65);
    ASSERT_TRUE(video.survey(0, 89, {}));
    EXPECT_EQ(test::numberInPicture(video.keptSmall(65)), 65);
    EXPECT_TRUE(video.keptSmall(20).empty());
    std::stop_source stopped;
    stopped.request_stop();
    EXPECT_FALSE(video.survey(0, 89, stopped.get_token()));
    while (video.survey(0, 89, {})) {
    }
    EXPECT_FALSE(video.keptSmall(0).empty());
    EXPECT_FALSE(video.keptSmall(89).empty());
    EXPECT_TRUE(video.keptSmall(91).empty());
}

TEST_F(VideoSurvey, IsNotMadeWhereEveryFrameIsQuick) {
    core::VideoFile video(encode("a.avi", "-c:v mjpeg -qscale:v 3"), {}, 1);
    video.setBudget(4 << 20);
    video.read(65);
    EXPECT_FALSE(video.survey(0, 119, {}));
}

} // namespace
