// SPDX-License-Identifier: MIT
#include "core/io/dataset/attach_masks.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/io/dataset/frames.h"
#include "core/io/dataset/mask_folder.h"
#include "core/io/footage/image_file.h"
#include "tests/support/expect_error.h"
#include "tests/support/small_dataset.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using enum core::ErrorCode;

/// The small dataset in set/, cameras cam0 to cam2 of 16 x 12; sequence "first" has five frames.
class AttachMasks : public testing::Test {
protected:
    AttachMasks() {
        m_dataset.folder = m_folder / "set";
        fs::create_directories(m_dataset.folder);
        for (core::Camera& camera : m_dataset.cameras)
            camera.size = {16, 12};
    }

    /// A mask with `pixels` white ones.
    void mask(const std::string& name, int pixels, cv::Size size = {16, 12}) {
        fs::create_directories((m_folder / name).parent_path());
        cv::Mat picture(size, CV_8U, cv::Scalar(0));
        picture.row(0).colRange(0, pixels).setTo(255);
        core::writePng(m_folder / name, picture);
    }
    /// Its notes in words.
    std::vector<std::string> attach(const std::string& from) {
        std::vector<std::string> notes;
        for (const core::MaskNote& note : core::attachMasks(m_dataset, "first", from))
            notes.push_back(core::maskNoteText(note));
        return notes;
    }
    /// White pixels of a mask as a fit would read it; -1 if there is none.
    int pixels(std::size_t camera, int frame) {
        const cv::Mat read =
            core::readFrameMasks(m_dataset.folder, m_dataset.sequences[0], m_dataset.cameras, frame)[camera];
        return read.empty() ? -1 : cv::countNonZero(read);
    }
    const std::string& pattern() const { return m_dataset.sequences[0].masks; }

    test::TemporaryFolder m_folder;
    core::Dataset m_dataset = test::smallDataset().dataset;
};

TEST_F(AttachMasks, FindsAFolderPerCamera) {
    for (int f = 0; f < 5; ++f) {
        mask("m/cam0/00000" + std::to_string(f) + ".png", f + 1);
        mask("m/cam1/00000" + std::to_string(f) + ".png", f + 6);
    }
    const std::vector<std::string> notes = attach((m_folder / "m").string());
    EXPECT_EQ(pattern(), "../m/{camera}/{frame:06}.png");
    EXPECT_EQ(notes, (std::vector<std::string>{"cam0: 5 of 5 frames have a mask", "cam1: 5 of 5 frames have a mask",
                                               "cam2: 0 of 5 frames have a mask"}));
    EXPECT_EQ(pixels(0, 4), 5);
    EXPECT_EQ(pixels(1, 0), 6);
    EXPECT_EQ(pixels(2, 0), -1);
    EXPECT_TRUE(core::hasMasks(m_dataset.sequences[0]));
}

TEST_F(AttachMasks, FindsNamesWithCameraAndNumberInOneFolder) {
    for (const int f : {0, 2, 4}) {
        mask("m/mask-cam0-" + std::to_string(f) + ".png", f + 1);
        mask("m/mask-cam2-" + std::to_string(f) + ".png", f + 3);
    }
    test::writeText(m_folder / "m/._mask-cam1-0.png", "of macOS");
    attach((m_folder / "m").string());
    EXPECT_EQ(pattern(), "../m/mask-{camera}-{frame}.png");
    EXPECT_EQ(pixels(0, 2), 3);
    EXPECT_EQ(pixels(2, 4), 7);
    EXPECT_EQ(pixels(0, 1), -1);
}

