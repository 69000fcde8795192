// SPDX-License-Identifier: MIT
#include "core/io/files/gnuplot.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "core/benchmark/figures.h"
#include "core/benchmark/report.h"
#include "core/benchmark/sweep.h"
#include "core/error.h"
#include "tests/core/benchmark/hand_made_results.h"

namespace core {
namespace {

bool isInstalled() {
    return std::system("command -v gnuplot >/dev/null") == 0;
}

TEST(Gnuplot, DrawsEveryFigure) {
    if (!isInstalled())
        GTEST_SKIP() << "gnuplot is not installed";
    std::vector<std::string> programs;
    for (const Figure& figure : overviewFigures(test::handMadeResults(), {"ch", "their, tracker"}))
        programs.push_back(figure.gnuplot);
    const auto pictures = drawWithGnuplot(programs);
    ASSERT_TRUE(pictures);
    ASSERT_EQ(pictures->size(), programs.size());
    for (const std::string& picture : *pictures) {
        EXPECT_TRUE(picture.starts_with("<svg"));
        EXPECT_TRUE(picture.ends_with("</svg>"));
        EXPECT_NE(picture.find("rgb(230, 159,   0)"), std::string::npos) << "a line in the colour of ch";
    }
}

TEST(Gnuplot, DrawsEveryFigureOfASweep) {
    if (!isInstalled())
        GTEST_SKIP() << "gnuplot is not installed";
    BenchmarkResults results;
    results.pairs = {{"01", 15, 20}, {"01", 19, 20}};
    results.joints = {{Side::Left, "forearm"}};
    results.methods = sweepMethods();
    for (const FramePair& pair : results.pairs) {
        for (const std::string& method : results.methods) {
            const double errorMm = 1 + static_cast<double>(method.size()) / 10;
            results.rows.push_back({pair, method, 10, errorMm, 20, 1, 0.1, {errorMm}});
        }
    }
    std::vector<std::string> programs;
    for (const Figure& figure : reportFigures(results, true))
        programs.push_back(figure.gnuplot);
    EXPECT_EQ(programs.size(), 4u + 2 * 5u); // overview; per schedule the paper's four sweeps and the best of each
    const auto pictures = drawWithGnuplot(programs);
    ASSERT_TRUE(pictures);
    EXPECT_EQ(pictures->size(), programs.size());
}

TEST(Gnuplot, SaysWhatItDidNotUnderstand) {
    if (!isInstalled())
        GTEST_SKIP() << "gnuplot is not installed";
    EXPECT_THROW(drawWithGnuplot({"set terminal svg\nplot nonsense(\n"}), Error);
    EXPECT_TRUE(drawWithGnuplot({})->empty());
}

TEST(Gnuplot, MayBeMissing) {
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", "/nowhere", 1);
    EXPECT_FALSE(drawWithGnuplot({"set terminal svg\nplot x\n"}));
    ::setenv("PATH", path.c_str(), 1);
}

} // namespace
} // namespace core
