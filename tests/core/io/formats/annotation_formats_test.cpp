// SPDX-License-Identifier: MIT
#include "tests/core/io/formats/annotation_formats_fixture.h"

#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/csv_text.h"
#include "core/io/files/json_file.h"
#include "core/io/files/text_file.h"
#include "core/io/formats/coco_annotations.h"

namespace {

namespace fs = std::filesystem;
using core::AnnotationSet;
using core::JointId;
using core::Mark;
using core::MarkState;
using core::Placement;
using core::Side;
using Eigen::Vector2d;
using Eigen::Vector3d;
using test::AnnotationFormats;

// ---- the authors' files

TEST_F(AnnotationFormats, AuthorsZeroZeroIsNotAPlace) {
    const auto got = importSample("tzionas", "authors").set;
    EXPECT_EQ(mark(got, 41, {Side::Right, "little_mcp"}, "cam1")->px, Vector2d(512, 733));
    EXPECT_EQ(mark(got, 41, {Side::Right, "thumb_mcp"}, "cam1")->px, Vector2d(600, 701));
    EXPECT_EQ(mark(got, 41, {Side::Right, "thumb_ip"}, "cam1")->px, Vector2d(0, 640)); // one zero is a place
    EXPECT_EQ(mark(got, 41, {Side::Right, "ring_mcp"}, "cam1")->state, MarkState::Unplaceable);
    EXPECT_EQ(got.marks.size(), 14u); // the left hand was not annotated
}

TEST_F(AnnotationFormats, AuthorsFilesHaveTabsWholePixelsAndNoFinalLineEnd) {
    click(4, {Side::Left, "thumb_ip"}, {10, 20, 30});
    m_set.marks[{4, "ann", {Side::Left, "thumb_ip"}, "cam2"}].px = {100.4, 200.6};
    m_set.marks[{4, "ann", {Side::Left, "thumb_ip"}, "cam3"}].state = MarkState::Occluded;
    const fs::path folder = exported("tzionas");
    const std::string text = core::readTextFile(folder / "cam2" / "004.txt");
    EXPECT_TRUE(text.starts_with("0\t0\t0\n1\t0\t0\n"));
    EXPECT_TRUE(text.ends_with("\n27\t100\t201")) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 27);
    EXPECT_TRUE(core::readTextFile(folder / "cam3" / "004.txt").ends_with("\n27\t0\t0"));
}

TEST_F(AnnotationFormats, AuthorsFilesComeBackAsTheyWere) {
    clickHands();
    const fs::path first = exported("tzionas");
    m_set = import("tzionas", first).set;
    const fs::path second = exported("tzionas");
    for (const auto& entry : fs::recursive_directory_iterator(first))
        EXPECT_TRUE(!entry.is_regular_file() ||
                    core::readTextFile(entry.path()) == core::readTextFile(second / fs::relative(entry.path(), first)))
            << entry.path();
}

TEST_F(AnnotationFormats, AuthorsFilesThatAreWrongAreRefused) {
    fs::create_directories(m_folder / "cam0");
    const auto refused = [&](const std::string& name, const std::string& text) {
        std::ofstream(m_folder / "cam0" / name) << text;
        EXPECT_THROW(import("tzionas", m_folder / "cam0" / name), core::Error) << text;
        fs::remove(m_folder / "cam0" / name);
    };
    refused("041.txt", "28\t5\t5");
    refused("041.txt", "0\t5");
    refused("041.txt", "0\tx\t5");
    refused("041.txt", "0\t5\t5\n0\t6\t6");
    refused("notes.txt", "0\t5\t5");
    EXPECT_THROW(import("tzionas", m_folder / "nothing"), core::Error);
}

// ---- COCO

