// SPDX-License-Identifier: MIT
#include "core/io/footage/video_file.h"

#include <climits>
#include <csignal>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/io/files/content_hash.h"
#include "core/io/footage/video_indexer.h"
#include "tests/support/expect_error.h"
#include "tests/support/recordings/numbered_video.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using enum core::ErrorCode;

constexpr int kCount = 130;

core::VideoIndex indexOf(const fs::path& file) {
    core::VideoDemuxer video(file);
    return core::indexVideo(video);
}

/// A codec with its options for open or closed groups and B-frames, and the containers that take it.
struct Codec {
    std::string name;
    std::vector<std::string> options;
    std::vector<std::string> containers;
};

void PrintTo(const Codec& codec, std::ostream* stream) {
    *stream << codec.name;
}

std::vector<Codec> codecs() {
    // What ffmpeg writes as HEVC in AVI cannot be read.
    Codec h264{"h264", {}, {"mp4", "mov", "mkv", "ts", "mpg", "avi"}},
        hevc{"hevc", {}, {"mp4", "mov", "mkv", "ts", "mpg"}},
        mpeg2{"mpeg2", {}, {"mp4", "mov", "mkv", "ts", "mpg", "avi"}};
    for (const bool open : {true, false}) {
        for (const char* b : {"0", "3"}) {
            const std::string gop =
                std::string(":open-gop=") + (open ? "1" : "0") + ":keyint=30:min-keyint=10:scenecut=0:bframes=" + b;
            h264.options.push_back("-c:v libx264 -preset veryfast -pix_fmt yuv420p -x264-params threads=1" + gop);
            hevc.options.push_back("-c:v libx265 -preset ultrafast -pix_fmt yuv420p -x265-params "
                                   "log-level=none:pools=none:frame-threads=1" +
                                   gop);
            mpeg2.options.push_back(
                std::string("-c:v mpeg2video -qscale:v 3 -pix_fmt yuv420p -g 15 -sc_threshold 1000000000 -bf ") + b +
                (open ? "" : " -flags +cgop"));
        }
    }
    const Codec vp9{
        "vp9",
        {"-c:v libvpx-vp9 -deadline realtime -cpu-used 8 -g 40 -b:v 400k -auto-alt-ref 1 -lag-in-frames 16"},
        {"mp4", "mkv", "webm", "avi"}};
    const Codec vp8{
        "vp8",
        {"-c:v libvpx -deadline good -cpu-used 8 -threads 2 -g 40 -b:v 600k -auto-alt-ref 1 -lag-in-frames 16"},
        {"mkv", "webm", "avi"}};
    const Codec mpeg4{"mpeg4",
                      {"-c:v mpeg4 -qscale:v 3 -g 30 -bf 2", "-c:v mpeg4 -qscale:v 3 -g 30 -bf 0"},
                      {"mp4", "avi", "mkv", "ts"}};
    const Codec mjpeg{"mjpeg", {"-c:v mjpeg -qscale:v 3 -pix_fmt yuvj420p"}, {"mp4", "mov", "mkv", "avi"}};
    return {h264, hevc, mpeg2, vp9, vp8, mpeg4, mjpeg};
}

/// Reads in random order, backwards and forwards; returns how many frames show another number, or differ from decoding
/// in order.
int wrongFrames(const fs::path& file) {
    core::VideoFile straight(file, {}), jumping(file, {});
    if (straight.info().frames != kCount) {
        ADD_FAILURE() << file << " has " << straight.info().frames << " frames";
        return kCount;
    }
    std::vector<cv::Mat> inOrder;
    int wrong = 0;
    for (int i = 0; i < kCount; ++i) {
        inOrder.push_back(straight.read(i));
        wrong += test::numberInPicture(inOrder.back()) == i ? 0 : 1;
    }
    std::vector<int> order;
    std::mt19937 random(7);
    for (int i = 0; i < 30; ++i)
        order.push_back(static_cast<int>(random() % kCount));
    for (int i = kCount - 1; i >= 0; i -= 3)
        order.push_back(i);
    order.insert(order.end(), {95, 96, 97, 98, 99, 100, 60, 61, 62, 63});
    for (const int i : order)
        wrong += cv::norm(jumping.read(i), inOrder[static_cast<std::size_t>(i)], cv::NORM_INF) == 0 ? 0 : 1;
    return wrong;
}

class VideoOf : public testing::TestWithParam<Codec> {};

