// SPDX-License-Identifier: MIT
#include "core/benchmark/report.h"

#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/core/benchmark/hand_made_results.h"

namespace core {
namespace {

std::string report(const BenchmarkResults& results, bool sweep, bool drawn) {
    ReportContent content{"/data/my hands", BenchmarkSetup::Synthetic, sweep, &results, reportFigures(results, sweep), {}};
    if (drawn) {
        content.pictures.emplace();
        for (std::size_t i = 0; i < content.figures.size(); ++i) {
            content.pictures->push_back("<svg>" + std::to_string(i) + "</svg>");
        }
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
        if (tag[0] == '!' || tag == "meta" || tag == "br") {
            continue;
        }
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
    const std::string row = "<td>25</td><td>30</td><td>40.00</td><td>7.00</td><td class=\"text\"><code>handlens '/data/my hands' "
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
    for (const auto& [method, errorMm, seconds] : {std::tuple{"best", 0.25, 0.5}, std::tuple{"best:palm=0", 1.5, 0.25}, std::tuple{"best:both=1", 0.5, 1.0}}) {
        results.methods.emplace_back(method);
        results.rows.push_back({results.pairs[0], method, 10, errorMm, 10, 1, seconds, {errorMm, errorMm, errorMm}});
    }
    sortRows(results);
    const std::string html = report(results, true, true);
    EXPECT_TRUE(contains(html, "<td class=\"text\">best:palm=0</td><td>1.500</td><td>1.50</td><td>1.250</td><td>250</td>")) << html;
    EXPECT_TRUE(contains(html, "<td class=\"text\">best:both=1</td><td>0.500</td><td>0.50</td><td>-0.250</td><td>500</td>")) << html;
}

TEST(Figures, HoldTheirData) {
    const BenchmarkResults results = test::handMadeResults();
    EXPECT_EQ(headlineMethods(results), (std::vector<std::string>{"their, tracker", "ch"}));
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

} // namespace
} // namespace core
