// SPDX-License-Identifier: MIT
// Pictures from a source whose work takes a known time: what comes, in which order, and what is dropped.
#include "widgets/jobs/frame_loader.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include <gtest/gtest.h>

#include "core/io/dataset/frames.h"
#include "tests/support/wait_until.h"
#include "widgets/presenters/playback.h"

namespace {

constexpr int kCameras = 4, kFrames = 400;
constexpr QSize kSize(64, 48);

/// Pictures whose grey is the frame's number. Reading waits as long as the test says.
class FakeSource : public core::PictureSource {
public:
    struct Read {
        int camera, frame, shrink;
    };

    core::ViewKind kind(int) const override { return core::ViewKind::Video; }
    bool hasPicture(int, int) const override { return true; }
    cv::Mat read(int camera, int frame, const std::stop_token& stop, int shrink) const override {
        {
            const std::lock_guard lock(mutex);
            begun.push_back(camera);
        }
        for (int waited = 0; waited < readMs && !stop.stop_requested(); waited += 2)
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        while (isHeld && !stop.stop_requested())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (stop.stop_requested())
            return {};
        const std::lock_guard lock(mutex);
        reads.push_back({camera, frame, shrink});
        return cv::Mat(kSize.height() / shrink, kSize.width() / shrink, CV_8UC3, cv::Scalar::all(frame % 256));
    }
    std::optional<core::Glance> glance(int, int frame, bool hurried, const std::stop_token&) const override {
        if (!glances || (onlyHurried && !hurried))
            return std::nullopt;
        const int shown = exactGlances ? frame : frame / 50 * 50;
        return core::Glance{cv::Mat(kSize.height() / 4, kSize.width() / 4, CV_8UC3, cv::Scalar::all(shown % 256)),
                            shown == frame};
    }
    bool hasVideos() const override { return true; }
    void setBudget(std::int64_t bytes) override { budget = bytes; }
    void setFirstCamera(int camera) override { first = camera; }
    bool fetchAhead(int camera, int direction, const std::stop_token&) const override {
        const std::lock_guard lock(mutex);
        ahead.push_back({camera, direction, 0});
        return ++fetched < 100;
    }
    cv::Mat keptSmall(int, int frame) const override {
        const bool isKept = smallUntil > frame;
        return isKept ? cv::Mat(kSize.height() / 4, kSize.width() / 4, CV_8UC3, cv::Scalar::all(frame % 256))
                      : cv::Mat();
    }
    bool survey(int, const std::stop_token& stop) const override { return !stop.stop_requested() && ++surveyed < 200; }
    std::size_t readsBegun() const {
        const std::lock_guard lock(mutex);
        return begun.size();
    }
    std::vector<Read> takeReads() {
        const std::lock_guard lock(mutex);
        return std::exchange(reads, {});
    }

    std::atomic<int> readMs = 0;
    std::atomic<bool> isHeld = false, glances = false, exactGlances = false, onlyHurried = false;
    std::atomic<std::int64_t> budget = 0;
    std::atomic<int> first = -1;
    std::atomic<int> smallUntil = 0; ///< frames before it are kept small
    mutable std::atomic<int> fetched = 0, surveyed = 0;
    mutable std::mutex mutex;
    mutable std::vector<Read> reads, ahead;
    mutable std::vector<int> begun; ///< cameras, in the order in which their reads began
};

class FramesComing : public testing::Test {
protected:
    struct Shown {
        int camera, grey;
        bool isDraft, isStandIn;
    };

