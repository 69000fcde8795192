// SPDX-License-Identifier: MIT
#include "core/io/dataset/dataset.h"

#include <gtest/gtest.h>

#include "core/io/dataset/dataset_check.h"
#include "core/io/dataset/sequence_pictures.h"
#include "core/io/hands/motion_file.h"
#include "tests/support/expect_error.h"
#include "tests/support/small_dataset.h"
#include "tests/support/temporary_folder.h"

namespace {

using test::replaced;
using enum core::ErrorCode;

class DatasetFolder : public testing::Test {
protected:
    DatasetFolder() { test::writeSmallDataset(m_path); }

    /// Puts a changed dataset.json in place and expects it to be refused.
    void expectRefused(const std::string& what, const std::string& by, const std::string& field,
                       const std::string& word) {
        const std::string good = test::readText(m_path / "dataset.json");
        test::writeText(m_path / "dataset.json", replaced(good, what, by));
        test::expectError([&] { core::readDataset(m_path); }, BadInput, "dataset.json: " + field, word);
        test::writeText(m_path / "dataset.json", good);
    }

    test::TemporaryFolder m_folder;
    std::filesystem::path m_path = m_folder / "set";
};

TEST_F(DatasetFolder, ReadsBackWhatWasWritten) {
    const test::SmallDataset written = test::smallDataset();
    const core::Dataset read = core::readDataset(m_path);
    EXPECT_EQ(read.folder, m_path);
    EXPECT_EQ(read.name, written.dataset.name);
    EXPECT_EQ(read.cameras.size(), written.dataset.cameras.size());
    EXPECT_EQ(read.hands.size(), 2u);
    EXPECT_EQ(read.handFiles, written.dataset.handFiles);
    ASSERT_EQ(read.sequences.size(), 2u);
    for (std::size_t s = 0; s < 2; ++s) {
        const core::Sequence &a = read.sequences[s], &b = written.dataset.sequences[s];
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.frameCount, b.frameCount);
        EXPECT_EQ(a.framesPerSecond, b.framesPerSecond);
        EXPECT_EQ(a.masks, b.masks);
        EXPECT_EQ(a.motion, b.motion);
        EXPECT_EQ(a.annotations, b.annotations);
        ASSERT_EQ(a.views.size(), b.views.size());
        for (std::size_t v = 0; v < a.views.size(); ++v) {
            EXPECT_EQ(a.views[v].camera, b.views[v].camera);
            EXPECT_EQ(a.views[v].kind, b.views[v].kind);
            EXPECT_EQ(a.views[v].path, b.views[v].path);
            EXPECT_EQ(a.views[v].offsetFrames, b.views[v].offsetFrames);
        }
    }
    EXPECT_EQ(core::readMotion(read, read.sequences[0]), written.motions[0]);
    EXPECT_TRUE(core::readMotion(read, read.sequences[1]).empty());
}

TEST_F(DatasetFolder, FindsSequencesAndCamerasByName) {
    const core::Dataset dataset = core::readDataset(m_path);
    EXPECT_EQ(dataset.sequence("second").frameCount, 7);
    EXPECT_EQ(dataset.cameraIndex("cam1"), 1);
    EXPECT_EQ(dataset.cameraIndex("cam9"), -1);
    test::expectError([&] { dataset.sequence("third"); }, NotFound, m_path.string(), "it has: first, second");
}

TEST_F(DatasetFolder, RefusesWhatDoesNotFitTogether) {
    expectRefused("\"second\"", "\"first\"", "sequences[1].name", "twice");
    expectRefused("\"camera\": \"cam1\"", "\"camera\": \"cam7\"", "sequences[0].views[1].camera", "cam7");
    expectRefused("\"camera\": \"cam1\"", "\"camera\": \"cam0\"", "sequences[0].views[1].camera", "twice");
    expectRefused("\"kind\": \"rendered\"", "\"kind\": \"painted\"", "sequences[0].views[0].kind", "");
    expectRefused("\"kind\": \"rendered\"", "\"kind\": \"video\"", "sequences[0].views[0].path", "missing");
    expectRefused("\"motion/first.json\"", "\"\"", "sequences[0].views[0].kind", "no motion");
    expectRefused("\"frameCount\": 7", "\"frameCount\": 0", "sequences[1].frameCount", "");
    expectRefused("\"side\": \"left\"", "\"side\": \"right\"", "hands[0].side", "other hand");
    expectRefused("hands/right.json", "hands/left.json", "hands[1].side", "other hand");
    expectRefused("\"version\": 1", "\"version\": \"one\"", "version", "");
}

