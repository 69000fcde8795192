// SPDX-License-Identifier: MIT
#include "core/io/benchmark/benchmark_folder.h"

#include <gtest/gtest.h>

#include "core/benchmark/scene_fingerprint.h"
#include "core/error.h"
#include "core/io/files/text_file.h"
#include "tests/core/benchmark/tiny_benchmark.h"
#include "tests/support/temporary_folder.h"

namespace core {
namespace {

namespace fs = std::filesystem;

/// A run with its files, as the batch program does it; stops after `most` fits.
BenchmarkFolder runInto(const fs::path& out, const Shard& shard, int most = 1000000) {
    const BenchmarkScene scene = test::tinyScene();
    BenchmarkOptions options;
    options.methods = {"ch", "dch-thres:tau=45"};
    options.shard = shard;
    BenchmarkFolder folder;
    folder.info = {"tiny",
                   sceneFingerprint(scene),
                   options.setup,
                   options.methods,
                   {},
                   shard,
                   false,
                   benchmarkJoints(scene, options.setup),
                   test::tinyPairs(scene)};
    BenchmarkJournal journal(out, folder.info);
    std::stop_source stop;
    int fits = 0;
    const auto progress = [&](const BenchmarkProgress& state) {
        if (state.latest != nullptr) {
            journal.append(*state.latest);
            fits += 1;
        }
        if (fits >= most)
            stop.request_stop();
    };
    folder.results = runBenchmark(scene, folder.info.pairs, options, test::pretendToFit, progress, stop.get_token(),
                                  journal.finished());
    writeBenchmarkTables(out, folder);
    return folder;
}

const char* const kFiles[] = {"results.csv", "joints.csv", "curves.csv", "table.md", "table.tex", "pairs.json"};

void expectSameFiles(const fs::path& a, const fs::path& b) {
    for (const char* const name : kFiles)
        EXPECT_EQ(readTextFile(a / name), readTextFile(b / name)) << name;
}

TEST(BenchmarkFolder, MergedShardsAreByteForByteTheSingleRun) {
    const test::TemporaryFolder folder;
    runInto(folder / "whole", {});
    for (int i = 0; i < 3; ++i)
        runInto(folder / std::to_string(i), {i, 3});
    const BenchmarkFolder merged = mergedBenchmarkFolders({folder / "2", folder / "0", folder / "1"});
    writeBenchmarkFolder(folder / "merged", merged);
    expectSameFiles(folder / "merged", folder / "whole");
    EXPECT_GT(readTextFile(folder / "whole/results.csv").size(), 1000u);
    EXPECT_EQ(readBenchmarkFolder(folder / "merged").results.rows, readBenchmarkFolder(folder / "whole").results.rows);
}

TEST(BenchmarkFolder, AStoppedRunGoesOnToTheSameFiles) {
    const test::TemporaryFolder folder;
    runInto(folder / "whole", {});
    EXPECT_TRUE(runInto(folder / "stopped", {}, 5).results.stopped);
    EXPECT_EQ(readBenchmarkFolder(folder / "stopped").results.rows.size(), 5u);
    EXPECT_TRUE(readBenchmarkFolder(folder / "stopped").results.stopped);
    EXPECT_TRUE(runInto(folder / "stopped", {}, 4).results.stopped);
    EXPECT_FALSE(runInto(folder / "stopped", {}).results.stopped);
    expectSameFiles(folder / "stopped", folder / "whole");
}

TEST(BenchmarkFolder, MergeSaysWhichShardIsMissingTwiceOrUnfinished) {
    const test::TemporaryFolder folder;
    runInto(folder / "0", {0, 2});
    runInto(folder / "1", {1, 2}, 2);
    const auto message = [](const std::vector<fs::path>& folders) -> std::string {
        try {
            mergedBenchmarkFolders(folders);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(message({folder / "0"}).find("1/2 is missing"), std::string::npos);
    EXPECT_NE(message({folder / "0", folder / "0"}).find("twice"), std::string::npos);
    EXPECT_NE(message({folder / "0", folder / "1"}).find("not finished"), std::string::npos);
    runInto(folder / "1", {1, 2});
    EXPECT_EQ(message({folder / "0", folder / "1"}), "");
    runInto(folder / "other", {1, 3});
    EXPECT_NE(message({folder / "0", folder / "other"}).find("another run"), std::string::npos);
    EXPECT_NE(message({folder / "nowhere"}).find("nowhere"), std::string::npos);
}

TEST(BenchmarkFolder, RemembersWhoseHandsItMeasured) {
    const test::TemporaryFolder folder;
    BenchmarkFolder content = runInto(folder / "run", {});
    EXPECT_FALSE(content.results.papersHands) << "two bones are not the paper's hands";
    EXPECT_FALSE(readBenchmarkFolder(folder / "run").results.papersHands);
    EXPECT_EQ(readTextFile(folder / "run/table.md").find("paper"), std::string::npos);
    EXPECT_EQ(readTextFile(folder / "run/report.html").find("(paper)"), std::string::npos);
    content.info.papersHands = content.results.papersHands = true;
    writeBenchmarkFolder(folder / "papers", content);
    EXPECT_TRUE(readBenchmarkFolder(folder / "papers").results.papersHands);
    EXPECT_NE(readTextFile(folder / "papers/table.md").find("CH (paper)"), std::string::npos);
}

} // namespace
} // namespace core
