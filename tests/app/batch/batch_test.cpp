// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "core/contour/rasteriser.h"
#include "core/io/benchmark/pairs_file.h"
#include "core/io/files/json_file.h"
#include "core/io/footage/image_file.h"
#include "tests/app/batch/program.h"
#include "tests/support/expect_error.h"
#include "tests/support/small_dataset.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::runBatch;

/// Expects a refusal: that status, nothing on standard output, one line on standard error that begins as agreed.
void expectRefused(const Ended& ended, int status, const std::string& beginning, const std::string& word) {
    EXPECT_EQ(ended.status, status) << ended.err;
    EXPECT_TRUE(ended.err.starts_with("handlens-batch: " + beginning)) << ended.err;
    EXPECT_NE(ended.err.find(word), std::string::npos) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_TRUE(ended.err.ends_with("\n")) << ended.err;
}

class Batch : public testing::Test {
protected:
    Batch() { test::writeSmallDataset(m_set); }

    test::TemporaryFolder m_folder;
    std::string m_set = m_folder / "set";
    std::string m_out = m_folder / "out.json";
};

TEST_F(Batch, HelpListsEveryVerbAndEachVerbHasHelp) {
    EXPECT_EQ(runBatch({"--version"}).status, 0);
    const Ended help = runBatch({"--help"});
    EXPECT_EQ(help.status, 0);
    for (const char* verb : {"demo", "import", "check", "info", "joints", "render", "fit", "benchmark", "merge",
                             "triangulate", "calibration", "annotations", "export", "new", "report"}) {
        EXPECT_NE(help.out.find(std::string("\n  ") + verb), std::string::npos) << verb;
        EXPECT_EQ(runBatch({verb, "--help"}).status, 0) << verb;
    }
}

TEST_F(Batch, AnswersBadUsageWithStatusTwo) {
    expectRefused(runBatch({}), 2, "", "subcommand");
    expectRefused(runBatch({"nonsense"}), 2, "", "nonsense");
    expectRefused(runBatch({"joints", m_set}), 2, "", "required");
    expectRefused(runBatch({"joints", m_set, "--sequence", "first", "--frame", "x", "--out", m_out}), 2, "", "--frame");
    expectRefused(runBatch({"fit", m_set, "--sequence", "first", "--start", "0", "--test", "1", "--method", "chh",
                            "--out", m_out}),
                  2, "", "chh");
    expectRefused(runBatch({"import", "tzionas", "--models", m_set, "--ring", "8", "--cameras", "c", "--out", m_out}),
                  2, "", "");
    EXPECT_FALSE(fs::exists(m_out));
}

TEST_F(Batch, ReportsOnAnnotations) {
    const Ended usual = runBatch({"report", m_set});
    EXPECT_EQ(usual.status, 0) << usual.err;
    EXPECT_TRUE(fs::exists(fs::path(m_set) / "report.html"));
    EXPECT_EQ(usual.out, (fs::path(m_set) / "report.html").string() + "\n");
    const std::string page = m_folder / "page.html";
    EXPECT_EQ(runBatch({"report", m_set, "--out", page}).status, 0);
    EXPECT_TRUE(fs::exists(page));
    expectRefused(runBatch({"report", m_folder / "none"}), 1, m_folder / "none", "no such dataset");
    expectRefused(runBatch({"report", m_set, "--bad-px", "-1"}), 2, "", "--bad-px");
}

TEST_F(Batch, AnswersBadInputWithStatusOneAndOneLine) {
    expectRefused(runBatch({"info", m_folder / "none"}), 1, m_folder / "none", "no such dataset");
    expectRefused(runBatch({"joints", m_set, "--sequence", "third", "--frame", "0", "--out", m_out}), 1, m_set,
                  "third");
    expectRefused(runBatch({"joints", m_set, "--sequence", "first", "--frame", "5", "--out", m_out}), 1, "--frame",
                  "frames 0 to 4");
    expectRefused(runBatch({"joints", m_set, "--sequence", "first", "--frame", "-1", "--out", m_out}), 1, "--frame",
                  "frames 0 to 4");
    expectRefused(runBatch({"joints", m_set, "--sequence", "second", "--frame", "0", "--out", m_out}), 1, m_set,
                  "no recorded motion");
    expectRefused(runBatch({"check", m_folder / "a\nb"}), 1, "", "a b");
    EXPECT_FALSE(fs::exists(m_out));
}

TEST_F(Batch, APairsFileIsNotSilentlyAccompaniedByADraw) {
    core::writePairs(m_folder / "pairs.json", {core::FramePair{"first", 0, 1}});
    const std::vector<std::string> plain{"benchmark", m_set, "--pairs", m_folder / "pairs.json",
                                         "--methods", "ch",  "--out",   m_out};
    const std::pair<const char*, const char*> draws[] = {
        {"--fraction", "0.5"}, {"--seed", "3"}, {"--differences", "1,2"}};
    for (const auto& [option, value] : draws) {
        std::vector<std::string> words = plain;
        words.emplace_back(option);
        words.emplace_back(value);
        expectRefused(runBatch(words), 2, std::string("--pairs and ") + option, "give one of them");
        EXPECT_FALSE(fs::exists(m_out));
    }
    EXPECT_EQ(runBatch(plain).status, 0);
}

