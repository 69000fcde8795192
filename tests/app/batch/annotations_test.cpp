// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/dataset/dataset_annotations.h"
#include "core/io/files/json_file.h"
#include "core/io/store/annotation_store.h"
#include "tests/app/batch/program.h"
#include "tests/support/small_dataset.h"
#include "tests/support/temporary_folder.h"

namespace {

using core::JointId;
using core::Side;
using test::Ended;
using test::runBatch;

/// The verb that imports, on a dataset without marks.
class AnnotationsVerb : public testing::Test {
protected:
    AnnotationsVerb() {
        test::writeSmallDataset(m_set);
        m_camera = core::readDataset(m_set).cameras[0].name;
        m_other = core::readDataset(m_set).cameras[1].name;
    }

    /// A ground truth file in which anna has clicked the left index in both cameras of frame 1, with a note.
    std::string groundTruth(double x, const std::string& note) {
        const auto view = [x](const std::string& camera) {
            return nlohmann::json{{"camera", camera},
                                  {"px", {x, 20}},
                                  {"state", "visible"},
                                  {"placement", "manual"},
                                  {"errorPx", nullptr}};
        };
        const nlohmann::json joint{{"xyz", nullptr},
                                   {"covariance", nullptr},
                                   {"rmsPx", nullptr},
                                   {"views", {view(m_camera), view(m_other)}},
                                   {"unplaceable", nlohmann::json::array()},
                                   {"status", "done"}};
        const nlohmann::json frame{
            {"frame", 1},
            {"note", note},
            {"raters", {{{"rater", "anna"}, {"hands", {{"left", {{"joints", {{"index_mcp", joint}}}}}}}}}}};
        const nlohmann::json file{{"format", "handlens-ground-truth"},
                                  {"version", 1},
                                  {"units", "mm"},
                                  {"cameras", nlohmann::json::array()},
                                  {"sequence", "first"},
                                  {"joints", {"index_mcp"}},
                                  {"frames", {frame}}};
        const std::string path = m_folder / ("gt" + std::to_string(static_cast<int>(x)) + note + ".json");
        std::ofstream(path) << file.dump();
        return path;
    }
    std::string table(const std::string& text) {
        const std::string path = m_folder / (m_camera + ".csv");
        std::ofstream(path) << text;
        return path;
    }
    Ended import(const std::string& kind, const std::string& file, std::vector<std::string> options = {}) {
        std::vector<std::string> words{"annotations", m_set, "--sequence", "first", "--from", kind, file};
        words.insert(words.end(), options.begin(), options.end());
        return runBatch(words);
    }
    core::AnnotationSet stored() {
        const core::Dataset dataset = core::readDataset(m_set);
        return core::readAnnotations(dataset, dataset.sequence("first"));
    }
    std::optional<core::Mark> mark(const std::string& rater) {
        return core::markAt(stored(), {1, rater, {Side::Left, "index_mcp"}, m_camera});
    }