TEST_P(VideoOf, ShowsEveryFrameInWhateverOrder) {
    if (!test::hasFfmpeg())
        GTEST_SKIP() << "ffmpeg is not installed";
    const test::TemporaryFolder folder;
    int files = 0;
    for (const std::string& container : GetParam().containers) {
        for (const std::string& options : GetParam().options) {
            const fs::path file = folder / ("a." + container);
            if (test::encodeNumbered(file, options, test::countTo(kCount))) {
                ++files;
                EXPECT_EQ(wrongFrames(file), 0) << container << " " << options;
            }
        }
    }
    EXPECT_GE(files, static_cast<int>(GetParam().containers.size() * GetParam().options.size()) / 2)
        << "this machine's ffmpeg lacks an encoder";
}

INSTANTIATE_TEST_SUITE_P(EveryCodec, VideoOf, testing::ValuesIn(codecs()),
                         [](const auto& one) { return one.param.name; });

class Video : public testing::Test {
protected:
    void SetUp() override {
        if (!test::hasFfmpeg())
            GTEST_SKIP() << "ffmpeg is not installed";
    }

    fs::path encode(const std::string& name, const std::string& options, int count = 60) {
        EXPECT_TRUE(test::encodeNumbered(m_folder / name, options, test::countTo(count))) << name;
        return m_folder / name;
    }

    test::TemporaryFolder m_folder;
};

TEST_F(Video, KeepsItsIndexAndMakesADamagedOrStaleOneAnew) {
    const fs::path file = encode("a.mp4", "-c:v mpeg4 -g 20 -bf 2"), kept = m_folder / ".cache/a.videoindex";
    EXPECT_EQ(test::numberInPicture(core::VideoFile(file, kept).read(33)), 33);
    const std::optional<core::VideoIndex> index = core::readVideoIndex(kept, file);
    ASSERT_TRUE(index);
    EXPECT_EQ(*index, indexOf(file));
    std::string bytes = test::readText(kept);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] + 1);
    for (const std::string& damaged : {bytes, bytes.substr(0, 100), std::string("no index"), std::string()}) {
        test::writeText(kept, damaged);
        EXPECT_FALSE(core::readVideoIndex(kept, file));
        EXPECT_EQ(test::numberInPicture(core::VideoFile(file, kept).read(21)), 21);
        EXPECT_TRUE(core::readVideoIndex(kept, file)) << "made anew";
    }
    encode("a.mp4", "-c:v mpeg4 -g 20", 44);
    EXPECT_FALSE(core::readVideoIndex(kept, file));
    EXPECT_EQ(core::VideoFile(file, kept).info().frames, 44);
}

TEST_F(Video, RefusesAnIndexThatIndexingCannotHaveMade) {
    const fs::path file = encode("a.mp4", "-c:v mpeg4 -g 20", 12), kept = m_folder / "a.videoindex";
    const core::VideoIndex index = indexOf(file);
    const auto isKept = [&](const std::function<void(core::VideoIndex&)>& change) {
        core::VideoIndex changed = index;
        change(changed);
        core::keepVideoIndex(changed, kept); // with the sum that belongs to it, as one who forges it would
        return core::readVideoIndex(kept, file).has_value();
    };
    EXPECT_TRUE(isKept([](core::VideoIndex&) {}));
    EXPECT_TRUE(isKept([](core::VideoIndex& it) { it.timesSec.clear(); }));
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(isKept([&](core::VideoIndex& it) { it.timesSec[3] = kNan; }));
    EXPECT_FALSE(isKept([](core::VideoIndex& it) { it.timesSec[3] = it.timesSec[5]; }));
    EXPECT_FALSE(isKept([](core::VideoIndex& it) { it.timesSec.pop_back(); }));
    EXPECT_FALSE(isKept([&](core::VideoIndex& it) { it.framesPerSecond = kNan; }));
    EXPECT_FALSE(isKept([](core::VideoIndex& it) { it.framesPerSecond = -25; }));
    EXPECT_FALSE(isKept([](core::VideoIndex& it) { it.rotationDegrees = 45; }));
    EXPECT_FALSE(isKept([](core::VideoIndex& it) { it.size.width = INT_MAX; }));
    EXPECT_FALSE(isKept([](core::VideoIndex& it) { it.packetOfPicture[4] = 12; }));
    EXPECT_FALSE(isKept([](core::VideoIndex& it) { std::swap(it.packetOfPicture[4], it.packetOfPicture[5]); }));
    EXPECT_FALSE(isKept([](core::VideoIndex& it) { it.packets[4].picture = -7; }));
    EXPECT_FALSE(isKept([](core::VideoIndex& it) { it.isCounted = true; }));
}

