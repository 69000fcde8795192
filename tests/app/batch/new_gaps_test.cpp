// SPDX-License-Identifier: MIT
#include <set>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/io/calibration/cameras_file.h"
#include "core/io/dataset/dataset.h"
#include "core/io/dataset/frames.h"
#include "core/io/dataset/instants.h"
#include "core/io/footage/image_file.h"
#include "tests/app/batch/program.h"
#include "tests/support/camera_ring.h"
#include "tests/support/expect_error.h"
#include "tests/support/recordings/numbered_video.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using core::InstantRange;
using test::Ended;
using test::runBatch;
using Ranges = std::vector<InstantRange>;

/// A dataset of two cameras whose footage lacks something.
class NewWithGaps : public testing::Test {
protected:
    NewWithGaps() {
        std::vector<core::Camera> cameras = test::cameraRing(2);
        for (core::Camera& camera : cameras)
            camera.size = {test::kNumberedWidth, test::kNumberedHeight};
        core::writeCameras(m_cameras, cameras);
    }

    /// Makes the dataset anew; its notes are what `new` says, and `check` must say the same.
    core::Sequence make(std::vector<std::string> arguments) {
        fs::remove_all(m_set);
        arguments.insert(arguments.begin(), {"new", "--cameras", m_cameras, "--out", m_set});
        const Ended made = runBatch(arguments);
        EXPECT_EQ(made.status, 0) << made.err;
        const Ended checked = runBatch({"check", m_set});
        EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
        m_dataset = core::readDataset(m_set);
        const core::Sequence& sequence = m_dataset.sequences.at(0);
        std::set<std::string> said;
        for (const std::string& note : core::notesInWords(sequence)) {
            EXPECT_NE(made.out.find("note: " + note + "\n"), std::string::npos) << made.out;
            const std::string text = note.substr(note.find(": ") + 2); // without the camera
            said.insert(text);
            EXPECT_NE(checked.out.find(text + "\n"), std::string::npos) << checked.out;
        }
        EXPECT_EQ(count(made.out, "note: "), sequence.notes.size()) << made.out;
        EXPECT_EQ(count(checked.out, "sequence \"1\": "), said.size()) << "what is alike in views is said once";
        return sequence;
    }

    /// The number in the picture of an instant; -1 = there is none.
    int numberAt(int camera, int instant) {
        const core::FrameSource frames(m_dataset, m_dataset.sequences.at(0), {});
        const cv::Mat picture = frames.read(camera, instant);
        EXPECT_EQ(picture.size(), cv::Size(test::kNumberedWidth, test::kNumberedHeight));
        return frames.hasPicture(camera, instant) ? test::numberInPicture(picture) : -1;
    }

    static std::size_t count(const std::string& text, const std::string& what) {
        std::size_t count = 0;
        for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
            ++count;
        return count;
    }

    std::string writeImages(const std::string& name, const std::vector<int>& numbers,
                            const std::string& before = "img_", const std::string& after = ".png") {
        fs::create_directory(m_folder / name);
        for (const int number : numbers)
            core::writePng(m_folder / name / (before + std::to_string(number) + after), test::numberedPicture(number));
        return (m_folder / name).string();
    }

    static std::vector<int> range(int first, int last) {
        std::vector<int> numbers;
        for (int i = first; i <= last; ++i)
            numbers.push_back(i);
        return numbers;
    }

    test::TemporaryFolder m_folder;
    std::string m_cameras = m_folder / "cameras.json", m_set = m_folder / "set";
    core::Dataset m_dataset;
};

class NewWithLostFrames : public NewWithGaps {
protected:
    void SetUp() override {
        if (!test::hasFfmpeg())
            GTEST_SKIP() << "ffmpeg is not installed";
    }

    std::string whole(const std::string& container, int rate = 25) {
        const std::string file = m_folder / ("whole." + container);
        EXPECT_TRUE(test::encodeNumbered(file, kCodec, test::countTo(60), rate));
        return file;
    }

    /// A camera that lost 8 frames after its frame 19 and recorded on until it had 60: the pictures carry the true
    /// instants' numbers.
    std::string lossy(const std::string& container) {
        std::vector<int> numbers = range(0, 19), later = range(28, 67);
        numbers.insert(numbers.end(), later.begin(), later.end());
        const std::string file = m_folder / ("lossy." + container);
        EXPECT_TRUE(test::encodeNumbered(
            file, std::string("-vf \"setpts='round(if(gte(N,20),N+8,N)/25/TB)'\" -vsync passthrough ") + kCodec,
            numbers));
        return file;
    }

    static constexpr const char* kCodec = "-c:v libx264 -preset veryfast -bf 2 -g 30 -pix_fmt yuv420p";
};