TEST_F(AnnotationFormats, CocoReadsVisibilityAndForeignFileNames) {
    const auto got = importSample("coco", "coco.json").set;
    EXPECT_EQ(got.marks.size(), 2u);
    EXPECT_EQ(*mark(got, 41, {Side::Right, "wrist"}, "cam3"),
              (Mark{{100.5, 200}, Placement::Manual, MarkState::Visible}));
    EXPECT_EQ(*mark(got, 41, {Side::Right, "index_mcp"}, "cam3"),
              (Mark{{110, 190.25}, Placement::Manual, MarkState::Occluded}));
}

TEST_F(AnnotationFormats, CocoComesBackExactlyAndPassesTheChecker) {
    clickHands();
    varyStates(true);
    m_set.marks.erase({7, "ann", {Side::Left, "wrist"}, "cam4"});
    const fs::path file = exported("coco");
    const auto document = core::readJsonFile(file);
    EXPECT_NO_THROW(core::checkCoco(document, "coco"));
    EXPECT_EQ(import("coco", file).set, m_set);
    const auto& category = document["categories"][0];
    EXPECT_EQ(category["keypoints"].size(), 21u);
    EXPECT_EQ(category["skeleton"][0], (nlohmann::json{1, 2})); // root to thumb, counted from 1
    EXPECT_EQ(category["skeleton"].size(), 20u);
}

TEST_F(AnnotationFormats, CocoCheckerFindsEveryFault) {
    clickHands();
    const auto good = core::readJsonFile(exported("coco"));
    const auto refused = [&](const char* what, const std::function<void(nlohmann::json&)>& spoil) {
        nlohmann::json bad = good;
        spoil(bad);
        EXPECT_THROW(core::checkCoco(bad, "coco"), core::Error) << what;
    };
    refused(
        "count", [](auto& d) { d["annotations"][0]["num_keypoints"] = 3; });
    refused(
        "v", [](auto& d) { d["annotations"][0]["keypoints"][2] = 3; });
    refused(
        "length", [](auto& d) { d["annotations"][0]["keypoints"].erase(0); });
    refused(
        "image", [](auto& d) { d["annotations"][0]["image_id"] = 99999; });
    refused(
        "category", [](auto& d) { d["annotations"][0]["category_id"] = 9; });
    refused(
        "ids", [](auto& d) { d["annotations"][1]["id"] = d["annotations"][0]["id"]; });
    refused(
        "skeleton from 0",
        [](auto& d) {
            d["categories"][0]["skeleton"][0] = {0, 1};
        });
    refused(
        "skeleton too far",
        [](auto& d) {
            d["categories"][0]["skeleton"][0] = {1, 22};
        });
    refused("images", [](auto& d) { d.erase("images"); });
}

TEST_F(AnnotationFormats, CocoAnnotationsWithAScoreAreProposals) {
    click(3, {Side::Left, "wrist"}, {1, 2, 3});
    const fs::path file = exported("coco");
    auto document = core::readJsonFile(file);
    document["annotations"][0]["score"] = 0.25;
    std::ofstream(file) << document.dump();
    const auto got = import("coco", file).set;
    EXPECT_EQ(mark(got, 3, {Side::Left, "wrist"}, "cam0")->placement, Placement::Proposed);
    EXPECT_EQ(mark(got, 3, {Side::Left, "wrist"}, "cam0")->likelihood, 0.25);
    EXPECT_EQ(mark(got, 3, {Side::Left, "wrist"}, "cam1")->placement, Placement::Manual);
}

// ---- Anipose 3D

TEST_F(AnnotationFormats, Anipose3dUndoesItsTurnedWorldWithTheInverseNotTheTranspose) {
    const auto got = importSample("anipose3d", "anipose3d.csv").set;
    const Vector3d world(5, -7, 11);
    for (const core::Camera& camera : m_dataset.cameras) {
        const auto placed = mark(got, 0, {Side::Left, "index_mcp"}, camera.name);
        ASSERT_TRUE(placed);
        EXPECT_LT((placed->px - *core::project(camera, world)).norm(), 1e-9);
        EXPECT_EQ(placed->placement, Placement::Proposed); // a 3D point is not a click
        EXPECT_TRUE(mark(got, 5, {Side::Right, "wrist"}, camera.name));
    }
    EXPECT_EQ(core::annotatedFrames(got), (std::vector<int>{0, 5}));
}