    FramesComing() {
        loader.setFetchingAhead(false);
        loader.setPatience(3'600'000); // a slow machine changes nothing
        loader.setFirstCamera(2);
        loader.setSource(source, std::vector<QSize>(kCameras, kSize), kFrames);
        const auto note = [this](int camera, const widgets::ImagePyramid& picture, bool isStandIn) {
            EXPECT_EQ(picture.size(), kSize);
            shown.push_back({camera, qRed(picture.image().pixel(2, 2)), picture.isDraft(), isStandIn});
        };
        QObject::connect(
            &loader, &widgets::FrameLoader::pictureLoaded,
            [note](int camera, const widgets::ImagePyramid& picture) { note(camera, picture, false); });
        QObject::connect(
            &loader, &widgets::FrameLoader::standInLoaded,
            [note](int camera, const widgets::ImagePyramid& picture) { note(camera, picture, true); });
        QObject::connect(&loader, &widgets::FrameLoader::frameCompleted,
                         [this](int frame) { complete.push_back(frame); });
    }
    ~FramesComing() override { source->isHeld = false; }

    void finish() {
        ASSERT_TRUE(test::waitUntil([this] { return loader.isComplete(); }));
    }

    std::shared_ptr<FakeSource> source = std::make_shared<FakeSource>();
    widgets::JobPool pool{2};
    widgets::FrameLoader loader{pool};
    std::vector<Shown> shown;
    std::vector<int> complete;
};

TEST_F(FramesComing, TheCurrentViewsPictureIsReadFirst) {
    source->isHeld = true; // both threads are busy with the first two
    source->glances = false;
    loader.request(7);
    ASSERT_TRUE(test::waitUntil([this] { return source->readsBegun() == 2; }));
    source->isHeld = false;
    finish();
    const auto reads = source->takeReads();
    ASSERT_EQ(reads.size(), std::size_t(kCameras));
    ASSERT_EQ(source->begun.size(), std::size_t(kCameras));
    EXPECT_TRUE(source->begun[0] == 2 || source->begun[1] == 2) << "two threads read";
    EXPECT_EQ(source->first, 2);
    EXPECT_EQ(complete, std::vector<int>{7});
}

TEST_F(FramesComing, AJumpShowsAStandInOfEveryViewBeforeAnyWholePictureButTheCurrentViews) {
    source->glances = true;
    source->readMs = 40;
    loader.request(73);
    finish();
    ASSERT_EQ(shown.size(), std::size_t(2 * kCameras));
    int standIns = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        standIns += shown[i].isStandIn ? 1 : 0;
        EXPECT_EQ(shown[i].grey, shown[i].isStandIn ? 50 : 73) << "the key picture stands in";
        if (!shown[i].isStandIn && shown[i].camera != 2)
            EXPECT_EQ(standIns, kCameras);
        EXPECT_EQ(shown[i].isDraft, shown[i].isStandIn);
    }
}

TEST_F(FramesComing, ADraftOfTheWantedFrameIsItsPictureUntilTheWholeOneComes) {
    source->glances = source->exactGlances = true;
    loader.request(73);
    finish();
    ASSERT_EQ(shown.size(), std::size_t(2 * kCameras));
    for (const Shown& one : shown) {
        EXPECT_FALSE(one.isStandIn);
        EXPECT_EQ(one.grey, 73);
    }
    for (int camera = 0; camera < kCameras; ++camera)
        EXPECT_FALSE(loader.picture(camera).isDraft());
}

TEST_F(FramesComing, AreDroppedNotQueuedWhenAskedForFasterThanTheyCome) {
    source->readMs = 30;
    loader.request(0);
    for (int frame = 1; frame <= 100; ++frame)
        loader.request(frame);
    EXPECT_EQ(loader.requestedFrame(), 100);
    EXPECT_FALSE(loader.isComplete());
    finish();
    EXPECT_EQ(complete, (std::vector<int>{0, 100})) << "the one under way, and the last";
    EXPECT_EQ(source->takeReads().size(), std::size_t(2 * kCameras));
    EXPECT_EQ(loader.picture(3).image().pixelColor(0, 0).red(), 100);
}

TEST_F(FramesComing, GoingBackToTheFrameUnderWayForgetsTheOneInBetween) {
    source->isHeld = true;
    loader.request(5);
    loader.request(9);
    loader.request(5);
    EXPECT_EQ(loader.requestedFrame(), 5);
    source->isHeld = false;
    finish();
    EXPECT_EQ(complete, std::vector<int>{5});
}