TEST_F(AttachMasks, KeepsAPatternPerCameraWhereTheyDiffer) {
    for (int f = 0; f < 5; ++f) {
        mask("m/cam0/" + std::to_string(f) + ".png", 1);
        mask("m/cam1/img_00" + std::to_string(f) + ".bmp.png", 2);
    }
    attach((m_folder / "m").string());
    EXPECT_EQ(pixels(0, 3), 1);
    EXPECT_EQ(pixels(1, 3), 2);
    // It survives the file, and a pattern for one camera does not touch the others.
    mask("other/7.png", 9);
    core::attachMasks(m_dataset, "first", {core::MaskSource{"cam2", (m_folder / "other/{frame}.png").string(), 7}});
    fs::remove_all(m_dataset.folder);
    core::writeDataset(m_dataset, test::smallDataset().motions, m_dataset.folder);
    m_dataset = core::readDataset(m_dataset.folder);
    EXPECT_EQ(pixels(0, 3), 1);
    EXPECT_EQ(pixels(1, 3), 2);
    EXPECT_EQ(pixels(2, 0), 9);
}

TEST_F(AttachMasks, TakesPatternsAndCamerasByName) {
    mask("m/cam1.3.png", 4);
    attach((m_folder / "m/{camera}.{frame}.png").string());
    EXPECT_EQ(pixels(1, 3), 4);
    mask("a=b/3.png", 5);
    EXPECT_EQ(core::parseMaskSource(m_dataset, "cam1=x/{frame}.png").camera, "cam1");
    EXPECT_EQ(core::parseMaskSource(m_dataset, "a=b/{frame}.png").camera, "");
    attach("cam0=" + (m_folder / "a=b").string());
    EXPECT_EQ(pixels(0, 3), 5);
    EXPECT_EQ(pixels(1, 3), 4);
}

TEST_F(AttachMasks, SaysWhenNumbersDoNotFitTheFrames) {
    for (int f = 1; f <= 5; ++f)
        mask("m/cam0/" + std::to_string(f) + ".png", f);
    const std::vector<std::string> notes = attach((m_folder / "m").string());
    ASSERT_EQ(notes.size(), 4u);
    EXPECT_EQ(notes[0], "cam0: 4 of 5 frames have a mask");
    EXPECT_NE(notes[3].find("--offset 1"), std::string::npos) << notes[3];
    core::attachMasks(m_dataset, "first", {core::MaskSource{"", (m_folder / "m").string(), 1}});
    EXPECT_EQ(pixels(0, 0), 1);
    EXPECT_EQ(pixels(0, 4), 5);
}

TEST_F(AttachMasks, RefusesWhatIsNotThereOrDoesNotFit) {
    const std::string before = pattern();
    mask("small/cam1/0.png", 1, {8, 6});
    test::expectError([&] { attach((m_folder / "small").string()); }, BadInput, "small/cam1/0.png",
                      "8 x 6, but cam1 is calibrated for 16 x 12");
    test::expectError([&] { attach((m_folder / "none").string()); }, NotFound, "none", "no such folder");
    test::expectError([&] { attach((m_folder / "none/{camera}_{frame}.png").string()); }, NotFound, "none/",
                      "cam0_0.png");
    test::expectError([&] { attach((m_folder / "none/{frame}.png").string()); }, Usage, "{camera}", "is missing");
    mask("late/cam0/99.png", 1);
    test::expectError([&] { attach((m_folder / "late").string()); }, NotFound, "late", "no mask of any frame");
    mask("nameless/1.png", 1);
    test::expectError([&] { attach((m_folder / "nameless").string()); }, NotFound, "nameless", "cam0/000000.png");
    EXPECT_EQ(pattern(), before);
    EXPECT_FALSE(core::hasMasks(m_dataset.sequences[0]));
}

TEST(MaskFolder, TellsCamerasWhoseNamesHoldEachOther) {
    const test::TemporaryFolder folder;
    for (const char* name : {"cam_left_001.png", "cam_001.png", "1/1.png", "1/2.png", "10/1.png"}) {
        fs::create_directories((folder / name).parent_path());
        test::writeText(folder / name, "");
    }
    const auto found = core::findMaskNaming(folder.path(), {"cam", "cam_left", "1", "10"});
    EXPECT_EQ(found.at("cam").pattern, folder / "{camera}_{frame:03}.png");
    EXPECT_EQ(found.at("cam_left").pattern, folder / "{camera}_{frame:03}.png");
    EXPECT_EQ(found.at("1").pattern, folder / "{camera}/{frame}.png");
    EXPECT_EQ(found.at("10").numbers, std::vector<int>{1});
}

} // namespace