TEST_F(AnnotationFormats, Anipose3dHoldsWhatIsShown) {
    clickHands();
    const fs::path file = exported("anipose3d");
    const auto rows = core::readCsv(file);
    ASSERT_EQ(rows.size(), 301u);
    const auto column = [&](const std::string& name) {
        return static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin());
    };
    const core::TriangulatedPoint shown = point(41, {Side::Left, "ring_dip"});
    EXPECT_EQ(std::stod(rows[42][column("left_ring_dip_x")]), shown.pointInWorld.x());
    EXPECT_EQ(std::stod(rows[42][column("left_ring_dip_error")]), shown.rmsPx);
    EXPECT_EQ(rows[42][column("left_ring_dip_ncams")], "8");
    EXPECT_EQ(rows[42][column("fnum")], "41");
    EXPECT_EQ(rows[3][column("left_ring_dip_x")], "");
    const auto back = import("anipose3d", file).set;
    EXPECT_LT((mark(back, 41, {Side::Left, "ring_dip"}, "cam3")->px -
               *core::project(m_dataset.cameras[3], shown.pointInWorld))
                  .norm(),
              1e-9);
}

// ---- export only

TEST_F(AnnotationFormats, TrcHasItsHeaderOfFiveLinesAndCountsFromOne) {
    click(2, {Side::Left, "wrist"}, {1, 2, 3});
    click(2, {Side::Right, "thumb_tip"}, {4, 5, 6});
    m_dataset.sequences[0].frameCount = 4;
    const std::string text = core::readTextFile(exported("trc"));
    std::vector<std::vector<std::string>> lines(1, {""});
    for (const char c : text)
        if (c == '\n')
            lines.push_back({""});
        else if (c == '\t')
            lines.back().push_back("");
        else
            lines.back().back() += c;
    lines.pop_back();
    ASSERT_EQ(lines.size(), 5u + 4u);
    EXPECT_EQ(lines[0][0], "PathFileType");
    EXPECT_EQ(lines[2], (std::vector<std::string>{"50", "50", "4", "2", "mm", "50", "1", "4"}));
    EXPECT_EQ(lines[3], (std::vector<std::string>{"Frame#", "Time", "left_wrist", "", "", "right_thumb_tip", "", ""}));
    EXPECT_EQ(lines[4], (std::vector<std::string>{"", "", "X1", "Y1", "Z1", "X2", "Y2", "Z2"}));
    ASSERT_EQ(lines[7].size(), 8u);
    EXPECT_EQ(lines[7][0], "3");
    EXPECT_EQ(lines[7][1], "0.04");
    EXPECT_EQ(std::stod(lines[7][3]), point(2, {Side::Left, "wrist"}).pointInWorld.y());
    EXPECT_EQ(lines[6][2], "");
}

TEST_F(AnnotationFormats, InterHandHasTipsFirstWristLastRightHandFirstAndPositionsOfCameras) {
    clickHands();
    const fs::path folder = exported("interhand");
    const auto frame = core::readJsonFile(folder / "joint_3d.json")["01"]["41"];
    ASSERT_EQ(frame["world_coord"].size(), 42u);
    EXPECT_EQ(core::jsonVector(frame["world_coord"][0], "", ""), point(41, {Side::Right, "thumb_tip"}).pointInWorld);
    EXPECT_EQ(core::jsonVector(frame["world_coord"][7], "", ""), point(41, {Side::Right, "index_mcp"}).pointInWorld);
    EXPECT_EQ(core::jsonVector(frame["world_coord"][41], "", ""), point(41, {Side::Left, "wrist"}).pointInWorld);
    EXPECT_EQ(frame["hand_type"], "interacting");
    EXPECT_EQ(frame["joint_valid"][3], nlohmann::json{1});
    const auto cameras = core::readJsonFile(folder / "camera.json")["01"];
    const core::Camera& camera = m_dataset.cameras[2];
    const Vector3d world(5, -7, 11), position = core::jsonVector(cameras["campos"]["cam2"], "", "");
    const Vector3d inCamera =
        core::jsonMatrix(cameras["camrot"]["cam2"], "", "") * (world - position); // R (X - campos)
    EXPECT_LT((inCamera - camera.cameraFromWorld * world).norm(), 1e-9);
    EXPECT_EQ(cameras["princpt"]["cam2"], (nlohmann::json{541.3, 955.8}));
}

