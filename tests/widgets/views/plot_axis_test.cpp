// SPDX-License-Identifier: MIT
#include "widgets/views/plot_axis.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using namespace widgets;

TEST(PlotAxis, PositionsAndValuesAreInverse) {
    for (const PlotAxis& axis : {PlotAxis{-3, 12, false}, PlotAxis{0.01, 100, true}}) {
        for (double p = 0; p <= 1; p += 0.1)
            EXPECT_NEAR(axis.position(axis.value(p)), p, 1e-12);
        EXPECT_DOUBLE_EQ(axis.position(axis.min), 0);
        EXPECT_DOUBLE_EQ(axis.position(axis.max), 1);
    }
    EXPECT_NEAR((PlotAxis{0.01, 100, true}).position(1), 0.5, 1e-12);
    EXPECT_EQ((PlotAxis{0.01, 100, true}).position(-1), 0);
}

TEST(PlotAxis, RangesBecomeRound) {
    const PlotAxis axis = roundAxis(0.3, 9.4, false);
    EXPECT_DOUBLE_EQ(axis.min, 0);
    EXPECT_DOUBLE_EQ(axis.max, 10);
    const PlotAxis high = roundAxis(103, 108.5, false);
    EXPECT_GT(high.min, 99);
    EXPECT_LE(high.min, 103);
    EXPECT_GE(high.max, 108.5);
    const PlotAxis logarithmic = roundAxis(0.034, 7, true);
    EXPECT_NEAR(logarithmic.min, 0.01, 1e-12);
    EXPECT_NEAR(logarithmic.max, 10, 1e-12);
}

TEST(PlotAxis, OddRangesStillGiveAnAxis) {
    for (const auto& [min, max] : {std::pair(5.0, 5.0), std::pair(HUGE_VAL, -HUGE_VAL), std::pair(0.0, 0.0)}) {
        const PlotAxis axis = roundAxis(min, max, false);
        EXPECT_LT(axis.min, axis.max);
    }
    EXPECT_LT(roundAxis(-1, 3, true).min, roundAxis(-1, 3, true).max);
    EXPECT_GT(roundAxis(-1, 3, true).min, 0);
}

TEST(PlotAxis, TicksAreRoundAndFew) {
    EXPECT_EQ(ticks({0, 10, false}, 6), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    for (int most = 2; most < 12; ++most) {
        const std::vector<double> found = ticks({-1.7, 23.2, false}, most);
        EXPECT_LE(static_cast<int>(found.size()), most);
        for (const double v : found) {
            EXPECT_GE(v, -1.7 - 1e-9);
            EXPECT_LE(v, 23.2 + 1e-9);
        }
    }
    const std::vector<double> powers = ticks({0.01, 100, true}, 6);
    ASSERT_EQ(powers.size(), 5u);
    EXPECT_NEAR(powers[2], 1, 1e-12);
}

TEST(PlotAxis, ANarrowAxisHasTwoNumbers) {
    PlotAxis iterations{0, 25, false};
    iterations.whole = true;
    EXPECT_EQ(ticks(iterations, 2), (std::vector<double>{0, 20}));
    for (const double max : {3.0, 11.0, 29.0, 44.0, 100.0, 260.0})
        EXPECT_EQ(ticks({0, max, false}, 2).size(), max == 44 ? 3u : 2u) << max; // 0, 20, 40
}

TEST(PlotAxis, WholeNumbersHaveNoTicksBetweenThem) {
    EXPECT_EQ(ticks(PlotAxis{0, 3, false, true}, 12), (std::vector<double>{0, 1, 2, 3}));
    EXPECT_EQ(ticks(PlotAxis{0, 3, false, false}, 12).size(), 7u) << "halves";
    EXPECT_EQ(ticks(PlotAxis{0, 40, false, true}, 6), (std::vector<double>{0, 10, 20, 30, 40}));
}

} // namespace