TEST_F(NewWithLostFrames, MapsFramesByTime) {
    for (const std::string container : {"mp4", "mkv", "ts"}) {
        const core::Sequence sequence =
            make({"--video", "cam0=" + whole(container), "--video", "cam1=" + lossy(container)});
        EXPECT_EQ(sequence.frameCount, 60) << container;
        EXPECT_TRUE(sequence.views[0].missing.empty());
        EXPECT_EQ(sequence.views[1].missing, (Ranges{{20, 8}}));
        ASSERT_FALSE(sequence.notes.empty());
        EXPECT_EQ(core::footageNoteText(sequence.notes[0]), "cam1: 8 frames missing after frame 19");
        for (const int instant : {0, 19, 20, 27, 28, 30, 59}) {
            EXPECT_EQ(numberAt(0, instant), instant) << container;
            EXPECT_EQ(numberAt(1, instant), instant >= 20 && instant < 28 ? -1 : instant) << container;
        }
    }
}

TEST_F(NewWithLostFrames, CountsFromTheOffset) {
    const core::Sequence sequence = make({"--video", "cam0=" + whole("mp4"), "--video", "cam1=" + lossy("mp4"),
                                          "--offset", "cam0=5", "--offset", "cam1=5"});
    EXPECT_EQ(sequence.views[1].missing, (Ranges{{15, 8}}));
    EXPECT_EQ(core::footageNoteText(sequence.notes[0]), "cam1: 8 frames missing after frame 14");
    EXPECT_EQ(numberAt(0, 40), 45);
    EXPECT_EQ(numberAt(1, 40), 45);
    EXPECT_TRUE(make({"--video", "cam0=" + whole("mp4"), "--video", "cam1=" + lossy("mp4"), "--offset", "cam0=28",
                      "--offset", "cam1=20"})
                    .views[1]
                    .missing.empty())
        << "the gap lies before the first instant";
    EXPECT_EQ(numberAt(1, 3), 31);
}

TEST_F(NewWithLostFrames, SaysSoWhereFramesAreTakenByNumber) {
    const core::Sequence sequence =
        make({"--video", "cam0=" + whole("mp4"), "--video", "cam1=" + lossy("mp4"), "--sync", "index"});
    EXPECT_TRUE(sequence.views[1].missing.empty());
    ASSERT_EQ(sequence.notes.size(), 1u);
    EXPECT_EQ(
        core::footageNoteText(sequence.notes[0]).find("cam1: 8 frames missing after frame 19 (its time stamps say so)"),
        0u);
    EXPECT_EQ(sequence.notes[0].kind, core::FootageNoteKind::LostFramesByChoice);
    EXPECT_EQ(numberAt(1, 30), 38);
    // A dataset of before says nothing itself: check looks at the footage.
    m_dataset.sequences[0].notes.clear();
    core::rewriteDatasetFile(m_dataset);
    EXPECT_NE(runBatch({"check", m_set}).out.find("cam1: 8 frames missing after frame 19"), std::string::npos);
}

TEST_F(NewWithLostFrames, DoesNotMapDifferentRatesByTime) {
    const std::string fast = m_folder / "fast.mp4";
    ASSERT_TRUE(test::encodeNumbered(fast, kCodec, test::countTo(60), 30));
    const Ended refused = runBatch({"new", "--cameras", m_cameras, "--video", "cam0=" + fast, "--video",
                                    "cam1=" + lossy("mp4"), "--sync", "time", "--out", m_set});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("--sync time: cam1 was recorded at another frame rate"), std::string::npos)
        << refused.err;
    const core::Sequence sequence = make({"--video", "cam0=" + fast, "--video", "cam1=" + lossy("mp4")});
    EXPECT_TRUE(sequence.views[1].missing.empty());
    EXPECT_EQ(sequence.notes.size(), 2u) << "the rate and the gap";
}

TEST_F(NewWithGaps, ShowsNoPictureWhereAnImageIsMissing) {
    std::vector<int> numbers = range(0, 6), later = range(9, 19);
    numbers.insert(numbers.end(), later.begin(), later.end());
    const core::Sequence sequence =
        make({"--images", "cam0=" + writeImages("a", numbers), "--images", "cam1=" + writeImages("b", range(0, 19))});
    EXPECT_EQ(sequence.frameCount, 20);
    EXPECT_EQ(sequence.views[0].missing, (Ranges{{7, 2}}));
    EXPECT_EQ(core::notesInWords(sequence), (std::vector<std::string>{"cam0: 2 pictures missing: 7-8"}));
    for (int instant = 0; instant < 20; ++instant) {
        EXPECT_EQ(numberAt(0, instant), instant == 7 || instant == 8 ? -1 : instant);
        EXPECT_EQ(numberAt(1, instant), instant);
    }
}