TEST_F(AnnotationFormats, FreiHandIsInMetresWristFirst) {
    clickHands();
    m_set.marks.erase({41, "ann", {Side::Left, "thumb_cmc"}, "cam0"});
    core::AnnotationSet set;
    for (const auto& [key, mark] : m_set.marks)
        if (key.joint.joint != "thumb_cmc" || key.joint.hand != Side::Left)
            set.marks.emplace(key, mark);
    m_set = set;
    const fs::path folder = exported("freihand");
    const auto joints = core::readJsonFile(folder / "xyz/01_left/00000041.json");
    ASSERT_EQ(joints.size(), 21u);
    EXPECT_LT((1000 * core::jsonVector(joints[0], "", "") - point(41, {Side::Left, "wrist"}).pointInWorld).norm(),
              1e-9);
    EXPECT_LT((1000 * core::jsonVector(joints[4], "", "") - point(41, {Side::Left, "thumb_tip"}).pointInWorld).norm(),
              1e-9);
    EXPECT_TRUE(joints[1].is_null());
    const auto calib = core::readJsonFile(folder / "calib/01_left/00000041.json");
    EXPECT_EQ(calib["K"].size(), 8u);
    EXPECT_NEAR(calib["M"][3][1][3].get<double>() * 1000, m_dataset.cameras[3].cameraFromWorld.translation.y(), 1e-9);
    EXPECT_EQ(calib["M"][3][3], (nlohmann::json{0, 0, 0, 1}));
}

// ---- plain tables

TEST_F(AnnotationFormats, PointTableHoldsWhatIsShown) {
    click(2, {Side::Left, "wrist"}, {1, 2, 3});
    m_set.marks[{2, "ann", {Side::Right, "wrist"}, "cam0"}] = Mark{{5, 5}};
    const auto rows = core::readCsv(exported("csv"));
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(std::stod(rows[1][5]), point(2, {Side::Left, "wrist"}).pointInWorld.x());
    EXPECT_EQ(rows[1][12], "done");
    EXPECT_EQ(rows[2][5], "");
    EXPECT_EQ(rows[2][13], "fewer than two views");
}

TEST_F(AnnotationFormats, MarkTableReadsQuotesByteOrderMarksAndComesBackExactly) {
    const auto got = importSample("csv-marks", "marks.csv").set;
    const auto markOf = [&](const char* camera) {
        return core::markAt(got, {4, "Müller, A.", {Side::Left, "index_mcp"}, camera});
    };
    EXPECT_EQ(markOf("cam0").value().px, Vector2d(10.25, 20.5));
    EXPECT_EQ(markOf("cam1").value().state, MarkState::Unplaceable);
    clickHands();
    varyStates(true);
    m_set.marks[{7, "ann", {Side::Left, "wrist"}, "cam4"}] =
        Mark{Vector2d::Zero(), Placement::Manual, MarkState::Unplaceable};
    EXPECT_EQ(import("csv-marks", exported("csv-marks")).set, m_set);
}

// ---- for all

