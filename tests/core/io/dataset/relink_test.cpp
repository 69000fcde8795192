// SPDX-License-Identifier: MIT
#include "core/io/dataset/relink.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/io/dataset/frames.h"
#include "core/io/footage/image_file.h"
#include "tests/support/expect_error.h"
#include "tests/support/small_dataset.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using enum core::ErrorCode;

/// A dataset in set/, with one sequence "first" of five frames and cameras of 16 x 12; footage is elsewhere below the
/// same folder.
class Relink : public testing::Test {
protected:
    Relink() {
        fs::create_directories(m_dataset.folder);
        for (core::Camera& camera : m_dataset.cameras)
            camera.size = {16, 12};
        for (core::Sequence& sequence : m_dataset.sequences)
            for (core::ViewSource& view : sequence.views)
                view.kind = core::ViewKind::None;
    }

    core::ViewSource& view(std::size_t sequence, std::size_t camera) {
        return m_dataset.sequences[sequence].views[camera];
    }
    void useImages(std::size_t sequence, std::size_t camera, const std::string& pattern) {
        view(sequence, camera).kind = core::ViewKind::Images;
        view(sequence, camera).path = pattern;
    }
    void picture(const std::string& name, int level, cv::Size size = {16, 12}) {
        fs::create_directories((m_folder / name).parent_path());
        core::writePng(m_folder / name, cv::Mat(size, CV_8UC3, cv::Scalar::all(level)));
    }
    int levelAt(std::size_t sequence, int camera, int frame) {
        const core::FrameSource frames(m_dataset, m_dataset.sequences[sequence], {});
        return frames.read(camera, frame).at<cv::Vec3b>(3, 3)[0];
    }

    test::TemporaryFolder m_folder;
    core::Dataset m_dataset = [&] {
        core::Dataset dataset = test::smallDataset().dataset;
        dataset.folder = m_folder / "set";
        return dataset;
    }();
};

TEST_F(Relink, FindsPicturesByNameAndByAsMuchOfTheirFoldersAsIsNeeded) {
    useImages(0, 0, "../old/monday/cam0/{frame:04}.png");
    useImages(0, 1, "../old/monday/{camera}/{frame:04}.png");
    useImages(1, 0, "../old/tuesday/cam0/{frame:04}.png");
    for (int f = 0; f < 7; ++f) {
        const std::string name = "000" + std::to_string(f) + ".png";
        picture("new/deep/monday/cam0/" + name, 10 + f);
        picture("new/deep/monday/cam1/" + name, 20 + f);
        picture("new/deep/tuesday/cam0/" + name, 30 + f);
    }
    const core::RelinkResult result = core::relinkFootage(m_dataset, m_folder / "new");
    EXPECT_TRUE(result.notFound.empty());
    ASSERT_EQ(result.found.size(), 3u);
    EXPECT_EQ(result.found[0].sequence, "first");
    EXPECT_EQ(result.found[0].camera, "cam0");
    EXPECT_EQ(result.found[0].from, "../old/monday/cam0/{frame:04}.png");
    EXPECT_EQ(result.found[0].to, "../new/deep/monday/cam0/{frame:04}.png");
    EXPECT_EQ(core::relinkNoteText(result.found[0]), "");
    EXPECT_EQ(view(0, 1).path, "../new/deep/monday/{camera}/{frame:04}.png");
    EXPECT_EQ(levelAt(0, 0, 4), 14);
    EXPECT_EQ(levelAt(0, 1, 0), 20);
    EXPECT_EQ(levelAt(1, 0, 6), 36);
}

