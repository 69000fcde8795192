// SPDX-License-Identifier: MIT
#include "core/io/formats/ground_truth_file.h"

#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/annotation/edits.h"
#include "core/error.h"
#include "core/io/files/json_file.h"
#include "core/io/formats/annotation_formats.h"
#include "tests/support/clicks.h"
#include "tests/support/expect_error.h"
#include "tests/support/recordings/ring_dataset.h"
#include "tests/support/temporary_folder.h"

namespace {

using core::AnnotationSet;
using core::JointId;
using core::Mark;
using core::MarkState;
using core::Placement;
using core::Side;

class GroundTruthFile : public testing::Test {
protected:
    void write() { core::exportAnnotations(m_dataset, m_dataset.sequences[0], m_set, "handlens", m_file, m_options); }
    core::ImportedAnnotations read() {
        return core::importAnnotations(m_dataset, m_dataset.sequences[0], "handlens", m_file);
    }
    nlohmann::json content() { return core::readOwnFile(m_file, "ground-truth"); }

    test::TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "gt.json";
    core::Dataset m_dataset = test::ringDataset();
    AnnotationSet m_set;
    core::AnnotationExportOptions m_options;
    std::mt19937_64 m_random = test::randomFor("GroundTruthFile");
};

TEST_F(GroundTruthFile, SaysOfAJointWhatTheContractAsksFor) {
    const JointId joint{Side::Left, "index_mcp"};
    test::clickEverywhere(m_set, m_dataset.cameras, 4, "ann", joint, {10, 20, 30}, 1.0, &m_random);
    m_set.marks[{4, "ann", joint, "cam1"}].state = MarkState::Occluded;
    m_set.marks[{4, "ann", joint, "cam2"}].placement = Placement::Auto;
    m_set.marks[{4, "ann", joint, "cam3"}].state = MarkState::Unplaceable;
    m_set.marks[{4, "ann", {Side::Left, "wrist"}, "cam0"}] = Mark{{5, 6}};
    write();
    const auto gt = content();
    EXPECT_EQ(gt["units"], "mm");
    EXPECT_EQ(gt["sequence"], "01");
    EXPECT_EQ(gt["cameras"].size(), 8u);
    EXPECT_EQ(gt["joints"], (nlohmann::json{"index_mcp", "wrist"}));
    const auto& rater = gt["frames"][0]["raters"][0];
    EXPECT_EQ(gt["frames"][0]["frame"], 4);
    EXPECT_EQ(rater["rater"], "ann");
    const auto& written = rater["hands"]["left"]["joints"]["index_mcp"];
    const auto shown = core::reconstruct(m_set, m_dataset.cameras, 4, "ann", joint);
    EXPECT_EQ(core::jsonVector(written["xyz"], "", ""),
              shown.result.point->pointInWorld); // exported is what is displayed
    EXPECT_EQ(core::jsonMatrix(written["covariance"], "", ""), shown.result.point->covariance);
    EXPECT_EQ(written["rmsPx"].get<double>(), shown.result.point->rmsPx);
    EXPECT_EQ(written["views"].size(), 7u);
    EXPECT_EQ(written["unplaceable"], nlohmann::json{"cam3"});
    EXPECT_EQ(written["status"], "done");
    EXPECT_EQ(written["views"][1]["state"], "occluded");
    EXPECT_EQ(written["views"][1]["errorPx"].get<double>(), *shown.views[1].errorPx);
    EXPECT_EQ(written["views"][2]["placement"], "auto");
    EXPECT_TRUE(written["views"][2]["errorPx"].is_null());
    const auto& wrist = rater["hands"]["left"]["joints"]["wrist"];
    EXPECT_TRUE(wrist["xyz"].is_null() && wrist["covariance"].is_null() && wrist["rmsPx"].is_null());
    EXPECT_EQ(wrist["status"], "partial");
}

TEST_F(GroundTruthFile, HoldsNoProposals) {
    const JointId joint{Side::Left, "index_mcp"};
    test::clickEverywhere(m_set, m_dataset.cameras, 4, "ann", joint, {10, 20, 30}, 1.0, &m_random);
    m_set.marks[{4, "ann", joint, "cam2"}].placement = Placement::Proposed;
    m_set.marks[{4, "ann", {Side::Left, "wrist"}, "cam0"}] = Mark{{5, 6}, Placement::Proposed, MarkState::Visible};
    m_set.marks[{5, "ann", joint, "cam0"}] = Mark{{5, 6}, Placement::Proposed, MarkState::Visible};
    m_set.marks[{4, "import", joint, "cam0"}] = Mark{{5, 6}, Placement::Proposed, MarkState::Visible};
    write();
    const auto gt = content();
    ASSERT_EQ(gt["frames"].size(), 1u);
    ASSERT_EQ(gt["frames"][0]["raters"].size(), 1u);
    const auto& joints = gt["frames"][0]["raters"][0]["hands"]["left"]["joints"];
    ASSERT_EQ(joints.size(), 1u);
    EXPECT_EQ(joints["index_mcp"]["views"].size(), 7u);
    EXPECT_TRUE(joints["index_mcp"]["unplaceable"].empty());
    EXPECT_EQ(joints["index_mcp"]["status"], "partial");
    EXPECT_EQ(read().set.marks.size(), 7u);
}

TEST_F(GroundTruthFile, ReadsBackExactly) {
    for (const char* rater : {"ann", "Jürgen \"J\""}) {
        for (int frame = 0; frame < 20; frame += 3) {
            for (const Side hand : {Side::Left, Side::Right}) {
                for (const char* joint : {"wrist", "thumb_ip", "little_dip"}) {
                    test::clickEverywhere(m_set, m_dataset.cameras, frame, rater, {hand, joint}, {10.0 * frame, 20, 30},
                                          2.0, &m_random);
                }
            }
        }
    }
    for (auto& [key, mark] : m_set.marks) {
        mark.placement = m_random() % 3 ? Placement::Manual : Placement::Auto;
        mark.state = m_random() % 3 ? MarkState::Visible : MarkState::Occluded;
        if (m_random() % 7 == 0)
            mark = Mark{Eigen::Vector2d::Zero(), Placement::Manual, MarkState::Unplaceable};
    }
    m_set.notes = {{3, "blurred"}, {250, "a note without marks"}};
    write();
    const auto back = read();
    EXPECT_EQ(back.set, m_set);
    EXPECT_TRUE(back.warnings.empty());
}

/// A joint that a program proposed and a person accepted as it stood keeps its place through a file.
TEST_F(GroundTruthFile, AcceptedProposalsKeepTheirPlace) {
    const JointId joint{Side::Right, "ring_pip"};
    core::apply(m_set, core::proposeEdit(m_set, m_dataset.cameras, 4, "ann", {{joint, {10, 20, 30}}}));
    for (auto& [key, mark] : m_set.marks)
        mark.likelihood = 0.875;
    core::apply(m_set, core::acceptProposalsEdit(m_set, m_dataset.cameras, 4, "ann"));
    write();
    EXPECT_EQ(read().set, m_set);
    const auto before = core::reconstruct(m_set, m_dataset.cameras, 4, "ann", joint);
    ASSERT_TRUE(before.isAccepted);

    // files of before this field
    std::string text = test::readText(m_file);
    for (std::size_t at; (at = text.find("\"likelihood\"")) != std::string::npos;) {
        const std::size_t comma = text.rfind(',', at), end = text.find_first_of(",}", at);
        text.erase(comma, end - comma);
    }
    test::writeText(m_file, text);
    const auto after = core::reconstruct(read().set, m_dataset.cameras, 4, "ann", joint);
    ASSERT_TRUE(after.isAccepted);
    EXPECT_EQ(after.result.point->pointInWorld, before.result.point->pointInWorld);
}

TEST_F(GroundTruthFile, WhatNobodyLookedAtIsNotAccepted) {
    const JointId joint{Side::Right, "ring_pip"};
    core::apply(m_set, core::proposeEdit(m_set, m_dataset.cameras, 4, "auto", {{joint, {10, 20, 30}}}));
    core::apply(m_set, core::acceptProposalsEdit(m_set, m_dataset.cameras, 4, "auto"));
    for (auto& [key, mark] : m_set.marks)
        mark.likelihood.reset();
    write();
    nlohmann::json value = content();
    nlohmann::json& hand = value["frames"][0]["raters"][0]["hands"]["right"];
    hand["doubt"] = 0.1;
    hand["joints"]["ring_pip"]["xyz"] = {10, 20, 30};
    test::writeText(m_file, value.dump());
    EXPECT_FALSE(core::reconstruct(read().set, m_dataset.cameras, 4, "auto", joint).hasPoint());
}

TEST_F(GroundTruthFile, HoldsOneRaterIfAsked) {
    m_set.marks[{1, "ann", {Side::Left, "wrist"}, "cam0"}] = Mark{{1, 1}};
    m_set.marks[{2, "bob", {Side::Left, "wrist"}, "cam0"}] = Mark{{2, 2}};
    m_options.rater = "bob";
    write();
    EXPECT_EQ(core::ratersOf(read().set), std::vector<std::string>{"bob"});
    m_options.rater = "nobody";
    EXPECT_THROW(write(), core::Error);
}

TEST_F(GroundTruthFile, LeavesOutWhatDoesNotFitAndSaysSo) {
    m_set.marks[{1, "ann", {Side::Left, "wrist"}, "cam0"}] = Mark{{1, 1}};
    m_set.marks[{1, "ann", {Side::Left, "wrist"}, "cam7"}] = Mark{{2, 2}};
    m_set.marks[{299, "ann", {Side::Left, "wrist"}, "cam0"}] = Mark{{3, 3}};
    write();
    m_dataset.cameras.pop_back();
    m_dataset.sequences[0].frameCount = 100;
    const auto back = read();
    EXPECT_EQ(back.set.marks.size(), 1u);
    ASSERT_EQ(back.warnings.size(), 2u);
    EXPECT_NE((core::importNoteText(back.warnings[0]) + core::importNoteText(back.warnings[1])).find("cam7"),
              std::string::npos);
}

TEST_F(GroundTruthFile, RefusesWhatIsNotGroundTruth) {
    m_set.marks[{1, "ann", {Side::Left, "wrist"}, "cam0"}] = Mark{{1, 1}};
    write();
    const std::string good = core::formatJson(nlohmann::ordered_json::parse(std::ifstream(m_file)));
    const auto refused = [&](const std::string& from, const std::string& to) {
        std::string bad = good;
        const std::size_t place = bad.find(from);
        ASSERT_NE(place, std::string::npos) << from;
        std::ofstream(m_file) << bad.replace(place, from.size(), to);
        EXPECT_THROW(read(), core::Error) << to;
    };
    refused("\"manual\"", "\"by hand\"");
    refused("\"left\"", "\"third\"");
    refused("\"version\": 1", "\"version\": 2");
    refused("\"visible\"", "\"unplaceable\"");
    refused("\"frame\": 1", "\"frame\": -1");
    refused("\"hands\"", "\"feet\"");
    EXPECT_THROW(core::exportAnnotations(m_dataset, m_dataset.sequences[0], m_set, "excel", m_file), core::Error);
}

TEST_F(GroundTruthFile, AJointIsDoneWhenEveryViewWithFootageIs) {
    const JointId joint{Side::Left, "index_mcp"};
    for (int i = 0; i < 3; ++i) {
        m_dataset.sequences[0].views.push_back(
            {m_dataset.cameras[static_cast<std::size_t>(i)].name, core::ViewKind::Video, "v.mp4"});
    }
    m_dataset.sequences[0].views.push_back({"cam3", core::ViewKind::None, ""});
    const auto status = [&] {
        write();
        return content()["frames"][0]["raters"][0]["hands"]["left"]["joints"]["index_mcp"]["status"].get<std::string>();
    };
    test::clickEverywhere(m_set, {m_dataset.cameras[0], m_dataset.cameras[1]}, 4, "ann", joint, {10, 20, 30});
    EXPECT_EQ(status(), "partial");
    test::clickEverywhere(m_set, {m_dataset.cameras[2]}, 4, "ann", joint, {10, 20, 30});
    EXPECT_EQ(status(), "done");
    m_dataset.sequences[0].views[2].missing = {{8, 2}};
    m_set.marks.erase({4, "ann", joint, "cam2"});
    EXPECT_EQ(status(), "partial") << "the camera has a picture of this frame";
    m_dataset.sequences[0].views[2].missing = {{3, 2}};
    EXPECT_EQ(status(), "done");
}

TEST_F(GroundTruthFile, AMarkOutsideThePictureIsNotVisible) {
    const JointId joint{Side::Left, "index_mcp"};
    test::clickEverywhere(m_set, m_dataset.cameras, 4, "ann", joint, {10, 20, 30});
    m_set.marks[{4, "ann", joint, "cam1"}].px = {-25, 40};
    write();
    const auto gt = content();
    const auto& view = gt["frames"][0]["raters"][0]["hands"]["left"]["joints"]["index_mcp"]["views"][1];
    EXPECT_EQ(view["camera"], "cam1");
    EXPECT_EQ(view["px"], (nlohmann::json{-25.0, 40.0})) << "kept";
    EXPECT_EQ(view["state"], "occluded");
    EXPECT_TRUE(view["errorPx"].is_null()) << "no evidence";
    const auto back = read();
    ASSERT_EQ(back.warnings.size(), 1u);
    EXPECT_NE(core::importNoteText(back.warnings[0]).find("1 mark lies outside the picture of cam1"), std::string::npos)
        << core::importNoteText(back.warnings[0]);
}

TEST_F(GroundTruthFile, OneRaterMayTakeAllButNotTwoPeoplesMarksOfOneJoint) {
    const JointId joint{Side::Left, "index_mcp"};
    test::clickEverywhere(m_set, m_dataset.cameras, 4, "ann", joint, {10, 20, 30});
    test::clickEverywhere(m_set, m_dataset.cameras, 5, "ann (again)", joint, {10, 20, 30});
    test::clickEverywhere(m_set, m_dataset.cameras, 6, "bob", joint, {10, 20, 30});
    write();
    core::AnnotationImportOptions options;
    options.rater = "carl";
    const auto all = [&] {
        return core::importAnnotations(m_dataset, m_dataset.sequences[0], "handlens", m_file, options);
    };
    EXPECT_EQ(core::ratersOf(all().set), (std::vector<std::string>{"ann", "ann (again)", "bob"}))
        << "the file says whose";
    options.raterForAll = true;
    EXPECT_EQ(core::ratersOf(all().set), (std::vector<std::string>{"carl", "carl (again)"}));
    EXPECT_EQ(all().set.marks.size(), m_set.marks.size());
    m_set.marks[{4, "bob", joint, "cam1"}] = Mark{{5, 6}};
    write();
    try {
        all();
        ADD_FAILURE() << "ann's and bob's clicks would be one joint";
    } catch (const core::Error& error) {
        EXPECT_NE(std::string(error.what()).find("by ann and by bob"), std::string::npos) << error.what();
    }
}

TEST_F(GroundTruthFile, SaysThatItIsOfAnotherSequence) {
    m_set.marks[{4, "ann", {Side::Left, "wrist"}, "cam0"}] = Mark{{5, 6}};
    write();
    m_dataset.sequences[0].name = "02";
    const auto back = read();
    EXPECT_EQ(back.set.marks.size(), 1u);
    ASSERT_EQ(back.warnings.size(), 1u);
    EXPECT_EQ(core::importNoteText(back.warnings[0]), "the file is of sequence \"01\", not of \"02\"");
}

} // namespace