TEST_F(AnnotationFormats, AJointMapRenamesJoints) {
    std::ofstream(m_folder / "map.json") << R"({"format": "handlens-joint-map", "version": 1, "joints": [
        {"name": "P1", "joint": "index_mcp", "hand": "right"}, {"name": "W", "joint": "wrist"}]})";
    click(3, {Side::Right, "index_mcp"}, {1, 2, 3});
    click(3, {Side::Left, "wrist"}, {4, 5, 6});
    m_export.jointMap = m_import.jointMap = m_folder / "map.json";
    const fs::path folder = exported("deeplabcut");
    const std::string text = core::readTextFile(folder / "cam0" / "CollectedData_ann.csv");
    EXPECT_NE(text.find(",P1,"), std::string::npos);
    EXPECT_NE(text.find(",left_W"), std::string::npos);
    EXPECT_EQ(import("deeplabcut", folder).set, m_set);
}

TEST_F(AnnotationFormats, EveryKindWritesAnEmptySequenceAndNoKindWritesOverSomething) {
    for (const core::AnnotationFormat& format : core::annotationFormats()) {
        if (!format.canExport) {
            EXPECT_THROW(exported(std::string(format.kind)), core::Error) << format.kind;
            continue;
        }
        EXPECT_NO_THROW(exported(std::string(format.kind))) << format.kind;
        if (format.isFolder) {
            const fs::path taken = m_folder / ("taken " + std::string(format.kind));
            fs::create_directories(taken / "something");
            EXPECT_THROW(core::exportAnnotations(m_dataset, sequence(), m_set, format.kind, taken), core::Error)
                << format.kind;
        }
    }
}

TEST_F(AnnotationFormats, FormatsOfOneRaterTakeTheOneWithMostMarks) {
    click(3, {Side::Left, "wrist"}, {1, 2, 3});
    m_set.marks[{3, "aaa", {Side::Left, "wrist"}, "cam0"}] = Mark{{7, 7}};
    EXPECT_EQ(import("deeplabcut", exported("deeplabcut")).set.marks.size(), 8u);
    EXPECT_EQ(import("csv-marks", exported("csv-marks")).set, m_set) << "names raters, so it holds all";
    m_export.rater = "aaa";
    EXPECT_EQ(import("csv-marks", exported("csv-marks")).set.marks.size(), 1u);
}

TEST_F(AnnotationFormats, ProposalsMakeNeitherARaterNorALabelledFrame) {
    m_set.marks[{3, "ann", {Side::Left, "wrist"}, "cam0"}] = Mark{{7, 7}};
    for (const core::Camera& camera : m_dataset.cameras) {
        m_set.marks[{3, "import", {Side::Left, "wrist"}, camera.name}] =
            Mark{{9, 9}, Placement::Proposed, core::MarkState::Visible};
        m_set.marks[{6, "ann", {Side::Left, "wrist"}, camera.name}] =
            Mark{{9, 9}, Placement::Proposed, core::MarkState::Visible};
    }
    const auto coco = core::readJsonFile(exported("coco"));
    EXPECT_EQ(std::pair(coco["images"].size(), coco["annotations"].size()), std::pair(std::size_t{8}, std::size_t{1}))
        << "frame 3";
}

TEST_F(AnnotationFormats, MarkTablesKeepLikelihoodsAndTheirSequences) {
    m_set.marks[{3, "ann", {Side::Left, "wrist"}, "cam0"}] = Mark{{7, 7}};
    EXPECT_EQ(core::readCsv(exported("csv-marks"))[0].size(), 10u) << "as ever without guesses";
    m_set.marks[{3, "ann", {Side::Left, "wrist"}, "cam1"}] =
        Mark{{9, 9}, Placement::Proposed, MarkState::Visible, 0.125};
    const fs::path file = exported("csv-marks");
    EXPECT_EQ(import("csv-marks", file).set, m_set);
    m_import.minLikelihood = 0.5;
    EXPECT_EQ(import("csv-marks", file).set.marks.size(), 1u);
    std::ofstream(file, std::ios::app) << "02,3,ann,left,wrist,cam2,1,2,visible,manual,\n";
    const auto got = import("csv-marks", file);
    EXPECT_EQ(got.set.marks.size(), 1u);
    EXPECT_EQ(got.otherVideos, std::vector<std::string>{"02"});
}

} // namespace
