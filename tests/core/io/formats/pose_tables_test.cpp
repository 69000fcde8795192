// SPDX-License-Identifier: MIT
#include "tests/core/io/formats/annotation_formats_fixture.h"

#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/csv_text.h"
#include "core/io/files/json_file.h"

namespace {

using core::JointId;
using core::Mark;
using core::MarkState;
using core::Placement;
using core::Side;
using Eigen::Vector2d;

using PoseTables = test::AnnotationFormats;

TEST_F(PoseTables, DeepLabCutMissingCellsAreNoMarksAndForeignBodyPartsAreLeftOut) {
    m_import.videos = {"take1"};
    const auto got = importSample("deeplabcut", "deeplabcut");
    EXPECT_EQ(got.set.marks.size(), 2u);
    EXPECT_EQ(mark(got.set, 7, {Side::Left, "index_mcp"}, "cam1")->px, Vector2d(512.25, 733.5));
    EXPECT_EQ(mark(got.set, 12, {Side::Right, "wrist"}, "cam1")->px, Vector2d(81.125, 904));
    ASSERT_EQ(got.warnings.size(), 1u);
    EXPECT_NE(core::importNoteText(got.warnings[0]).find("tail"), std::string::npos);
}

TEST_F(PoseTables, LightningPoseHasThreeIndexColumnsAndCamerasAreMatchedByWholeName) {
    m_dataset = test::ringDataset(11);
    m_dataset.sequences[0].name = "take1";
    const auto got = importSample("deeplabcut", "lightning-pose").set;
    EXPECT_EQ(got.marks.size(), 2u);
    EXPECT_EQ(mark(got, 3, {Side::Left, "index_mcp"}, "cam1")->px, Vector2d(1.5, 2.5));
    EXPECT_EQ(mark(got, 3, {Side::Left, "index_mcp"}, "cam10")->px, Vector2d(7.5, 8.5));
}

TEST_F(PoseTables, Anipose2dHasLikelihoodsAndSeveralWaysToSayMissing) {
    const auto got = importSample("anipose2d", "anipose/cam2.csv").set;
    EXPECT_EQ(got.marks.size(), 3u);
    EXPECT_EQ(*mark(got, 0, {Side::Left, "index_mcp"}, "cam2"),
              (Mark{{100.5, 200.25}, Placement::Proposed, MarkState::Visible, 0.99}));
    EXPECT_EQ(mark(got, 1, {Side::Left, "index_mcp"}, "cam2")->likelihood, 0.3);
    EXPECT_EQ(mark(got, 2, {Side::Right, "wrist"}, "cam2")->px, Vector2d(5, 6));
}

TEST_F(PoseTables, WhatANetworkGuessedIsProposedAndUnlikelyGuessesCanBeLeftOut) {
    for (const char* name : {"likelihood", "score", "confidence"}) {
        std::ofstream(m_folder / "cam0.csv")
            << "scorer,net,net,net\nbodyparts,left_wrist,left_wrist,left_wrist\ncoords,x,y," << name
            << "\n0,10,20,0.003\n1,30,40,0.97\n";
        m_import.minLikelihood.reset();
        const auto all = import("deeplabcut", m_folder / "cam0.csv").set;
        ASSERT_EQ(all.marks.size(), 2u) << name;
        EXPECT_EQ(*mark(all, 0, {Side::Left, "wrist"}, "cam0"),
                  (Mark{{10, 20}, Placement::Proposed, MarkState::Visible, 0.003}));
        EXPECT_FALSE(all.marks.begin()->second.isEvidence());
        m_import.minLikelihood = 0.5;
        const auto likely = import("deeplabcut", m_folder / "cam0.csv");
        ASSERT_EQ(likely.set.marks.size(), 1u);
        EXPECT_EQ(likely.set.marks.begin()->second.likelihood, 0.97);
        EXPECT_NE(core::importNoteText(likely.warnings.back()).find("likelihood below 0.5 (1 times)"),
                  std::string::npos)
            << core::importNoteText(likely.warnings.back());
    }
}

TEST_F(PoseTables, SleapTablesAreProposalsWhoseTracksAreHands) {
    std::ofstream(m_folder / "cam0.csv") << "track,frame_idx,instance.score,wrist.x,wrist.y,wrist.score,right_index_"
                                            "mcp.x,right_index_mcp.y,right_index_mcp.score\n"
                                            "left,7,0.8,10,20,0.75,,,\n,8,0.8,,,,30,40,0.5\n";
    const auto got = import("anipose2d", m_folder / "cam0.csv").set;
    EXPECT_EQ(got.marks.size(), 2u);
    EXPECT_EQ(*mark(got, 7, {Side::Left, "wrist"}, "cam0"),
              (Mark{{10, 20}, Placement::Proposed, MarkState::Visible, 0.75}));
    EXPECT_EQ(mark(got, 8, {Side::Right, "index_mcp"}, "cam0")->likelihood, 0.5);
}

/// Labels of two videos of a sequence's cameras, and of two others, in one table.
TEST_F(PoseTables, OnlyRowsOfThisSequencesVideosAreTaken) {
    m_dataset.sequences[0].views = {{"cam0", core::ViewKind::Video, "../footage/left.mp4", 0},
                                    {"cam1", core::ViewKind::Images, "../footage/right/{frame:06}.png", 0}};
    const std::string head = "scorer,a,a\nbodyparts,left_wrist,left_wrist\ncoords,x,y\n";
    const auto write = [&](const std::string& rows) { std::ofstream(m_folder / "cam2.csv") << head << rows; };
    write("labeled-data/left/img1.png,1,2\nlabeled-data\\right\\img2.png,3,4\nlabeled-data/01/img3.png,5,6\n"
          "labeled-data/01-cam3/img4.png,7,8\nimg5.png,9,10\nlabeled-data/02_cam0/img1.png,0.5,1\nlabeled-data/monday/"
          "img1.png,1,1\n"
          "labeled-data/monday/img2.png,1,1\n");
    const auto got = import("deeplabcut", m_folder / "cam2.csv");
    EXPECT_EQ(got.set.marks.size(), 5u);
    const std::pair<int, const char*> places[] = {{1, "cam0"}, {2, "cam1"}, {3, "cam2"}, {4, "cam3"}, {5, "cam2"}};
    for (const auto& [frame, camera] : places)
        EXPECT_TRUE(mark(got.set, frame, {Side::Left, "wrist"}, camera)) << frame;
    ASSERT_EQ(got.warnings.size(), 1u);
    EXPECT_EQ(core::importNoteText(got.warnings[0]),
              "3 rows of other videos left out: 02_cam0, monday; choose a video with --video");
    EXPECT_EQ(got.otherVideos, (std::vector<std::string>{"02_cam0", "monday"}));
    m_import.videos = {"02"};
    EXPECT_EQ(mark(import("deeplabcut", m_folder / "cam2.csv").set, 1, {Side::Left, "wrist"}, "cam0")->px,
              Vector2d(0.5, 1));
    std::ofstream(m_folder / "cam2.csv")
        << "scorer,,,a,a\nbodyparts,,,left_wrist,left_wrist\ncoords,,,x,y\nlabeled-data,monday,img1.png,1,2\n";
    m_import.videos.clear();
    EXPECT_TRUE(import("deeplabcut", m_folder / "cam2.csv").set.marks.empty())
        << "nor the only video, if it is another";
}

TEST_F(PoseTables, FootageThatIsShiftedAgainstTheSequenceIsSaid) {
    m_dataset.sequences[0].views = {{"cam0", core::ViewKind::Video, "left.mp4", 10}};
    std::ofstream(m_folder / "cam0.csv") << "scorer,a,a\nbodyparts,left_wrist,left_wrist\ncoords,x,y\n"
                                            "labeled-data/left/img12.png,1,2\n";
    const auto got = import("deeplabcut", m_folder / "cam0.csv");
    ASSERT_EQ(got.warnings.size(), 1u);
    EXPECT_NE(core::importNoteText(got.warnings[0]).find("footage of cam0 is shifted"), std::string::npos)
        << core::importNoteText(got.warnings[0]);
    m_dataset.sequences[0].views[0].offsetFrames = 0;
    EXPECT_TRUE(import("deeplabcut", m_folder / "cam0.csv").warnings.empty());
}

TEST_F(PoseTables, SemicolonsAndDecimalCommasAreRead) {
    std::ofstream(m_folder / "cam0.csv")
        << "scorer;a;a\nbodyparts;left_wrist;left_wrist\ncoords;x;y\nimg7.png;1,5;2,25\n";
    EXPECT_EQ(mark(import("deeplabcut", m_folder / "cam0.csv").set, 7, {Side::Left, "wrist"}, "cam0")->px,
              Vector2d(1.5, 2.25));
    std::ofstream(m_folder / "marks.csv") << "sequence;frame;rater;hand;joint;camera;x_px;y_px;state;placement\r\n"
                                             "01;4;ann;left;wrist;cam0;10,25;20,5;visible;manual\r\n";
    EXPECT_EQ(mark(import("csv-marks", m_folder / "marks.csv").set, 4, {Side::Left, "wrist"}, "cam0")->px,
              Vector2d(10.25, 20.5));
}

TEST_F(PoseTables, MarksOutsideThePictureAreExportedAsNotVisible) {
    const JointId joint{Side::Left, "wrist"};
    click(3, joint, {1, 2, 3});
    m_set.marks[{3, "ann", joint, "cam1"}].px = {-30, 50};
    const auto coco = core::readJsonFile(exported("coco"));
    for (const auto& annotation : coco["annotations"]) {
        const bool isCam1 = annotation["image_id"] == 2;
        EXPECT_EQ(annotation["keypoints"][2], isCam1 ? 1 : 2) << annotation["image_id"];
    }
    EXPECT_EQ(core::readCsv(exported("deeplabcut") / "cam1" / "CollectedData_ann.csv")[3][1], "");
    EXPECT_EQ(core::readCsv(exported("anipose2d") / "cam1.csv")[6][3], "0.5");
}

TEST_F(PoseTables, PoseTablesComeBackExactly) {
    clickHands();
    m_set.marks.erase({7, "ann", {Side::Left, "wrist"}, "cam4"});
    EXPECT_EQ(import("deeplabcut", exported("deeplabcut")).set, m_set);
    varyStates(false);
    EXPECT_EQ(import("anipose2d", exported("anipose2d")).set, m_set);
}

TEST_F(PoseTables, PoseTablesThatAreWrongAreRefused) {
    const auto refused = [&](const std::string& text) {
        std::ofstream(m_folder / "cam0.csv") << text;
        EXPECT_THROW(import("deeplabcut", m_folder / "cam0.csv"), core::Error) << text;
    };
    const std::string head = "scorer,a,a\nbodyparts,left_wrist,left_wrist\ncoords,x,y\n";
    refused("");
    refused("x,y\n1,2\n");
    refused(head + "img7.png,1,two\n");
    refused(head + "picture.png,1,2\n");
    refused(head + "img7.png,1,2\nimg7.png,1,2\n");
    refused(head + "\"img7.png,1,2\n");
    std::ofstream(m_folder / "view.csv") << head << "img7.png,1,2\n";
    EXPECT_THROW(import("deeplabcut", m_folder / "view.csv"), core::Error); // which camera?
    m_import.camera = "cam5";
    EXPECT_TRUE(mark(import("deeplabcut", m_folder / "view.csv").set, 7, {Side::Left, "wrist"}, "cam5"));
}

} // namespace
