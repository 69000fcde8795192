// SPDX-License-Identifier: MIT
#include "core/benchmark/findings.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "core/benchmark/sweep.h"
#include "core/fitting/method_name.h"

namespace core {
namespace {

/// What the paper would have measured: every claim holds.
double papersError(const std::string& method) {
    const Method m = parseMethod(method);
    const auto among = [](double value, const std::map<double, double>& table) { return table.at(value); };
    if (m.best)
        return 0.5;
    switch (m.distance) {
    case DistanceKind::DchThres:
        return (m.signedOrientation ? 0 : 0.4) + among(m.tauDeg, {{11.25, 2.6}, {22.5, 2.2}, {45, 2.7}, {90, 3.2}});
    case DistanceKind::DchDt3:
        return (m.signedOrientation ? 0 : 0.4) +
               among(m.lambdaPxPerRad, {{0, 4.4}, {5, 3.9}, {15, 3.65}, {25, 3.6}, {35, 3.62}, {50, 3.8}}) +
               (m.bins == 0 ? 0 : among(m.bins, {{4, 2}, {8, 0.5}, {16, 0}, {32, 0.01}}));
    case DistanceKind::DchQuant:
        return m.bins == 0 ? 5.1 : among(m.bins, {{4, 5.0}, {8, 5.1}, {16, 6.0}, {32, 8.0}});
    case DistanceKind::DchQuant2:
        return m.bins == 0 ? 4.2 : among(m.bins, {{4, 4.0}, {8, 4.2}, {16, 5.0}, {32, 6.0}});
    case DistanceKind::Ch:
        return 3.7;
    }
    return 0;
}

/// One pair per method of the sweep.
BenchmarkResults papersResults() {
    BenchmarkResults results;
    results.pairs = {{"01", 15, 20}};
    results.methods = sweepMethods();
    for (const std::string& method : results.methods) {
        const bool smooth = method.starts_with("dch-dt3");
        const bool fast = method.starts_with("dch-thres");
        results.rows.push_back(
            {results.pairs[0], method, 10, papersError(method), 20, smooth ? 1 : 3, fast ? 77.0 : 110.0, {}});
    }
    return results;
}

const Finding& about(const std::vector<Finding>& all, const std::string& words) {
    const auto found = std::find_if(
        all.begin(), all.end(), [&](const Finding& finding) { return finding.claim.find(words) != std::string::npos; });
    EXPECT_NE(found, all.end()) << words;
    return *found;
}

TEST(Findings, AllHoldForThePapersNumbers) {
    for (const Schedule schedule : {Schedule::Paper, Schedule::RigidFirst}) {
        for (const Finding& finding : findings(papersResults(), BenchmarkSetup::Synthetic, schedule)) {
            const bool needsRealData = finding.claim.find("real data") != std::string::npos;
            EXPECT_EQ(finding.verdict, needsRealData ? Verdict::NotMeasured : Verdict::Reproduced) << finding.claim;
        }
    }
}

TEST(Findings, EachTurnsWithItsOwnNumbers) {
    const std::map<std::string, std::vector<std::string>> spoilers = {
        {"(Thres)", {"dch-thres:signed=0"}},           {"(DT3)", {"dch-dt3:signed=0"}},
        {"tau = 22.5", {"dch-thres:tau=45"}},          {"lambda saturates", {"dch-dt3:lambda=0", "dch-dt3:lambda=5"}},
        {"more than 8 bins", {"dch-dt3:bins=8"}},      {"Quant2 beats Quant", {"dch-quant:bins=4"}},
        {"better for Quant2", {"dch-quant2:bins=32"}}, {"smallest error", {"ch"}}};
    for (const auto& [claim, methods] : spoilers) {
        BenchmarkResults results = papersResults();
        for (const std::string& method : methods) {
            const std::string name = withOptions(method, {});
            const auto row = std::find_if(results.rows.begin(), results.rows.end(),
                                          [&](const PairResult& r) { return r.method == name; });
            ASSERT_NE(row, results.rows.end()) << name;
            row->errorMm = 0.1; // far too good for the claim
        }
        EXPECT_EQ(about(findings(results, BenchmarkSetup::Synthetic, Schedule::RigidFirst), claim).verdict,
                  Verdict::NotReproduced)
            << claim;
        EXPECT_EQ(about(findings(results, BenchmarkSetup::Synthetic, Schedule::Paper), claim).verdict,
                  Verdict::Reproduced)
            << claim << ": the other schedule has its own numbers";
    }
}

TEST(Findings, EqualErrorsDoNotConfirmAClaim) {
    BenchmarkResults results = papersResults();
    for (PairResult& row : results.rows)
        row = {row.pair, row.method, 10, 2, 20, 1, 80, {}};
    for (const BenchmarkSetup setup : {BenchmarkSetup::Synthetic, BenchmarkSetup::Realistic})
        for (const Finding& finding : findings(results, setup, Schedule::RigidFirst))
            EXPECT_NE(finding.verdict, Verdict::Reproduced) << finding.claim;
}

TEST(Findings, SpeedAndSmoothnessAreComparedWithEveryOther) {
    BenchmarkResults results = papersResults();
    for (PairResult& row : results.rows) {
        if (row.method == withOptions("ch", {})) {
            row.seconds = 10;
            row.costRises = 0;
        }
    }
    const auto all = findings(results, BenchmarkSetup::Synthetic, Schedule::RigidFirst);
    EXPECT_EQ(about(all, "fastest").verdict, Verdict::NotReproduced);
    EXPECT_EQ(about(all, "smoothly").verdict, Verdict::NotReproduced);
}

TEST(Findings, SayWhatWasNotMeasured) {
    BenchmarkResults results = papersResults();
    std::erase_if(results.rows, [](const PairResult& row) { return row.method == "dch-thres:tau=45"; });
    const auto all = findings(results, BenchmarkSetup::Synthetic, Schedule::RigidFirst);
    EXPECT_EQ(about(all, "tau = 22.5").verdict, Verdict::NotMeasured);
    EXPECT_EQ(about(all, "tau = 22.5").numbers, "needs dch-thres:tau=45");
    EXPECT_NE(about(all, "lambda").numbers.find("dt3:lambda=35 3.62"), std::string::npos)
        << about(all, "lambda").numbers;
    for (const Finding& finding : findings({}, BenchmarkSetup::Synthetic, Schedule::Paper))
        EXPECT_EQ(finding.verdict, Verdict::NotMeasured);
}

TEST(Findings, RealDataDecideAboutCh) {
    BenchmarkResults results = papersResults();
    EXPECT_EQ(about(findings(results, BenchmarkSetup::Realistic, Schedule::Paper), "real").verdict,
              Verdict::NotReproduced);
    for (PairResult& row : results.rows)
        row.errorMm += row.method.starts_with("ch") ? 9 : 0;
    EXPECT_EQ(about(findings(results, BenchmarkSetup::Realistic, Schedule::Paper), "real").verdict,
              Verdict::Reproduced);
}

TEST(Sweep, NamesEveryMethodOnceAndCanonically) {
    const std::vector<std::string> methods = sweepMethods();
    for (std::size_t i = 0; i < methods.size(); ++i) {
        EXPECT_EQ(methodName(parseMethod(methods[i])), methods[i]);
        EXPECT_EQ(std::count(methods.begin(), methods.end(), methods[i]), 1);
    }
    EXPECT_NE(std::find(methods.begin(), methods.end(), "dch-thres:tau=45:signed=0:schedule=paper"), methods.end());
    EXPECT_LT(methods.size(), 110u);
}

} // namespace
} // namespace core
