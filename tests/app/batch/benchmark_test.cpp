// SPDX-License-Identifier: MIT
#include <csignal>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/files/csv_text.h"
#include "core/io/files/json_file.h"
#include "core/io/files/text_file.h"
#include "tests/app/batch/program.h"
#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tiny_dataset.h"

namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::runBatch;

/// The tiny hands, and the folders of a benchmark on them.
class BatchBenchmark : public testing::Test {
protected:
    BatchBenchmark() { test::writeTinyDataset(m_set, 4); }

    std::vector<std::string> command(const fs::path& out, const std::string& fraction = "0.2",
                                     const std::string& shard = "0/1") const {
        return {"benchmark",     m_set, "--sequences", "a", "--fraction", fraction,
                "--differences", "1,5", "--seed",      "7", "--methods",  "ch,dch-thres:tau=45",
                "--shard",       shard, "--out",       out};
    }

    test::TemporaryFolder m_folder;
    std::string m_set = m_folder / "set";
};

/// The lines of results.csv without their last column, the seconds.
std::vector<std::string> resultsOf(const fs::path& folder) {
    std::vector<std::string> lines;
    std::istringstream text(core::readTextFile(folder / "results.csv"));
    for (std::string line; std::getline(text, line);)
        lines.push_back(line.substr(0, line.rfind(',')));
    return lines;
}

TEST_F(BatchBenchmark, WritesTablesCurvesAndAReport) {
    const fs::path out = m_folder / "out";
    const Ended ended = runBatch(command(out));
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("| dch-thres:tau=45 |"), std::string::npos) << ended.out;
    const std::vector<std::string> lines = resultsOf(out);
    ASSERT_EQ(lines.size(), 1u + 6 * 2 * 2) << "6 of 30 frames, 2 differences, 2 methods";
    EXPECT_EQ(lines[0], "sequence,start,test,difference,method,initial_error_mm,error_mm,iterations");
    const std::vector<core::HandModel> hands = test::tinyHands();
    const std::vector<core::HandPoses> motion = test::tinyMotion(30);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        std::vector<std::string> cells;
        std::istringstream line(lines[i]);
        for (std::string cell; std::getline(line, cell, ',');)
            cells.push_back(cell);
        ASSERT_EQ(cells.size(), 8u) << lines[i];
        EXPECT_EQ(std::stoi(cells[2]) - std::stoi(cells[1]), std::stoi(cells[3])) << lines[i];
        const auto& start = motion[static_cast<std::size_t>(std::stoi(cells[1]))];
        const auto& truth = motion[static_cast<std::size_t>(std::stoi(cells[2]))];
        EXPECT_NEAR(std::stod(cells[5]), core::meanJointDistanceMm(hands, start, truth), 1e-5) << lines[i];
        EXPECT_TRUE(cells[3] == "1" || std::stod(cells[6]) < std::stod(cells[5])) << lines[i];
    }
    const nlohmann::json pairs = core::readJsonFile(out / "pairs.json");
    EXPECT_EQ(pairs["pairs"].size(), 12u);
    for (const char* file : {"joints.csv", "curves.csv", "table.md", "table.tex", "report.html"})
        EXPECT_GT(fs::file_size(out / file), 100u) << file;
    const std::string report = core::readTextFile(out / "report.html");
    for (const char* loading : {"src=\"http", "href=\"http", "url(http", "@import"})
        EXPECT_EQ(report.find(loading), std::string::npos) << "the report needs no network";
}

TEST_F(BatchBenchmark, MergesShardsIntoTheWholeRun) {
    ASSERT_EQ(runBatch(command(m_folder / "whole")).status, 0);
    for (const char* shard : {"0", "1"}) {
        ASSERT_EQ(runBatch(command(m_folder / shard, "0.2", std::string(shard) + "/2")).status, 0);
        EXPECT_LT(resultsOf(m_folder / shard).size(), 25u);
    }
    const Ended merged = runBatch({"merge", m_folder / "1", m_folder / "0", "--out", m_folder / "merged"});
    ASSERT_EQ(merged.status, 0) << merged.err;
    EXPECT_NE(merged.out.find("| ch |"), std::string::npos) << merged.out;
    EXPECT_EQ(resultsOf(m_folder / "merged"), resultsOf(m_folder / "whole"));
    EXPECT_EQ(core::readTextFile(m_folder / "merged/joints.csv"), core::readTextFile(m_folder / "whole/joints.csv"));
    const Ended partial = runBatch({"merge", m_folder / "1", "--out", m_folder / "partial"});
    EXPECT_EQ(partial.status, 2) << partial.err;
    EXPECT_FALSE(fs::exists(m_folder / "partial"));
}

TEST_F(BatchBenchmark, ThatIsInterruptedKeepsItsWorkAndContinues) {
    ASSERT_EQ(runBatch(command(m_folder / "whole", "0.8")).status, 0);
    const fs::path out = m_folder / "out";
    for (const auto& [signal, status] : {std::pair(SIGINT, 130), std::pair(SIGTERM, 143)}) {
        fs::remove_all(out);
        const Ended stopped = test::runBatchUntil(command(out, "0.8"), out / "finished.jsonl", signal);
        ASSERT_EQ(stopped.status, status) << stopped.err;
        EXPECT_TRUE(
            stopped.err.ends_with("stopped; what is finished is kept, and the same command continues from there\n"))
            << stopped.err;
        EXPECT_EQ(stopped.err.find("usage"), std::string::npos) << stopped.err;
        EXPECT_GT(resultsOf(out).size(), 1u);
    }
    ASSERT_EQ(runBatch(command(out, "0.8")).status, 0);
    EXPECT_EQ(resultsOf(out), resultsOf(m_folder / "whole"));
}

TEST_F(BatchBenchmark, PrintsItsProgressToStandardError) {
    const Ended ended = runBatch(
        {"benchmark", m_set, "--sequences", "a", "--fraction", "0.8", "--differences", "1,2,3,4,5", "--methods",
         "ch,ch:schedule=paper,dch-thres,dch-quant,dch-quant2,dch-dt3,best", "--out", m_folder / "out"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(ended.out.find(" of "), std::string::npos) << ended.out;
    EXPECT_NE(ended.err.find("benchmark: "), std::string::npos) << "it takes more than a second";
}

} // namespace
