// SPDX-License-Identifier: MIT
#include "core/benchmark/setups_report.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/core/benchmark/hand_made_results.h"

namespace core {
namespace {

const ResultTable::Row* rowOf(const ResultTable& table, const std::string& name) {
    const auto found = std::find_if(table.rows.begin(), table.rows.end(),
                                    [&](const ResultTable::Row& row) { return row.name == name; });
    return found == table.rows.end() ? nullptr : &*found;
}

TEST(SetupsTable, HasAColumnPerSetupAndARowPerName) {
    const BenchmarkResults synthetic = test::handMadeResults();
    BenchmarkResults realistic = test::handMadeResults();
    for (PairResult& row : realistic.rows)
        row.errorMm += 10;
    const ResultTable table =
        setupsTable({{BenchmarkSetup::Synthetic, &synthetic}, {BenchmarkSetup::Realistic, &realistic}});
    EXPECT_EQ(table.columns,
              (std::vector<std::string>{"synthetic 1", "synthetic 5", "synthetic All", "synthetic s/pair",
                                        "realistic 1", "realistic 5", "realistic All", "realistic s/pair"}));
    ASSERT_EQ(table.rows.size(), 3u);
    const ResultTable::Row* ch = rowOf(table, "ch");
    ASSERT_NE(ch, nullptr);
    EXPECT_EQ(ch->cells[2].mean, "4.00");
    EXPECT_EQ(ch->cells[6].mean, "14.00");
}

TEST(SetupsTable, HasThePapersRowsOnlyForThePapersHands) {
    BenchmarkResults results = test::handMadeResults();
    const std::vector<SetupResults> setups{{BenchmarkSetup::Synthetic, &results},
                                           {BenchmarkSetup::Realistic, &results}};
    EXPECT_EQ(rowOf(setupsTable(setups), "CH (paper)"), nullptr);
    EXPECT_EQ(rowOf(setupsTable(setups), "full tracker (Ballan et al.) (paper)"), nullptr);
    results.papersHands = true;
    const ResultTable table = setupsTable(setups);
    const ResultTable::Row* paper = rowOf(table, "CH (paper)");
    ASSERT_NE(paper, nullptr);
    EXPECT_EQ((paper - 1)->name, "ch") << "below its own method";
    EXPECT_EQ(paper->cells[0].mean, "1.0");
    EXPECT_EQ(paper->cells[4].mean, "7.1");
    EXPECT_EQ(rowOf(table, "DCH-Thres (paper)"), nullptr) << "that method was not run";
    const ResultTable::Row* initial = rowOf(table, "initial (paper)");
    ASSERT_NE(initial, nullptr);
    EXPECT_EQ((initial - 1)->name, "initial");
    EXPECT_TRUE(initial->cells[0].mean.empty()) << "published for the realistic setup only";
    EXPECT_EQ(table.rows.back().name, "full tracker (Ballan et al.) (paper)");
    EXPECT_EQ(table.rows.back().cells[4].mean, "5.9");
}

TEST(SetupsReport, HoldsBothSetupsAndSaysWhetherTheirOrdersAgree) {
    BenchmarkResults first = test::handMadeResults();
    first.external.clear();
    first.methods = {"ch", "best"};
    std::erase_if(first.rows, [](const PairResult& row) { return row.method != "ch"; });
    for (const PairResult& row : std::vector<PairResult>(first.rows)) {
        first.rows.push_back(row);
        first.rows.back().method = "best";
        first.rows.back().errorMm -= 0.5;
    }
    const std::vector<SetupResults> setups{{BenchmarkSetup::Synthetic, &first}, {BenchmarkSetup::Realistic, &first}};
    ASSERT_LT(first.pairs.size(), kLeastRankedPairs);
    EXPECT_NE(setupsAgreement(setups).find("cannot be told from"), std::string::npos) << setupsAgreement(setups);
    EXPECT_FALSE(setupsRankAgreement(setups));
    const auto pairs = first.pairs;
    const auto rows = first.rows;
    for (std::size_t copy = 0; copy < kLeastRankedPairs; ++copy) { // the same of more sequences
        for (FramePair pair : pairs) {
            pair.sequence += std::to_string(copy);
            first.pairs.push_back(pair);
        }
        for (PairResult row : rows) {
            row.pair.sequence += std::to_string(copy);
            first.rows.push_back(row);
        }
    }
    const std::string sentence = setupsAgreement(setups);
    EXPECT_NE(sentence.find("tau is 1.00"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("realistic: best < ch."), std::string::npos) << sentence;
    const std::string html = setupsReportHtml({{"d", BenchmarkSetup::Synthetic, false, &first, {}, {}},
                                               {"d", BenchmarkSetup::Realistic, false, &first, {}, {}}});
    EXPECT_NE(html.find("<h1>Synthetic setup</h1>"), std::string::npos);
    EXPECT_NE(html.find("<h1>Realistic setup</h1>"), std::string::npos);
}

} // namespace
} // namespace core