    test::TemporaryFolder m_folder;
    std::string m_set = m_folder / "set";
    std::string m_camera, m_other;
};

TEST_F(AnnotationsVerb, AsksBeforeItReplacesMarksAndNotes) {
    const Ended first = import("handlens", groundTruth(10, "a"));
    ASSERT_EQ(first.status, 0) << first.err;
    EXPECT_NE(first.out.find("2 marks read, 2 changed\n1 notes read, 1 changed\n"), std::string::npos) << first.out;
    const core::AnnotationSet before = stored();
    const Ended refused = import("handlens", groundTruth(30, "b"));
    EXPECT_EQ(refused.status, 1);
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_NE(refused.err.find("would replace 2 marks of anna and 1 note in 1 frame: choose --replace or --keep"),
              std::string::npos)
        << refused.err;
    EXPECT_EQ(stored(), before);
    EXPECT_EQ(import("handlens", groundTruth(30, "b"), {"--keep"}).status, 0);
    EXPECT_EQ(stored(), before);
    const Ended replaced = import("handlens", groundTruth(30, "b"), {"--replace"});
    EXPECT_EQ(replaced.status, 0) << replaced.err;
    EXPECT_EQ(mark("anna")->px.x(), 30);
    EXPECT_EQ(stored().notes.at(1), "b");
    EXPECT_EQ(import("handlens", groundTruth(30, "b")).status, 0) << "nothing to ask about";
    EXPECT_EQ(import("handlens", groundTruth(30, "b"), {"--keep", "--replace"}).status, 2);
    auto store = core::AnnotationStore::open(
        core::annotationFile(core::readDataset(m_set), core::readDataset(m_set).sequence("first")));
    EXPECT_TRUE(store.undo());
    EXPECT_EQ(store.annotations(), before) << "one step";
}

TEST_F(AnnotationsVerb, ARaterThatIsNamedTakesAllMarksOfEveryKind) {
    ASSERT_EQ(import("handlens", groundTruth(10, "a"), {"--rater", "bob"}).status, 0);
    EXPECT_TRUE(mark("bob"));
    EXPECT_FALSE(mark("anna"));
    EXPECT_EQ(import("handlens", groundTruth(30, "a")).status, 0) << "anna's marks replace nothing";
    EXPECT_EQ(mark("anna")->px.x(), 30);
    EXPECT_EQ(mark("bob")->px.x(), 10);
    EXPECT_EQ(import("handlens", groundTruth(10, "a"), {"--rater", ""}).status, 2);
}

TEST_F(AnnotationsVerb, TheLoginNameIsTheRaterOfFilesThatNameNone) {
    ASSERT_EQ(::setenv("LOGNAME", "carla", 1), 0);
    const Ended ended = import(
        "deeplabcut", table("scorer,x,x\nbodyparts,left_index_mcp,left_index_mcp\ncoords,x,y\nimg1.png,10,20\n"));
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(mark("carla")->px.x(), 10);
}

TEST_F(AnnotationsVerb, GuessesComeAsProposals) {
    const std::string file = table("scorer,net,net,net\nbodyparts,left_index_mcp,left_index_mcp,left_index_mcp\ncoords,"
                                   "x,y,likelihood\n1,10,20,0.003\n2,11,21,0.9\n");
    const Ended ended = import("anipose2d", file, {"--rater", "net"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(*mark("net"), (core::Mark{{10, 20}, core::Placement::Proposed, core::MarkState::Visible, 0.003}));
    EXPECT_EQ(import("anipose2d", file, {"--rater", "likely", "--min-likelihood", "0.5"}).status, 0);
    EXPECT_FALSE(mark("likely"));
    EXPECT_EQ(stored().marks.size(), 3u);
}

TEST_F(AnnotationsVerb, UnknownBodyPartsAreTheReasonWhateverElseTheTableHolds) {
    std::string parts = "bodyparts", coords = "coords", scorer = "scorer", values;
    for (const char* part : {"IndexMCP", "IndexTip", "MCP2", "MCP3", "MCP4", "Wrist"}) {
        scorer += ",x,x";
        parts += std::string(",") + part + "," + part;
        coords += ",x,y";
        values += ",10,20";
    }
    const std::string file = table(scorer + "\n" + parts + "\n" + coords + "\nlabeled-data/first/img1.png" + values +
                                   "\nlabeled-data/other/img1.png" + values + "\n");
    const Ended refused = import("deeplabcut", file, {"--rater", "x"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_EQ(refused.err.find("--video"), std::string::npos) << "labels of another session are not offered";
    EXPECT_NE(refused.err.find("left out: 6 marks of body parts that are not joints (IndexMCP, IndexTip, MCP2, MCP3, "
                               "MCP4 and 1 more): a name that fits is left_index_mcp; --map FILE"),
              std::string::npos)
        << refused.err;
    EXPECT_TRUE(stored().marks.empty());
}

TEST_F(AnnotationsVerb, LabelsOfAnotherVideoAreRefusedUntilTheyAreNamed) {
    const std::string file =
        table("scorer,x,x\nbodyparts,left_index_mcp,left_index_mcp\ncoords,x,y\nlabeled-data/monday/img1.png,10,20\n");
    const Ended refused = import("deeplabcut", file, {"--rater", "x"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(
        refused.err.find("has labels of monday, but none of sequence first: if they belong there, say --video monday"),
        std::string::npos)
        << refused.err;
    EXPECT_TRUE(stored().marks.empty());
    const Ended named = import("deeplabcut", file, {"--rater", "x", "--video", "monday"});
    EXPECT_EQ(named.status, 0) << named.err;
    EXPECT_EQ(mark("x")->px.x(), 10);
    const Ended both = import(
        "deeplabcut",
        table("scorer,x,x\nbodyparts,left_index_mcp,left_index_mcp\ncoords,x,y\nlabeled-data/monday/img1.png,9,20\n"
              "labeled-data/first/img2.png,11,20\n"),
        {"--rater", "y"});
    EXPECT_EQ(both.status, 0) << both.err;
    EXPECT_NE(both.out.find("1 row of other videos left out: monday"), std::string::npos) << both.out;
    EXPECT_FALSE(mark("y"));
}

TEST_F(AnnotationsVerb, MarksOutsideThePictureAreNotedByTheImportAndByTheCheck) {
    const Ended ended = import(
        "deeplabcut",
        table("scorer,x,x\nbodyparts,left_index_mcp,left_index_mcp\ncoords,x,y\nimg1.png,-10,20\nimg2.png,-1,-1\n"),
        {"--rater", "x"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("1 mark lies outside the picture of " + m_camera), std::string::npos) << ended.out;
    EXPECT_EQ(stored().marks.size(), 1u) << "-1 -1 is missing";
    const Ended check = runBatch({"check", m_set});
    EXPECT_EQ(check.status, 0) << check.out;
    EXPECT_NE(check.out.find("1 mark lies outside the picture of " + m_camera), std::string::npos) << check.out;
}

} // namespace
