// SPDX-License-Identifier: MIT
#include "core/benchmark/result_table.h"

#include <gtest/gtest.h>

#include "core/benchmark/result_csv.h"
#include "tests/core/benchmark/hand_made_results.h"

namespace core {
namespace {

using test::handMadeResults;

BenchmarkResults papersHands() {
    BenchmarkResults results = handMadeResults();
    results.papersHands = true;
    return results;
}

TEST(ResultTable, HasThePapersLayout) {
    const std::string expected = "| method | 1 | 5 | All | s/pair |\n"
                                 "|---|---:|---:|---:|---:|\n"
                                 "| initial | 20.00 ± 10.00 | 30.00 ± 10.00 | 25.00 ± 11.18 |  |\n"
                                 "| ch | 2.00 ± 1.00 | 6.00 ± 1.00 | 4.00 ± 2.24 | 0.500 |\n"
                                 "| CH (paper) | 1.0 ± 1.0 | 2.5 ± 2.5 |  | 103 |\n"
                                 "| their, tracker | 2.00 ± 0.00 |  | 2.00 ± 0.00 |  |\n";
    EXPECT_EQ(markdownTable(resultTable(papersHands(), BenchmarkSetup::Synthetic)), expected);
}

TEST(ResultTable, ThePapersRowsStandOnlyBesideThePapersHands) {
    for (const BenchmarkSetup setup : {BenchmarkSetup::Synthetic, BenchmarkSetup::Realistic}) {
        const ResultTable table = resultTable(handMadeResults(), setup);
        EXPECT_EQ(table.rows.size(), 3u);
        EXPECT_EQ(markdownTable(table).find("paper"), std::string::npos);
    }
}

TEST(ResultTable, APapersRowStandsBelowItsOwnMethodAlone) {
    BenchmarkResults results = papersHands();
    for (PairResult& row : results.rows)
        row.method = row.method == "ch" ? "dch-thres:schedule=paper" : "dch-thres:tau=45";
    results.methods = {"dch-thres:tau=45", "dch-thres:schedule=paper"};
    results.external.clear();
    const ResultTable table = resultTable(results, BenchmarkSetup::Synthetic);
    std::vector<std::string> names;
    for (const ResultTable::Row& row : table.rows)
        names.push_back(row.name);
    EXPECT_EQ(names, (std::vector<std::string>{"initial", "dch-thres:tau=45", "dch-thres:schedule=paper",
                                               "DCH-Thres (paper)"}));
}

TEST(ResultTable, ThePapersMeanOfAllStandsOnlyBesideItsOwnDifferences) {
    BenchmarkResults results = papersHands();
    const PairResult first = results.rows.front();
    for (const int difference : {10, 15}) {
        PairResult row = first;
        row.pair = {"01", 40 - difference, 40};
        results.pairs.push_back(row.pair);
        results.rows.push_back(row);
    }
    const std::string text = markdownTable(resultTable(results, BenchmarkSetup::Synthetic));
    EXPECT_NE(text.find("| CH (paper) | 1.0 ± 1.0 | 2.5 ± 2.5 | 4.3 ± 4.6 | 6.4 ± 6.1 | 3.5 ± 4.5 | 103 |"),
              std::string::npos)
        << text;
}

TEST(ResultTable, HasTheOtherNumbersForTheRealisticSetup) {
    const std::string text = markdownTable(resultTable(papersHands(), BenchmarkSetup::Realistic));
    EXPECT_NE(text.find("| initial (paper) | 6.4 ± 2.0 | 10.5 ± 5.6 |  |  |"), std::string::npos) << text;
    EXPECT_EQ(text.find("Ballan"), std::string::npos) << "no method here is that tracker";
}

TEST(ResultTable, EscapesWhatLatexAndHtmlWouldRead) {
    BenchmarkResults results = handMadeResults();
    for (PairResult& row : results.rows)
        row.method = row.method == "ch" ? "a_b&c<d>" : row.method;
    results.methods[0] = "a_b&c<d>";
    const ResultTable table = resultTable(results, BenchmarkSetup::Synthetic);
    EXPECT_NE(latexTable(table).find("a\\_b\\&c<d> & $2.00 \\pm 1.00$ & $6.00 \\pm 1.00$"), std::string::npos);
    EXPECT_NE(latexTable(table).find("\\begin{tabular}{lrrrr}"), std::string::npos);
    EXPECT_NE(htmlTable(table).find("<th>a_b&amp;c&lt;d&gt;</th><td>2.00 ± 1.00</td>"), std::string::npos);
}

TEST(ResultCsv, HoldsEveryRow) {
    const std::string expected = "sequence,start,test,difference,method,initial_error_mm,error_mm,iterations,seconds\n"
                                 "01,19,20,1,ch,10,1,10,0.5\n"
                                 "01,19,20,1,\"their, tracker\",10,2,0,0\n"
                                 "01,29,30,1,ch,30,3,10,0.25\n"
                                 "01,15,20,5,ch,20,5,10,0.75\n"
                                 "01,25,30,5,ch,40,7,10,0.5\n";
    EXPECT_EQ(resultsCsv(handMadeResults()), expected);
}

TEST(ResultCsv, LeavesMissingJointsOut) {
    const std::string text = jointsCsv(handMadeResults());
    EXPECT_NE(text.find("01,19,20,1,ch,left,index_mcp,1\n"), std::string::npos);
    EXPECT_EQ(text.find("01,29,30,1,ch,left,index_mcp"), std::string::npos);
    EXPECT_NE(text.find("\"their, tracker\",right,forearm,2\n"), std::string::npos);
}

TEST(ResultCsv, CurvesEndAtTheirShare) {
    const std::string text = curvesCsv(handMadeResults());
    EXPECT_NE(text.find("ch,1.0,0.000000\nch,1.1,0.250000\n"), std::string::npos);
    EXPECT_NE(text.find("ch,20.0,1.000000\n"), std::string::npos);
}

} // namespace
} // namespace core