TEST_F(Batch, SaysThatAnOutputCannotBeWritten) {
    const std::vector<std::string> joints{"joints", m_set, "--sequence", "first", "--frame", "0", "--out"};
    auto to = [&](const std::string& out) {
        std::vector<std::string> words = joints;
        words.push_back(out);
        return runBatch(words);
    };
    expectRefused(to(m_folder / "none/out.json"), 1, m_folder / "none/out.json", "cannot be written");
    if (fs::exists("/dev/full"))
        expectRefused(to("/dev/full"), 1, "/dev/full", "No space left");
}

TEST_F(Batch, ChecksAndDescribesADataset) {
    const Ended check = runBatch({"check", m_set});
    EXPECT_EQ(check.status, 0) << check.err;
    const Ended info = runBatch({"info", m_set, "--json"});
    ASSERT_EQ(info.status, 0) << info.err;
    const nlohmann::json value = nlohmann::json::parse(info.out);
    EXPECT_EQ(value["sequences"][1]["frames"], 7);
    EXPECT_EQ(value["hands"][0]["joints"], (std::vector<std::string>{"forearm", "index_mcp", "index_pip"}));
    fs::remove(m_set + "/motion/first.json");
    const Ended broken = runBatch({"check", m_set});
    EXPECT_EQ(broken.status, 1);
    EXPECT_NE(broken.out.find("first.json: no such file"), std::string::npos) << broken.out;
    EXPECT_EQ(std::count(broken.err.begin(), broken.err.end(), '\n'), 1) << broken.err;
}

TEST_F(Batch, WritesTheJointsOfAFrame) {
    ASSERT_EQ(runBatch({"joints", m_set, "--sequence", "first", "--frame", "3", "--out", m_out}).status, 0);
    const nlohmann::json value = core::readJsonFile(m_out);
    EXPECT_EQ(value["sequence"], "first");
    EXPECT_EQ(value["frame"], 3);
    EXPECT_EQ(value["units"], "mm");
    ASSERT_EQ(value["joints"].size(), 6u);
    const test::SmallDataset small = test::smallDataset();
    const auto right = core::jointPositions(small.dataset.hands[1].skeleton, small.motions[0][3][1]);
    EXPECT_EQ(value["joints"][5]["hand"], "right");
    EXPECT_EQ(value["joints"][5]["name"], "index_pip");
    EXPECT_LT((core::jsonVector(value["joints"][5]["xyz"], "", "") - right[2]).norm(), 1e-9);
}

TEST_F(Batch, DrawsAPicturePerCamera) {
    const test::SmallDataset small = test::smallDataset();
    for (const char* what : {"mask", "shaded", "image"}) {
        const std::string out = m_folder / what;
        ASSERT_EQ(
            runBatch({"render", m_set, "--sequence", "first", "--frame", "2", "--what", what, "--out", out}).status, 0);
        for (const core::Camera& camera : small.dataset.cameras) {
            const cv::Mat image = core::readImage(out + "/" + camera.name + ".png");
            EXPECT_EQ(image.size(), cv::Size(1080, 1920)) << what;
        }
    }
    const cv::Mat wanted = core::renderHandsMask(small.dataset.cameras[1], small.dataset.hands, small.motions[0][2]);
    EXPECT_EQ(cv::norm(core::readMask(m_folder / "mask/cam1.png"), wanted, cv::NORM_INF), 0);
    EXPECT_GT(cv::countNonZero(wanted), 1000);
}

TEST_F(Batch, FitsAPairOfTheDemo) {
    const std::string demo = m_folder / "demo";
    ASSERT_EQ(runBatch({"demo", "--out", demo}).status, 0);
    const nlohmann::json info = nlohmann::json::parse(runBatch({"info", demo, "--json"}).out);
    const std::string sequence = info["sequences"][0]["name"];
    const Ended fit = runBatch({"fit", demo, "--sequence", sequence, "--start", "40", "--test", "45", "--method",
                                "dch-thres:tau=30", "--profile", "--out", m_out});
    ASSERT_EQ(fit.status, 0) << fit.err;
    EXPECT_NE(fit.out.find("matching"), std::string::npos) << fit.out;
    const nlohmann::json value = core::readJsonFile(m_out);
    EXPECT_EQ(value["method"], "dch-thres:tau=30");
    EXPECT_EQ(value["history"].size(), value["iterations"]);
    EXPECT_LT(value["errorMm"].get<double>(), 0.5 * value["initialErrorMm"].get<double>());
    double sum = 0;
    for (const nlohmann::json& joint : value["joints"])
        sum += joint["errorMm"].get<double>();
    EXPECT_NEAR(sum / static_cast<double>(value["joints"].size()), value["errorMm"].get<double>(), 1e-9);
}

} // namespace