TEST_F(FramesComing, OneThatTakesForeverGivesWayToTheNext) {
    source->isHeld = true;
    loader.setPatience(20);
    loader.request(5);
    loader.request(9);
    ASSERT_TRUE(test::waitUntil([this] { return source->readsBegun() > 2; })) << "two threads held by the first";
    source->isHeld = false;
    finish();
    EXPECT_EQ(complete, std::vector<int>{9});
    for (const FakeSource::Read& read : source->takeReads())
        EXPECT_EQ(read.frame, 9);
}

TEST_F(FramesComing, WholePicturesUnderWayAreStoppedByTheNextJumpOnceAllViewsShowSomething) {
    source->glances = true;
    source->isHeld = true;
    loader.request(60);
    ASSERT_TRUE(test::waitUntil([this] { return shown.size() == kCameras; }));
    loader.request(120);
    ASSERT_TRUE(test::waitUntil([this] { return shown.size() == 2 * kCameras; }));
    source->isHeld = false;
    finish();
    EXPECT_EQ(complete, std::vector<int>{120});
}

TEST_F(FramesComing, WholePicturesWaitWhileFramesThatAreKeptSmallFollowEachOtherQuickly) {
    source->glances = source->exactGlances = source->onlyHurried = true;
    loader.request(10);
    finish();
    source->takeReads();
    shown.clear();
    complete.clear();
    for (int frame = 20; frame < 30; ++frame) {
        loader.request(frame);
        ASSERT_TRUE(test::waitUntil([&] { return shown.size() >= std::size_t((frame - 19) * kCameras); }));
    }
    finish();
    EXPECT_EQ(complete, std::vector<int>{29});
    ASSERT_EQ(shown.size(), std::size_t(11 * kCameras));
    for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_EQ(shown[i].grey, std::min(20 + static_cast<int>(i) / kCameras, 29));
        EXPECT_EQ(shown[i].isDraft, i < std::size_t(10 * kCameras)) << "whole ones of the last frame alone";
    }
    for (const FakeSource::Read& read : source->takeReads())
        EXPECT_EQ(read.frame, 29);
}

TEST_F(FramesComing, TheWholeRecordingIsKeptSmallOnceNothingElseIsToBeDone) {
    loader.setFetchingAhead(true);
    widgets::Job other(pool);
    std::atomic<bool> mayEnd = false;
    other.start([&](const widgets::JobContext&) -> widgets::Job::Delivery {
        while (!mayEnd)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return {};
    });
    loader.request(50);
    finish();
    ASSERT_TRUE(test::waitUntil([this] { return source->fetched >= 100; }));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(source->surveyed, 0) << "while other work is done";
    mayEnd = true;
    ASSERT_TRUE(test::waitUntil([this] { return source->surveyed >= 200; })) << "it goes on by itself";
}

TEST_F(FramesComing, FetchesAheadOnlyWhenAllIsThereAndTheWayOfTravel) {
    loader.setFetchingAhead(true);
    source->isHeld = true;
    loader.request(50);
    QCoreApplication::processEvents();
    EXPECT_EQ(source->fetched, 0);
    source->isHeld = false;
    finish();
    ASSERT_TRUE(test::waitUntil([this] { return source->fetched >= 100; }));
    loader.request(49);
    finish();
    source->fetched = 0;
    {
        const std::lock_guard lock(source->mutex);
        source->ahead.clear();
        source->reads.clear();
    }
    loader.request(48);
    finish();
    ASSERT_TRUE(test::waitUntil([this] { return source->fetched >= 100; }));
    const std::lock_guard lock(source->mutex);
    for (const FakeSource::Read& one : source->ahead)
        EXPECT_EQ(one.frame, -1) << "backwards";
}

