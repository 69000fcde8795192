// SPDX-License-Identifier: MIT
#include "core/io/benchmark/benchmark_journal.h"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/io/files/text_file.h"
#include "tests/core/benchmark/hand_made_results.h"
#include "tests/support/temporary_folder.h"

namespace core {
namespace {

BenchmarkRunInfo handMadeInfo() {
    const BenchmarkResults results = test::handMadeResults();
    BenchmarkRunInfo info;
    info.dataset = "some/where";
    info.fingerprint = "0123456789abcdef";
    info.methods = {"ch"};
    info.joints = results.joints;
    info.pairs = results.pairs;
    return info;
}

std::vector<PairResult> rowsOfCh() {
    std::vector<PairResult> rows = test::handMadeResults().rows;
    std::erase_if(rows, [](const PairResult& row) { return row.method != "ch"; });
    return rows;
}

/// Equal, NaN to NaN.
void expectSame(const std::vector<PairResult>& a, const std::vector<PairResult>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].pair, b[i].pair);
        EXPECT_EQ(a[i].method, b[i].method);
        EXPECT_EQ(a[i].errorMm, b[i].errorMm);
        EXPECT_EQ(a[i].initialErrorMm, b[i].initialErrorMm);
        EXPECT_EQ(a[i].seconds, b[i].seconds);
        EXPECT_EQ(a[i].iterations, b[i].iterations);
        EXPECT_EQ(a[i].costRises, b[i].costRises);
        ASSERT_EQ(a[i].jointErrorsMm.size(), b[i].jointErrorsMm.size());
        for (std::size_t j = 0; j < a[i].jointErrorsMm.size(); ++j) {
            EXPECT_EQ(std::isnan(a[i].jointErrorsMm[j]), std::isnan(b[i].jointErrorsMm[j]));
            EXPECT_TRUE(std::isnan(a[i].jointErrorsMm[j]) || a[i].jointErrorsMm[j] == b[i].jointErrorsMm[j]);
        }
    }
}

TEST(BenchmarkJournal, RunInfoReadsBackEqual) {
    const test::TemporaryFolder folder;
    BenchmarkRunInfo info = handMadeInfo();
    info.setup = BenchmarkSetup::Realistic;
    info.shard = {2, 5};
    info.sweep = true;
    info.external = {"a \"tracker\""};
    writeRunInfo(folder.path(), info);
    EXPECT_EQ(readRunInfo(folder.path()), info);
}

TEST(BenchmarkJournal, KeepsEveryLineForTheNextRun) {
    const test::TemporaryFolder folder;
    const std::vector<PairResult> rows = rowsOfCh();
    {
        BenchmarkJournal journal(folder / "out", handMadeInfo());
        EXPECT_TRUE(journal.finished().empty());
        journal.append(rows[0]);
        journal.append(rows[1]);
        expectSame(readFinishedRows(folder / "out", 3), {rows[0], rows[1]}); // on the disk before it is closed
    }
    BenchmarkJournal journal(folder / "out", handMadeInfo());
    expectSame(journal.finished(), {rows[0], rows[1]});
    journal.append(rows[2]);
    expectSame(readFinishedRows(folder / "out", 3), {rows[0], rows[1], rows[2]});
}

TEST(BenchmarkJournal, SurvivesALineThatWasCutOffAnywhere) {
    const test::TemporaryFolder folder;
    const std::vector<PairResult> rows = rowsOfCh();
    writeRunInfo(folder.path(), handMadeInfo());
    writeFinishedRows(folder.path(), {rows[0], rows[1]});
    const std::string whole = readTextFile(folder / "finished.jsonl");
    const std::size_t secondLine = whole.find('\n') + 1;
    for (std::size_t size = secondLine; size < whole.size(); size += 7) {
        std::ofstream(folder / "finished.jsonl", std::ios::trunc) << whole.substr(0, size);
        BenchmarkJournal journal(folder.path(), handMadeInfo());
        expectSame(journal.finished(), {rows[0]});
        journal.append(rows[3]);
        expectSame(readFinishedRows(folder.path(), 3), {rows[0], rows[3]});
    }
}

TEST(BenchmarkJournal, RefusesTheFolderOfOtherWork) {
    const test::TemporaryFolder folder;
    { BenchmarkJournal journal(folder.path(), handMadeInfo()); }
    const auto open = [&](const BenchmarkRunInfo& info) { BenchmarkJournal journal(folder.path(), info); };
    BenchmarkRunInfo other = handMadeInfo();
    other.fingerprint = "another";
    EXPECT_THROW(open(other), Error);
    other = handMadeInfo();
    other.pairs.pop_back();
    EXPECT_THROW(open(other), Error);
    other = handMadeInfo();
    other.shard = {0, 2};
    EXPECT_THROW(open(other), Error);
    other = handMadeInfo();
    other.methods = {"ch", "best"}; // more methods are more work, not other work
    EXPECT_NO_THROW(open(other));
}

TEST(BenchmarkJournal, NamesALineThatMakesNoSense) {
    const test::TemporaryFolder folder;
    writeFinishedRows(folder.path(), rowsOfCh());
    const std::string whole = readTextFile(folder / "finished.jsonl");
    for (const std::string bad : {"garbage\n", "{}\n", "[1,2]\n", "{\"sequence\":5}\n"}) {
        std::ofstream(folder / "finished.jsonl", std::ios::trunc) << bad << whole;
        try {
            readFinishedRows(folder.path(), 3);
            ADD_FAILURE() << bad;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("line 1"), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW(readFinishedRows(folder.path(), 4), Error);
}

} // namespace
} // namespace core
