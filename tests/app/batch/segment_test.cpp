// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/contour/rasteriser.h"
#include "core/io/demo/demo_dataset.h"
#include "core/io/footage/image_file.h"
#include "core/segmentation/silhouette.h"
#include "tests/app/batch/program.h"
#include "tests/support/expect_error.h"
#include "tests/support/small_dataset.h"
#include "tests/support/temporary_folder.h"

namespace {

using test::Ended;
using test::runBatch;

/// A dataset of rendered views: their pictures show exactly the recorded poses.
class BatchSegment : public testing::Test {
protected:
    BatchSegment() {
        ::setenv("XDG_DATA_HOME", m_folder.path().c_str(), 1);
        test::writeSmallDataset(m_set);
    }
    ~BatchSegment() override { ::unsetenv("XDG_DATA_HOME"); }

    Ended segment(std::vector<std::string> more, const std::string& how = "model") const {
        std::vector<std::string> arguments{"segment", m_set, "--sequence", "first", "--how", how, "--out", m_out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runBatch(arguments);
    }
    std::filesystem::path mask(int camera, int frame) const {
        return std::filesystem::path(m_out) / ("cam" + std::to_string(camera)) /
               ("00000" + std::to_string(frame) + ".png");
    }
    double overlapWithTruth(int camera, int frame) const {
        const test::SmallDataset small = test::smallDataset();
        const auto c = static_cast<std::size_t>(camera);
        const cv::Mat truth = core::renderHandsMask(small.dataset.cameras[c], small.dataset.hands,
                                                    small.motions[0][static_cast<std::size_t>(frame)]);
        const cv::Mat found = core::readMask(mask(camera, frame));
        return static_cast<double>(cv::countNonZero(found & truth)) / cv::countNonZero(found | truth);
    }

    /// A ground truth file with the joints of one frame.
    nlohmann::json labelsOf(const core::Dataset& dataset, const std::string& sequence, int frame,
                            const core::HandPoses& poses) const {
        nlohmann::json hands;
        for (std::size_t h = 0; h < 2; ++h) {
            const core::HandModel& hand = dataset.hands[h];
            const auto joints = core::jointPositions(hand.skeleton, poses[h]);
            for (std::size_t b = 0; b < joints.size(); ++b)
                hands[std::string(core::sideName(hand.side))]["joints"][hand.skeleton.bones[b].name] = {
                    {"xyz", {joints[b].x(), joints[b].y(), joints[b].z()}},
                    {"covariance", nullptr},
                    {"rmsPx", 0},
                    {"views", nlohmann::json::array()},
                    {"unplaceable", nlohmann::json::array()},
                    {"status", "done"}};
        }
        const auto raters = nlohmann::json::array({{{"rater", "auto"}, {"hands", hands}}});
        return {{"format", "handlens-ground-truth"},
                {"version", 1},
                {"units", "mm"},
                {"cameras", nlohmann::json::parse(test::readText(m_set + "/cameras.json"))["cameras"]},
                {"sequence", sequence},
                {"joints", nlohmann::json::array()},
                {"frames", nlohmann::json::array({{{"frame", frame}, {"raters", raters}}})}};
    }

    test::TemporaryFolder m_folder;
    std::string m_set = m_folder / "set", m_out = m_folder / "masks";
};

TEST_F(BatchSegment, MakesMasksByThePosedModelAndAttachesThem) {
    const Ended ended = segment({"--frames", "0:4:2", "--attach"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("6 masks made"), std::string::npos) << ended.out;
    for (const int frame : {0, 2})
        for (const int camera : {0, 1, 2})
            EXPECT_GT(overlapWithTruth(camera, frame), 0.95) << camera << " " << frame;
    EXPECT_FALSE(std::filesystem::exists(mask(0, 1)));
    const core::Dataset dataset = core::readDataset(m_set);
    EXPECT_EQ(core::maskPattern(dataset.sequence("first"), "cam1"), "../masks/{camera}/{frame:06}.png");
    EXPECT_EQ(dataset.sequence("first").masksMadeBy.rfind("model by motion, band 6 mm", 0), 0u)
        << dataset.sequence("first").masksMadeBy;
    const auto record = nlohmann::json::parse(test::readText(m_out + "/segmentation.json"));
    EXPECT_EQ(record["method"], "model");
    EXPECT_EQ(record["evidence"], "motion");
    EXPECT_EQ(record["options"]["bandMm"], 6);
    EXPECT_EQ(runBatch({"check", m_set}).status, 0);
}

TEST_F(BatchSegment, KeepsWhatIsThereAndMakesTheRest) {
    ASSERT_EQ(segment({"--frames", ":2"}).status, 0);
    const cv::Mat touched(1920, 1080, CV_8U, cv::Scalar(255)); // as a person has left it
    core::writePng(mask(1, 0), touched);
    std::filesystem::remove(mask(2, 1));
    const Ended ended = segment({"--frames", ":2"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("1 masks made"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("5 were there already"), std::string::npos) << ended.out;
    EXPECT_EQ(cv::countNonZero(core::readMask(mask(1, 0))), 1080 * 1920);
    EXPECT_GT(overlapWithTruth(2, 1), 0.95);
}

TEST_F(BatchSegment, StopsCleanlyAndGoesOn) {
    const std::vector<std::string> arguments{"segment", m_set, "--sequence", "first", "--how", "model", "--out", m_out};
    const Ended ended = test::runBatchUntil(arguments, m_out + "/segmentation.json", SIGINT);
    EXPECT_EQ(ended.status, 130) << ended.err;
    EXPECT_NE(ended.err.find("the same command goes on"), std::string::npos) << ended.err;
    for (const auto& file : std::filesystem::recursive_directory_iterator(m_out))
        if (file.path().extension() == ".png")
            EXPECT_EQ(core::readMask(file.path()).size(), cv::Size(1080, 1920)) << file.path();
    const Ended rest = segment({});
    ASSERT_EQ(rest.status, 0) << rest.err;
    EXPECT_GT(overlapWithTruth(2, 4), 0.95);
}

TEST_F(BatchSegment, RefusesToMixMasksAndToReplaceThem) {
    ASSERT_EQ(segment({"--frames", ":1", "--attach"}).status, 0);
    Ended ended = segment({"--frames", ":1", "--band", "4"});
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("segmentation.json: the masks there are"), std::string::npos) << ended.err;
    const std::string other = m_folder / "other";
    std::vector<std::string> again{"segment",  m_set, "--sequence", "first", "--how",   "skin",
                                   "--frames", ":1",  "--out",      other,   "--attach"};
    ended = runBatch(again);
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("--replace"), std::string::npos) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(other)) << "nothing is begun that cannot be finished";
    again.emplace_back("--replace");
    ended = runBatch(again);
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(core::readDataset(m_set).sequence("first").masksMadeBy.rfind("skin", 0), 0u);
}

TEST_F(BatchSegment, RefusesAFolderOfOtherFiles) {
    std::filesystem::create_directory(m_out);
    test::writeText(m_out + "/notes.txt", "mine");
    const Ended ended = segment({});
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("masks: segmentation.json: is missing"), std::string::npos) << ended.err;
}

TEST_F(BatchSegment, SaysWhereTheJointsOfAFileDoNotPlaceAHandAndRefusesThoseOfAnotherSequence) {
    const test::SmallDataset small = test::smallDataset();
    const nlohmann::json file = labelsOf(small.dataset, "first", 1, small.motions[0][1]);
    const std::string labels = m_folder / "labels.json";
    test::writeText(labels, file.dump());
    const Ended ended = segment({"--labels", labels});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("nothing is known of the hands there"), std::string::npos)
        << "hands with joints on a line cannot be placed: " << ended.out;
    test::writeText(labels, nlohmann::json(file).dump().replace(file.dump().find("\"first\""), 7, "\"other\""));
    EXPECT_NE(segment({"--labels", labels}).err.find("labels.json: sequence"), std::string::npos);
}