TEST_F(DatasetFolder, KeepsMissingInstantsAndNotes) {
    core::Dataset dataset = core::readDataset(m_path);
    dataset.sequences[1].views[0].missing = {{0, 1}, {3, 4}};
    using Kind = core::FootageNoteKind;
    dataset.sequences[1].notes = {{Kind::LostFrames, {"cam0"}, {{0, 1}, {3, 4}}},
                                  {Kind::OtherRate, {"cam1"}, {}, {29.97}},
                                  {Kind::Simulated},
                                  {Kind::FirstPicturesDiffer, {"cam0", "cam1"}, {}, {0, 12}},
                                  {Kind::Text, {}, {}, {}, "cam0: 5 frames missing"}}; // of before: they come last
    core::rewriteDatasetFile(dataset);
    const core::Sequence read = core::readDataset(m_path).sequences[1];
    EXPECT_EQ(read.views[0].missing, (std::vector<core::InstantRange>{{0, 1}, {3, 4}}));
    EXPECT_TRUE(read.views[1].missing.empty());
    EXPECT_EQ(read.notes, dataset.sequences[1].notes);
    for (const std::vector<core::InstantRange>& bad :
         {std::vector<core::InstantRange>{{3, 1}, {3, 1}}, {{5, 3}}, {{7, 1}}, {{2, 0}}, {{-1, 1}}}) {
        dataset.sequences[1].views[0].missing = bad;
        test::expectError([&] { core::rewriteDatasetFile(dataset); }, BadInput,
                          "dataset.json: sequences[1].views[0].missing", "");
    }
}

TEST_F(DatasetFolder, ReadsNotesThatWereWrittenAsText) {
    const std::string text = replaced(test::readText(m_path / "dataset.json"), "\"frameCount\": 7",
                                      "\"frameCount\": 7, \"notes\": [\"cam1: 8 frames missing after frame 499\"]");
    test::writeText(m_path / "dataset.json", text);
    const core::Sequence read = core::readDataset(m_path).sequences[1];
    EXPECT_EQ(core::notesInWords(read), (std::vector<std::string>{"cam1: 8 frames missing after frame 499"}));
}

TEST_F(DatasetFolder, RefusesNotesThatLackWhatTheirKindSays) {
    const auto expectNoteRefused = [&](const std::string& note, const std::string& field) {
        expectRefused("\"frameCount\": 7", "\"frameCount\": 7, \"footageNotes\": [" + note + "]", field, "");
    };
    const std::string field = "sequences[1].footageNotes[0]";
    expectNoteRefused(R"({"kind": "levels", "cameras": ["cam0"], "numbers": [3]})", field);
    expectNoteRefused(R"({"kind": "lostFrames", "cameras": ["cam0"]})", field);
    expectNoteRefused(R"({"kind": "unevenTimes", "cameras": ["cam0", "cam1"]})", field);
    expectNoteRefused(R"({"kind": "firstPicturesDiffer", "cameras": ["cam0", "cam1"], "numbers": [3]})", field);
    expectNoteRefused(R"({"kind": "sunshine", "cameras": ["cam0"]})", field + ".kind");
}

TEST_F(DatasetFolder, SaysWhichFileIsMissing) {
    std::filesystem::remove(m_path / "hands/right.json");
    test::expectError([&] { core::readDataset(m_path); }, NotFound, "hands/right.json", "no such file");
    std::filesystem::remove(m_path / "cameras.json");
    test::expectError([&] { core::readDataset(m_path); }, NotFound, "cameras.json", "no such file");
    std::filesystem::remove(m_path / "dataset.json");
    test::expectError([&] { core::readDataset(m_path); }, NotFound, "dataset.json", "no such file");
    test::expectError([&] { core::readDataset(m_folder / "none"); }, NotFound, "none", "no such dataset");
}

TEST_F(DatasetFolder, RefusesAMotionOfOtherHandsOrLength) {
    const core::Dataset dataset = core::readDataset(m_path);
    const std::filesystem::path file = m_path / "motion/first.json";
    const std::string good = test::readText(file);
    const auto expectBad = [&](const std::string& what, const std::string& by, const std::string& field) {
        test::writeText(file, replaced(good, what, by));
        test::expectError([&] { core::readMotion(dataset, dataset.sequences[0]); }, BadInput, "first.json: " + field,
                          "");
    };
    expectBad("\"frameCount\": 5", "\"frameCount\": 6", "frameCount");
    expectBad("\"poseSize\": 9", "\"poseSize\": 8", "hands[0].poseSize");
    expectBad("\"side\": \"left\"", "\"side\": \"right\"", "hands");
    expectBad("\"values\": [", "\"values\": [0,", "hands[0].values");
    expectBad("\"values\": [", "\"values\": [null,", "hands[0].values");
}