TEST_F(Relink, NeverTakesAnotherRecordingOfTheSameName) {
    useImages(0, 0, "../old/monday/{frame}.png");
    useImages(1, 0, "../old/tuesday/{frame}.png");
    for (int f = 0; f < 7; ++f)
        picture("new/tuesday/" + std::to_string(f) + ".png", 30 + f);
    const core::RelinkResult result = core::relinkFootage(m_dataset, m_folder / "new");
    ASSERT_EQ(result.found.size(), 1u);
    EXPECT_EQ(result.found[0].sequence, "second");
    ASSERT_EQ(result.notFound.size(), 1u);
    EXPECT_EQ(result.notFound[0].sequence, "first");
    EXPECT_EQ(result.notFound[0].reason, core::RelinkReason::OtherFootage);
    EXPECT_NE(core::relinkNoteText(result.notFound[0]).find("other footage of this dataset"), std::string::npos);
    EXPECT_EQ(view(0, 0).path, "../old/monday/{frame}.png");
}

TEST_F(Relink, LeavesOpenWhatIsAmbiguous) {
    useImages(0, 0, "../old/cam0/{frame}.png");
    for (int f = 0; f < 5; ++f) {
        picture("new/a/cam0/" + std::to_string(f) + ".png", 1);
        picture("new/b/cam0/" + std::to_string(f) + ".png", 2);
    }
    const core::RelinkResult result = core::relinkFootage(m_dataset, m_folder / "new");
    ASSERT_EQ(result.notFound.size(), 1u);
    EXPECT_EQ(result.notFound[0].reason, core::RelinkReason::SeveralFit);
    EXPECT_NE(core::relinkNoteText(result.notFound[0]).find("several fit"), std::string::npos);
    // With a root that holds only one of them there is no doubt.
    EXPECT_EQ(core::relinkFootage(m_dataset, m_folder / "new/b").found.size(), 1u);
    EXPECT_EQ(levelAt(0, 0, 0), 2);
}

TEST_F(Relink, SaysWhereFramesOrPixelsDiffer) {
    useImages(0, 0, "../old/cam0/{frame}.png");
    useImages(0, 1, "../old/cam1/{frame}.png");
    for (int f = 0; f < 5; ++f) {
        if (f < 3)
            picture("new/cam0/" + std::to_string(f) + ".png", 1);
        picture("new/cam1/" + std::to_string(f) + ".png", 1, {8, 6});
    }
    const core::RelinkResult result = core::relinkFootage(m_dataset, m_folder / "new");
    ASSERT_EQ(result.found.size(), 2u);
    EXPECT_EQ(core::relinkNoteText(result.found[0]), "it has 3 pictures, but the sequence needs 5");
    EXPECT_EQ(core::relinkNoteText(result.found[1]), "it is 8 x 6, but cam1 is calibrated for 16 x 12");
}

TEST_F(Relink, KeepsWhatIsInPlaceAndFindsMasks) {
    useImages(0, 0, "here/{frame}.png");
    m_dataset.sequences[0].masks = "../old/masks/{camera}_{frame:03}.png";
    for (int f = 0; f < 5; ++f) {
        picture("set/here/" + std::to_string(f) + ".png", 40 + f);
        picture("new/here/" + std::to_string(f) + ".png", 90);
        picture("new/masks/cam2_00" + std::to_string(f) + ".png", 255);
    }
    picture("new/masks/other_000.png", 255);
    const core::RelinkResult result = core::relinkFootage(m_dataset, m_folder / "new");
    ASSERT_EQ(result.unchanged.size(), 1u);
    EXPECT_EQ(view(0, 0).path, "here/{frame}.png");
    EXPECT_EQ(levelAt(0, 0, 2), 42);
    ASSERT_EQ(result.found.size(), 1u);
    EXPECT_TRUE(result.found[0].isMask);
    EXPECT_EQ(m_dataset.sequences[0].masks, "../new/masks/{camera}_{frame:03}.png");
    const std::vector<cv::Mat> masks =
        core::readFrameMasks(m_dataset.folder, m_dataset.sequences[0], m_dataset.cameras, 3);
    EXPECT_TRUE(masks[0].empty());
    EXPECT_EQ(cv::countNonZero(masks[2]), 16 * 12);
}

TEST_F(Relink, NeedsAFolder) {
    test::expectError([&] { core::relinkFootage(m_dataset, m_folder / "none"); }, NotFound, "none", "no such folder");
}

} // namespace
