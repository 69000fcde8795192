// SPDX-License-Identifier: MIT
#include "core/benchmark/report.h"

#include <algorithm>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/core/benchmark/hand_made_results.h"

namespace core {
namespace {

std::string report(const BenchmarkResults& results, bool sweep, bool drawn) {
    ReportContent content{"/data/my hands", BenchmarkSetup::Synthetic,     sweep,
                          &results,         reportFigures(results, sweep), {}};
    if (drawn) {
        content.pictures.emplace();
        for (std::size_t i = 0; i < content.figures.size(); ++i)
            content.pictures->push_back("<svg>" + std::to_string(i) + "</svg>");
    }
    return reportHtml(content);
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Every tag that opens closes again, in order.
void expectWellFormed(const std::string& html) {
    std::vector<std::string> open;
    for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
        const std::size_t end = html.find_first_of(" >", at);
        const std::string tag = html.substr(at + 1, end - at - 1);
        if (tag[0] == '!' || tag == "meta" || tag == "br")
            continue;
        if (tag[0] != '/') {
            open.push_back(tag);
            continue;
        }
        ASSERT_FALSE(open.empty()) << tag;
        ASSERT_EQ("/" + open.back(), tag) << html.substr(at, 80);
        open.pop_back();
    }
    EXPECT_TRUE(open.empty());
}

TEST(Report, IsOneWellFormedPageWithoutANetwork) {
    for (const bool sweep : {false, true}) {
        const std::string html = report(test::handMadeResults(), sweep, true);
        expectWellFormed(html);
        EXPECT_FALSE(contains(html, "http"));
        EXPECT_FALSE(contains(html, "<script"));
        EXPECT_FALSE(contains(html, "src="));
        EXPECT_EQ(contains(html, "Findings of the paper"), sweep);
        EXPECT_EQ(contains(html, "Options that the paper leaves open"), sweep);
        EXPECT_EQ(contains(html, "What best is made of"), sweep);
    }
}

TEST(Report, ListsTheWorstPairsWithTheCommandThatOpensThem) {
    const std::string html = report(test::handMadeResults(), false, true);
    const std::string row =
        "<td>25</td><td>30</td><td>40.00</td><td>7.00</td><td class=\"text\"><code>handlens '/data/my hands' "
        "--sequence 01 --frame 30</code></td>";
    EXPECT_TRUE(contains(html, row)) << html;
    EXPECT_EQ(openCommand("d", {"it's", 3, 8}), "handlens d --sequence 'it'\\''s' --frame 8");
}

TEST(Report, SaysPlainlyThatItHasNoFigures) {
    const std::string html = report(test::handMadeResults(), false, false);
    EXPECT_TRUE(contains(html, "gnuplot is not installed"));
    EXPECT_FALSE(contains(html, "<svg"));
    expectWellFormed(html);
}

TEST(Report, SplitsTheTableBySchedule) {
    BenchmarkResults results = test::handMadeResults();
    results.methods.insert(results.methods.begin() + 1, "ch:schedule=paper");
    results.rows.push_back(results.rows[0]);
    results.rows.back().method = "ch:schedule=paper";
    sortRows(results);
    const std::string html = report(results, false, true);
    EXPECT_TRUE(contains(html, "<h2>Rigid phase first (default)</h2>"));
    EXPECT_TRUE(contains(html, "<h2>The paper's schedule</h2>"));
    BenchmarkResults stopped = test::handMadeResults();
    stopped.stopped = true;
    EXPECT_TRUE(contains(report(stopped, false, true), "stopped before its end"));
}

TEST(Report, SaysWhatEachIdeaOfBestGainsAndCosts) {
    BenchmarkResults results = test::handMadeResults();
    for (const auto& [method, errorMm, seconds] :
         {std::tuple{"best", 0.25, 0.5}, std::tuple{"best:palm=0", 1.5, 0.25}, std::tuple{"best:both=1", 0.5, 1.0}}) {
        results.methods.emplace_back(method);
        results.rows.push_back({results.pairs[0], method, 10, errorMm, 10, 1, seconds, {errorMm, errorMm, errorMm}});
    }
    sortRows(results);
    const std::string html = report(results, true, true);
    EXPECT_TRUE(
        contains(html, "<td class=\"text\">best:palm=0</td><td>1.500</td><td>1.50</td><td>1.250</td><td>250</td>"))
        << html;
    EXPECT_TRUE(
        contains(html, "<td class=\"text\">best:both=1</td><td>0.500</td><td>0.50</td><td>-0.250</td><td>500</td>"))
        << html;
}

TEST(Figures, HoldTheirData) {
    const BenchmarkResults results = test::handMadeResults();
    EXPECT_EQ(headlineMethods(results), (std::vector<std::string>{"ch", "their, tracker"}));
    const std::vector<Figure> figures = overviewFigures(results, {"ch"});
    const auto named = [&](const std::string& id) {
        return *std::find_if(figures.begin(), figures.end(), [&](const Figure& figure) { return figure.id == id; });
    };
    EXPECT_TRUE(contains(named("differences").gnuplot, "1 2.00000\n5 6.00000\n"));
    EXPECT_TRUE(contains(named("curves").gnuplot, "\n3 25.00000\n"));
    EXPECT_TRUE(contains(named("joints").gnuplot, "0 4.00000\n1 1.00000\nEOD"));
    EXPECT_TRUE(contains(named("speed").gnuplot, "0.5 4.00000\n"));
    EXPECT_TRUE(sweepResultFigures(results).empty()) << "a single method gives no sweep";
}

/// The colours and names of a figure's lines, in the order of its key.
std::vector<std::pair<std::string, std::string>> keyOf(const Figure& figure) {
    std::vector<std::pair<std::string, std::string>> key;
    for (std::size_t at = figure.gnuplot.find(" lc rgb '", figure.gnuplot.find("plot $")); at != std::string::npos;
         at = figure.gnuplot.find(" lc rgb '", at + 1)) {
        const std::size_t title = figure.gnuplot.find("title '", at) + 7;
        key.emplace_back(figure.gnuplot.substr(title, figure.gnuplot.find('\'', title) - title),
                         figure.gnuplot.substr(at + 9, 7));
    }
    return key;
}

TEST(Figures, AMethodHasOneColourAndOnePlaceInAllOfThem) {
    BenchmarkResults results = test::handMadeResults();
    std::vector<PairResult> rows;
    results.methods = {"ch", "dch-thres:tau=45", "dch-thres:tau=30", "their, tracker"};
    for (const std::string& method : results.methods) {
        for (const PairResult& row : results.rows) {
            if (row.method == "ch") {
                rows.push_back(row);
                rows.back().method = method;
            }
        }
    }
    results.rows = rows;
    const std::vector<Figure> figures = overviewFigures(results, results.methods);
    ASSERT_EQ(figures.size(), 4u);
    std::vector<std::pair<std::string, std::string>> curves = keyOf(figures[0]);
    ASSERT_EQ(curves.size(), 5u);
    EXPECT_EQ(curves.front().first, "initial");
    curves.erase(curves.begin());
    for (const Figure& figure : figures)
        if (figure.id != "curves")
            EXPECT_EQ(keyOf(figure), curves) << figure.id;
    std::set<std::string> colours;
    for (const auto& [name, colour] : curves)
        colours.insert(colour);
    EXPECT_EQ(colours.size(), 4u) << "and no two methods share one";
}

TEST(Figures, CountsHaveWholeMarksAndJointsAreNotJoined) {
    const std::vector<Figure> figures = overviewFigures(test::handMadeResults(), {"ch"});
    EXPECT_TRUE(contains(figures[1].gnuplot, "set xtics (1, 5)\n"));
    EXPECT_EQ(gnuplotWholeTics("x", 0, 230), "set xtics 50\n");
    EXPECT_EQ(gnuplotWholeTics("x", 1, 15), "set xtics 2\n");
    EXPECT_FALSE(contains(figures[2].gnuplot, "with lines")) << figures[2].gnuplot;
    EXPECT_TRUE(contains(figures[2].gnuplot, "'L index mcp' 1")) << "words, not an identifier";
}

} // namespace
} // namespace core