TEST_F(DatasetFolder, IsNeverWrittenOverAnother) {
    const test::SmallDataset small = test::smallDataset();
    test::expectError([&] { core::writeDataset(small.dataset, small.motions, m_path); }, Io, m_path.string(),
                      "not empty");
    EXPECT_NO_THROW(core::readDataset(m_path));
}

TEST_F(DatasetFolder, IsNotThereAtAllIfItCannotBeWritten) {
    test::SmallDataset small = test::smallDataset();
    small.dataset.sequences[0].views[0].camera = "cam9";
    EXPECT_THROW(core::writeDataset(small.dataset, small.motions, m_folder / "other"), core::Error);
    EXPECT_FALSE(std::filesystem::exists(m_folder / "other"));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(m_folder.path()), {}), 1);
}

TEST_F(DatasetFolder, ChecksFindNoProblemInAGoodOne) {
    for (const core::CheckFinding& finding : core::checkPath(m_path))
        EXPECT_TRUE(finding.isNote) << finding.text;
}

TEST_F(DatasetFolder, ChecksNoteAnglesOutsideTheLimits) {
    core::Dataset dataset = core::readDataset(m_path);
    core::Motion motion = core::readMotion(dataset, dataset.sequences[0]);
    motion[3][1][core::kRigidDofs + 2] = 0.1 + 0.0873; // 5 degrees above the most
    core::writeMotionFile(m_path / "motion/first.json", dataset.hands, motion);
    bool isNoted = false;
    for (const core::CheckFinding& finding : core::checkPath(m_path)) {
        EXPECT_TRUE(finding.isNote) << finding.text;
        isNoted = isNoted ||
                  finding.text ==
                      "motion/first.json: right index_pip.flexion: up to 5.0 degrees outside its limits in 1 frames";
    }
    EXPECT_TRUE(isNoted);
}

TEST_F(DatasetFolder, ChecksListProblemsInsteadOfThrowing) {
    test::writeText(m_path / "motion/first.json", "{");
    const std::vector<core::CheckFinding> findings = core::checkPath(m_path);
    EXPECT_TRUE(std::any_of(
        findings.begin(), findings.end(),
        [](const core::CheckFinding& f) { return !f.isNote && f.text.find("first.json") != std::string::npos; }));
    test::expectError([&] { core::checkPath(m_folder / "none"); }, NotFound, "none", "no such file");
}

TEST_F(DatasetFolder, ChecksNameEveryBrokenFile) {
    test::writeText(m_path / "hands/left.json", "{");
    test::writeText(m_path / "hands/right.json", "[");
    test::writeText(m_path / "cameras.json", "");
    std::string all;
    for (const core::CheckFinding& finding : core::checkPath(m_path))
        all += finding.text + "\n";
    for (const char* name : {"left.json", "right.json", "cameras.json"})
        EXPECT_NE(all.find(name), std::string::npos) << all;
}

TEST_F(DatasetFolder, ChecksFindMissingAndShortFootage) {
    core::Dataset dataset = core::readDataset(m_path);
    dataset.sequences[1].views[0] = {"cam0", core::ViewKind::Video, "none.mp4", 0};
    dataset.sequences[1].views[1] = {"cam1", core::ViewKind::Images, "shots/{frame}.png", 0};
    core::rewriteDatasetFile(dataset);
    std::string all;
    for (const core::CheckFinding& finding : core::checkPath(m_path))
        all += finding.isNote ? "" : finding.text + "\n";
    EXPECT_NE(all.find("none.mp4: no such video"), std::string::npos) << all;
    EXPECT_NE(all.find("shots/0.png: no such file, nor 1.png, 2.png"), std::string::npos)
        << "all that are gone: " << all;
}

TEST_F(DatasetFolder, CamerasWithoutFootageCountOnlyWhereThereIsNoneAtAll) {
    core::Dataset dataset = core::readDataset(m_path);
    core::Sequence& sequence = dataset.sequences[1];
    for (core::ViewSource& view : sequence.views)
        view.kind = core::ViewKind::None;
    EXPECT_TRUE(core::pictureGaps(dataset, sequence).cameras.empty());
    sequence.views[0] = {"cam0", core::ViewKind::Images, "shots/{frame}.png", 0};
    EXPECT_EQ(core::pictureGaps(dataset, sequence).cameras.size(), dataset.cameras.size() - 1);
}

TEST_F(DatasetFolder, ChecksSingleFiles) {
    EXPECT_TRUE(core::checkPath(m_path / "cameras.json").empty());
    EXPECT_TRUE(core::checkPath(m_path / "motion/first.json").empty());
    test::writeText(m_folder / "other.json", "{\"a\": 1}");
    ASSERT_EQ(core::checkPath(m_folder / "other.json").size(), 1u);
    EXPECT_FALSE(core::checkPath(m_folder / "other.json").front().isNote);
}

} // namespace