TEST_F(Video, TakesNoMemoryForWhatAnIndexClaims) {
    const fs::path file = encode("a.mp4", "-c:v mpeg4 -g 20", 12), kept = m_folder / "a.videoindex";
    core::keepVideoIndex(indexOf(file), kept);
    const std::string whole = test::readText(kept);
    const std::size_t header = std::string("handlens-video-index-1\n").size() + 8 + 8 + 4 + 4 + 8 + 4 + 1;
    for (const std::uint64_t count : {std::uint64_t(13), std::uint64_t(1'000'000'000), UINT64_MAX}) {
        std::string claimed = whole.substr(0, whole.size() - 8);
        std::memcpy(claimed.data() + header, &count, 8);
        const std::uint64_t sum = core::contentHash(claimed.data(), claimed.size());
        test::writeText(kept, claimed.append(reinterpret_cast<const char*>(&sum), 8));
        EXPECT_FALSE(core::readVideoIndex(kept, file)) << count;
    }
}

TEST_F(Video, OpensNoOtherFileThanItsOwn) {
    const fs::path other = encode("other.ts", "-c:v mpeg2video -g 10", 20);
    EXPECT_EQ(core::VideoFile(other, {}).info().frames, 20);
    for (const char* list : {"ffconcat version 1.0\nfile other.ts\n",
                             "#EXTM3U\n#EXT-X-VERSION:3\n#EXT-X-TARGETDURATION:10\n#EXTINF:0.8,\nother.ts\n"
                             "#EXT-X-ENDLIST\n"}) {
        const fs::path file = m_folder / "a.mp4";
        test::writeText(file, list);
        test::expectError([&] { core::VideoFile(file, {}); }, BadInput, "a.mp4", "not a readable video");
    }
}

TEST_F(Video, RefusesPicturesThatWouldFillTheMemory) {
    const fs::path file = encode("a.avi", "-c:v rawvideo -pix_fmt yuv420p", 3);
    std::string bytes = test::readText(file);
    const std::size_t format = bytes.find("strf") + 8; // BITMAPINFOHEADER: size, width, height
    const std::int32_t size = 30'000;
    std::memcpy(bytes.data() + format + 4, &size, 4);
    std::memcpy(bytes.data() + format + 8, &size, 4);
    test::writeText(file, bytes);
    test::expectError([&] { core::VideoFile(file, {}); }, BadInput, "a.avi", "30000 x 30000 are too large");
}

TEST_F(Video, SaysSoWhenTheFileHasGoneMeanwhile) {
    const fs::path file = encode("a.mp4", "-c:v mpeg4 -g 60", 40);
    core::VideoFile video(file, {});
    video.setBudget(0); // one picture is kept
    EXPECT_EQ(test::numberInPicture(video.read(30)), 30);
    fs::rename(file, m_folder / "elsewhere.mp4");
    for (int time = 0; time < 3; ++time)
        test::expectError([&] { video.read(3); }, BadInput, "a.mp4", "not a readable video");
    fs::rename(m_folder / "elsewhere.mp4", file);
    EXPECT_EQ(test::numberInPicture(video.read(3)), 3);
}

TEST_F(Video, NamesADamagedFrameAndShowsTheOthers) {
    for (const auto& [name, options] :
         {std::pair("a.avi", "-c:v mjpeg"), std::pair("a.mp4", "-c:v libx264 -bf 3 -g 20 -pix_fmt yuv420p"),
          std::pair("b.mp4", "-c:v mpeg4 -g 20")}) {
        const fs::path file = encode(name, options);
        const core::VideoIndex index = indexOf(file);
        // The last picture of a group, on which no other leans.
        const core::VideoPacket& packet = index.packets[39];
        {
            std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
            stream.seekp(packet.position + 8);
            stream << std::string(packet.size - 8, '\xff');
        }
        core::VideoFile video(file, {});
        ASSERT_EQ(video.info().frames, 60) << name;
        for (const int frame : {packet.picture, 59, 12, packet.picture, packet.picture + 1})
            if (frame == packet.picture)
                test::expectError([&] { video.read(frame); }, BadInput, name, "frame " + std::to_string(frame));
            else
                EXPECT_EQ(test::numberInPicture(video.read(frame)), frame) << name;
    }
}

std::vector<int> keptFrames(const core::VideoFile& video) {
    std::vector<int> kept;
    for (int frame = 0; frame < video.info().frames; ++frame)
        if (video.isKept(frame))
            kept.push_back(frame);
    return kept;
}

TEST_F(Video, KeepsPicturesNearTheLastOneWithinItsBudgetAndFetchesThoseAhead) {
    core::VideoFile video(encode("a.mp4", "-c:v libx264 -bf 2 -g 30 -sc_threshold 0 -pix_fmt yuv420p"), {}, 1);
    EXPECT_FALSE(video.fetchAhead(1, {})) << "nothing was read yet";
    constexpr int kPictures = 10;
    const std::int64_t bytes = std::int64_t(video.info().size.width) * video.info().size.height * 3 / 2;
    video.setBudget(kPictures * bytes + bytes / 2);
    std::mt19937 random(3);
    for (const auto& [frame, direction] : {std::pair(40, 1), {36, -1}, {31, -1}, {3, -1}, {45, 1}, {58, 1}}) {
        EXPECT_EQ(test::numberInPicture(video.read(frame)), frame);
        EXPECT_LE(keptFrames(video).size(), std::size_t(kPictures));
        int rounds = 0;
        while (video.fetchAhead(direction, {}) && rounds < 100)
            ++rounds;
        EXPECT_LT(rounds, 2 * kPictures);
        const std::vector<int> kept = keptFrames(video);
        EXPECT_LE(kept.size(), std::size_t(kPictures));
        for (int ahead = 1; ahead <= 4; ++ahead)
            if (frame + direction * ahead >= 0 && frame + direction * ahead < 60)
                EXPECT_TRUE(video.isKept(frame + direction * ahead)) << frame << " " << ahead;
        for (const int one : kept)
            if (random() % 3 == 0)
                EXPECT_EQ(test::numberInPicture(video.read(one)), one);
    }
}

TEST_F(Video, IsRightAfterReadingWasStopped) {
    core::VideoFile video(encode("a.mp4", "-c:v libx264 -bf 2 -g 50 -sc_threshold 0 -pix_fmt yuv420p"), {});
    std::stop_source stop;
    stop.request_stop();
    for (const int frame : {12, 45, 59}) {
        EXPECT_TRUE(video.read(frame, stop.get_token()).empty());
        EXPECT_FALSE(video.fetchAhead(1, stop.get_token()));
        EXPECT_EQ(test::numberInPicture(video.read(frame)), frame);
    }
    EXPECT_FALSE(video.read(59, stop.get_token()).empty()) << "kept pictures cost nothing";
}

TEST_F(Video, LeavesOutWhatTheContainerCutsAway) {
    const fs::path whole = encode("whole.mp4", "-c:v libx264 -bf 3 -g 20 -pix_fmt yuv420p", 60),
                   cut = m_folder / "cut.mp4";
    ASSERT_EQ(
        std::system(("ffmpeg -loglevel quiet -y -ss 1 -i " + whole.string() + " -c copy " + cut.string()).c_str()), 0);
    core::VideoFile video(cut, {});
    ASSERT_EQ(video.info().frames, 35) << "one second of 25 frames is gone";
    for (const int frame : {20, 0, 34, 3})
        EXPECT_EQ(test::numberInPicture(video.read(frame)), frame + 25);
}

/// A recording that begins within an open group: the decoder cannot show the pictures before the first key picture.
TEST_F(Video, BeginsWithTheFirstPictureThatCanBeDecoded) {
    const fs::path file = encode(
        "a.ts",
        "-c:v libx264 -pix_fmt yuv420p -x264-params open-gop=1:keyint=30:min-keyint=30:scenecut=0:bframes=3:threads=1",
        120);
    const core::VideoIndex index = indexOf(file);
    const auto key = std::find_if(index.packets.begin() + 1, index.packets.end(),
                                  [](const core::VideoPacket& packet) { return packet.isKey; });
    ASSERT_NE(key, index.packets.end());
    const std::string bytes = test::readText(file);
    test::writeText(m_folder / "later.ts", bytes.substr(static_cast<std::size_t>(key->position)));
    core::VideoFile video(m_folder / "later.ts", {});
    const int first = test::numberInPicture(video.read(0));
    EXPECT_EQ(first, key->picture);
    EXPECT_EQ(video.info().frames, 120 - first);
    for (const int frame : {50, 3, 0, 1, 29})
        EXPECT_EQ(test::numberInPicture(video.read(frame)), first + frame);
}

TEST_F(Video, OfMoreThanEightBitsIsShownInEight) {
    for (const auto& [name, options] :
         {std::pair("ten.mkv", "-c:v libx265 -pix_fmt yuv420p10le -x265-params log-level=none"),
          std::pair("grey.mkv", "-c:v ffv1 -pix_fmt gray"),
          std::pair("grey10.mkv", "-c:v ffv1 -level 3 -pix_fmt gray10le"),
          std::pair("grey16.mkv", "-c:v ffv1 -level 3 -pix_fmt gray16le"),
          std::pair("rgb48.mkv", "-c:v png -pix_fmt rgb48be")}) {
        core::VideoFile video(encode(name, options, 12), {});
        const cv::Mat frame = video.read(7), wanted = test::numberedPicture(7);
        EXPECT_EQ(frame.type(), CV_8UC3);
        EXPECT_EQ(test::numberInPicture(frame), 7) << name;
        const auto greyAt = [](const cv::Mat& image, int x, int y) { // as a grey picture of it is
            const cv::Vec3b bgr = image.at<cv::Vec3b>(y, x);
            return 0.114 * bgr[0] + 0.587 * bgr[1] + 0.299 * bgr[2];
        };
        for (const auto& [x, y] : {std::pair(16, 16), std::pair(144, 48), std::pair(80, 85), std::pair(20, 70)})
            EXPECT_NEAR(greyAt(frame, x, y), greyAt(wanted, x, y), 12) << name << " " << x << " " << y;
    }
}

TEST_F(Video, SaysWhenItsFramesAreShown) {
    const core::VideoInfo info = core::VideoFile(encode("a.mp4", "-c:v libx264 -bf 3 -pix_fmt yuv420p"), {}).info();
    EXPECT_EQ(info.framesPerSecond, 25);
    ASSERT_EQ(info.timesSec.size(), 60u);
    EXPECT_NEAR(info.timesSec[59] - info.timesSec[0], 59 / 25.0, 1e-3);
    EXPECT_EQ(info.rotationDegrees, 0);
    EXPECT_EQ(core::readVideoInfo(encode("d.mpg", "-c:v mpeg2video")).framesPerSecond, 25);
}

/// ffmpeg turns pictures by itself: the oracle.
TEST_F(Video, SaysHowAPlayerTurnsIt) {
    const std::string file = encode("a.mp4", "-c:v mpeg4 -qscale:v 2", 3).string(),
                      ffmpeg = "ffmpeg -loglevel quiet -y -i ";
    std::vector<int> turns;
    for (const char* tag : {"90", "180", "270"}) {
        const std::string turned = m_folder / ("turned" + std::string(tag) + ".mp4"), shown = m_folder / "shown.bgr";
        ASSERT_EQ(std::system((ffmpeg + file + " -c copy -metadata:s:v:0 rotate=" + tag + " " + turned).c_str()), 0);
        ASSERT_EQ(std::system((ffmpeg + turned + " -frames:v 1 -f rawvideo -pix_fmt bgr24 " + shown).c_str()), 0);
        core::VideoFile video(turned, {});
        EXPECT_EQ(video.info().size, (core::ImageSize{test::kNumberedWidth, test::kNumberedHeight})) << "as recorded";
        turns.push_back(video.info().rotationDegrees);
        ASSERT_TRUE(turns.back() == 90 || turns.back() == 180 || turns.back() == 270) << turns.back();
        cv::Mat picture;
        cv::rotate(video.read(0), picture,
                   std::map<int, int>{{90, cv::ROTATE_90_CLOCKWISE},
                                      {180, cv::ROTATE_180},
                                      {270, cv::ROTATE_90_COUNTERCLOCKWISE}}[turns.back()]);
        std::string bytes = test::readText(shown);
        ASSERT_EQ(bytes.size(), picture.total() * 3);
        const cv::Mat wanted(picture.size(), CV_8UC3, bytes.data());
        EXPECT_LT(cv::norm(picture, wanted, cv::NORM_L1) / static_cast<double>(picture.total()), 15) << tag;
    }
    EXPECT_EQ(turns[0] + turns[2], 360);
    EXPECT_EQ(turns[1], 180);
}

TEST_F(Video, RefusesFilesThatAreNotVideos) {
    test::writeText(m_folder / "a.txt", "some text\n");
    test::writeText(m_folder / "a.mp4", "some text\n");
    test::writeText(m_folder / "b.mp4", test::readText(encode("c.mp4", "-c:v mpeg4")).substr(0, 1000));
    for (const char* name : {"a.txt", "a.mp4", "b.mp4"})
        test::expectError([&] { core::readVideoInfo(m_folder / name); }, BadInput, name, "not a readable video");
    test::expectError([&] { core::readVideoInfo(m_folder / "none.mp4"); }, NotFound, "none.mp4", "no such video");
}

} // namespace