TEST_F(NewWithGaps, KeepsTheNumbersOfLabelledFrames) {
    const core::Sequence sequence = make({"--images", "cam0=" + writeImages("a", {12, 250, 333}), "--images",
                                          "cam1=" + writeImages("b", {14, 250, 333})});
    EXPECT_EQ(sequence.frameCount, 333 - 12 + 1);
    EXPECT_EQ(sequence.views[0].offsetFrames, 12);
    EXPECT_EQ(sequence.views[1].offsetFrames, 12) << "equal numbers are of the same instant";
    EXPECT_EQ(core::notesInWords(sequence),
              (std::vector<std::string>{"cam0: 319 pictures missing: 13-249, 251-332", "cam0: frame 0 is picture 12",
                                        "cam1: 319 pictures missing: 12-13, 15-249, 251-332",
                                        "cam1: frame 0 is picture 12"}));
    EXPECT_EQ(numberAt(0, 0), 12);
    EXPECT_EQ(numberAt(1, 0), -1);
    EXPECT_EQ(numberAt(1, 2), 14);
    EXPECT_EQ(numberAt(0, 250 - 12), 250);
    EXPECT_EQ(numberAt(1, 333 - 12), 333);
}

TEST_F(NewWithGaps, AlignsFoldersByNumberUnlessOneCountsFromOne) {
    core::Sequence sequence = make(
        {"--images", "cam0=" + writeImages("a", range(0, 9)), "--images", "cam1=" + writeImages("b", range(1, 9))});
    EXPECT_EQ(sequence.views[1].missing, (Ranges{{0, 1}})) << "its first picture is missing";
    EXPECT_EQ(numberAt(1, 5), 5);
    sequence =
        make({"--images", "cam0=" + (m_folder / "a").string(), "--images", "cam1=" + writeImages("c", range(1, 10))});
    EXPECT_TRUE(sequence.views[1].missing.empty());
    EXPECT_EQ(numberAt(1, 5), 6) << "as many pictures, from 1 on";
    ASSERT_EQ(sequence.notes.size(), 1u);
    EXPECT_NE(core::footageNoteText(sequence.notes[0]).find("cam0 at 0, cam1 at 1"), std::string::npos);
    sequence = make({"--images", "cam0=" + (m_folder / "a").string(), "--images", "cam1=" + (m_folder / "b").string(),
                     "--offset", "cam1=0"});
    EXPECT_EQ(numberAt(1, 5), 6) << "as the offset says";
}

TEST_F(NewWithGaps, TakesPatternsThatStartAnywhere) {
    const fs::path folder = writeImages("a", {100, 101, 103});
    core::Sequence sequence = make({"--images", "cam0=" + (folder / "img_{frame}.png").string()});
    EXPECT_EQ(sequence.frameCount, 4);
    EXPECT_EQ(sequence.views[0].offsetFrames, 100);
    EXPECT_EQ(core::notesInWords(sequence),
              (std::vector<std::string>{"cam0: 1 picture missing: 102", "cam0: frame 0 is picture 100"}));
    EXPECT_EQ(numberAt(0, 3), 103);
    sequence = make({"--images", "cam0=" + (folder / "img_{frame:03}.png").string(), "--offset", "cam0=1"});
    EXPECT_EQ(numberAt(0, 0), 101) << "counted from the first one";
    sequence = make({"--images", "cam0=" + (folder / "img_{frame:03}.png").string(), "--offset", "cam0=103"});
    EXPECT_EQ(numberAt(0, 0), 103) << "the number itself";
    for (const int i : {5, 6}) { // the number is a folder's
        fs::create_directories(m_folder / "shots" / std::to_string(i));
        core::writePng(m_folder / "shots" / std::to_string(i) / "cam1.png", test::numberedPicture(i));
    }
    sequence = make({"--images", "cam1=" + (m_folder / "shots").string() + "/{frame}/{camera}.png"});
    EXPECT_EQ(sequence.frameCount, 2);
    EXPECT_EQ(numberAt(1, 1), 6);
    const Ended none = runBatch({"new", "--cameras", m_cameras, "--images",
                                 "cam0=" + (folder / "other_{frame}.png").string(), "--out", m_folder / "none"});
    EXPECT_EQ(none.status, 1);
    EXPECT_NE(none.err.find("no such file"), std::string::npos) << none.err;
}

TEST_F(NewWithGaps, PassesOverHiddenFilesAndTheCaseOfExtensions) {
    const std::string folder = writeImages("a", range(0, 3), "IMG_", ".TIF");
    for (int i = 0; i < 4; ++i)
        test::writeText(fs::path(folder) / ("._IMG_" + std::to_string(i) + ".TIF"), "Mac OS X");
    test::writeText(fs::path(folder) / ".DS_Store", "x");
    const core::Sequence sequence = make({"--images", "cam0=" + folder});
    EXPECT_EQ(sequence.frameCount, 4);
    EXPECT_EQ(numberAt(0, 3), 3);
}

} // namespace