/// The demo's hands, whose joints place them, seen by two cameras.
class BatchSegmentDemo : public BatchSegment {
protected:
    static constexpr int kFrame = 40;
    BatchSegmentDemo() {
        m_set = m_folder / "demo";
        m_demo.dataset.cameras.resize(2);
        m_demo.dataset.sequences.resize(1);
        m_demo.dataset.sequences[0].views.resize(2);
        m_demo.motions.resize(1);
        core::writeDataset(m_demo.dataset, m_demo.motions, m_set);
        test::writeText(m_labels, labelsOf(m_demo.dataset, name(), kFrame, m_demo.motions[0][kFrame]).dump());
    }
    const std::string& name() const { return m_demo.dataset.sequences[0].name; }
    Ended segment(const std::string& how, std::vector<std::string> more) const {
        std::vector<std::string> arguments{"segment", m_set, "--sequence", name(),  "--how",    how,
                                           "--out",   m_out, "--frames",   "40:41", "--labels", m_labels};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runBatch(arguments);
    }
    double overlap(int camera) const {
        const core::Camera& one = m_demo.dataset.cameras[static_cast<std::size_t>(camera)];
        const cv::Mat truth = core::renderHandsMask(one, m_demo.dataset.hands, m_demo.motions[0][kFrame]);
        return core::maskOverlap(core::readMask(std::filesystem::path(m_out) / one.name / "000040.png"), truth);
    }

    core::NewDataset m_demo = core::makeDemoDataset();
    std::string m_labels = m_folder / "labels.json";
};

TEST_F(BatchSegmentDemo, MakesMasksByTheJointsOfAFile) {
    const Ended ended = segment("model", {"--attach"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("2 masks made"), std::string::npos) << ended.out;
    for (const int camera : {0, 1})
        EXPECT_GT(overlap(camera), 0.97) << camera;
    const std::string madeBy = core::readDataset(m_set).sequence(name()).masksMadeBy;
    EXPECT_EQ(madeBy.rfind("model by labels, band 6 mm", 0), 0u) << madeBy;
}

TEST_F(BatchSegmentDemo, MethodsWithoutModelEndForearmsAtTheJointsOfAFile) {
    const Ended ended = segment("skin", {"--forearm", "0.5", "--attach"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    const std::string madeBy = core::readDataset(m_set).sequence(name()).masksMadeBy;
    EXPECT_EQ(madeBy.rfind("skin, forearm 0.5 by labels", 0), 0u) << madeBy;
    const auto record = nlohmann::json::parse(test::readText(m_out + "/segmentation.json"));
    EXPECT_EQ(record["options"]["joints"], "labels");
    EXPECT_EQ(record["options"]["forearmPalms"], 0.5);
}

TEST_F(BatchSegment, SaysWhatIsMissing) {
    Ended ended = runBatch({"segment", m_set, "--sequence", "second", "--how", "model", "--out", m_out});
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("no camera has pictures"), std::string::npos) << ended.err;
    ended = segment({}, "landmarks");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("npm pack @mediapipe/hands"), std::string::npos) << ended.err;
    ended = segment({}, "magic");
    EXPECT_EQ(ended.status, 2);
    ended = segment({"--backdrop", "green"}, "chroma");
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.err.find("--backdrop"), std::string::npos) << ended.err;
    ended = segment({"--background", m_folder / "nowhere"}, "background");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("cam0.png"), std::string::npos) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(m_out));
}

} // namespace