/// A clock that the test turns.
class Playing : public FramesComing {
protected:
    Playing() {
        selection.setFrameCount(kFrames);
        QObject::connect(&selection, &widgets::Selection::frameChanged, &loader, &widgets::FrameLoader::request);
        loader.request(0);
        finish();
        shown.clear();
        complete.clear();
        playback.setFramesPerSecond(50);
        playback.setClock([this] { return nowMs; });
    }
    /// The window lives for a moment at that time.
    void at(double ms) {
        nowMs = ms;
        const int before = selection.frame();
        ASSERT_TRUE(test::waitUntil([&] { return selection.frame() != before || !playback.isPlaying(); }));
        finish();
    }

    double nowMs = 0;
    widgets::Selection selection;
    widgets::Playback playback{selection, loader};
};

TEST_F(Playing, ShowsTheFrameThatIsDueInAllViewsAtOnce) {
    playback.play();
    for (int i = 1; i <= 10; ++i) {
        at(40 * i); // two frames later
        EXPECT_EQ(selection.frame(), 2 * i);
    }
    ASSERT_EQ(complete.size(), 10u);
    ASSERT_EQ(shown.size(), std::size_t(10 * kCameras));
    for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_EQ(shown[i].camera, static_cast<int>(i % kCameras)) << "all of a frame, then the next";
        EXPECT_EQ(shown[i].grey, 2 * (static_cast<int>(i) / kCameras + 1));
        EXPECT_TRUE(shown[i].isDraft);
    }
    shown.clear();
    playback.stop();
    finish();
    ASSERT_EQ(shown.size() % kCameras, 0u);
    for (int camera = 0; camera < kCameras; ++camera) {
        EXPECT_FALSE(loader.picture(camera).isDraft()) << "whole once it stands";
        EXPECT_EQ(qRed(loader.picture(camera).image().pixel(2, 2)), 20);
    }
}

TEST_F(Playing, DecodesNothingWhereSmallPicturesAreKept) {
    source->smallUntil = 9;
    source->takeReads();
    playback.play();
    for (int i = 1; i <= 6; ++i)
        at(40 * i);
    for (const FakeSource::Read& read : source->takeReads())
        EXPECT_GE(read.frame, 9);
    ASSERT_EQ(shown.size(), std::size_t(6 * kCameras));
    for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_EQ(shown[i].grey, 2 * (static_cast<int>(i) / kCameras + 1));
        EXPECT_TRUE(shown[i].isDraft);
    }
}

TEST_F(Playing, EndsAtTheLastFrame) {
    selection.setFrame(kFrames - 3);
    finish();
    playback.play();
    for (int i = 1; i <= 6; ++i)
        at(1000.0 * i);
    EXPECT_EQ(selection.frame(), kFrames - 1);
    EXPECT_FALSE(playback.isPlaying());
    finish();
    EXPECT_FALSE(loader.picture(0).isDraft());
}

TEST(PlaybackPace, LeavesOutFramesButKeepsTheTimeWherePicturesAreFastEnough) {
    widgets::PlaybackPace pace;
    pace.start(100, 50, 1000);
    EXPECT_EQ(pace.next(1019), 100);
    EXPECT_EQ(pace.next(1020), 101);
    int last = 101;
    for (double ms = 1060; ms < 5000; ms += 40) {
        const int next = pace.next(ms);
        EXPECT_EQ(next, 100 + static_cast<int>((ms - 1000) / 20 + 1e-6));
        EXPECT_EQ(next, last + 2);
        last = next;
    }
}

/// Pictures that cost 60 ms for every frame of the recording, shown or not: three times too slow.
TEST(PlaybackPace, PlaysSlowerInsteadOfLeavingOutEverMoreWhereDecodingIsTooSlow) {
    widgets::PlaybackPace pace;
    pace.start(0, 50, 0);
    double ms = 20;
    int last = 0;
    for (int i = 0; i < 50; ++i) {
        const int next = pace.next(ms);
        ASSERT_GT(next, last);
        EXPECT_LE(next - last, i < 4 ? 8 : 2) << i;
        ms += 60 * (next - last) + 5;
        last = next;
    }
    EXPECT_NEAR(last / ms, 1 / 60.0, 0.003) << "as fast as frames can be decoded";
}

} // namespace
