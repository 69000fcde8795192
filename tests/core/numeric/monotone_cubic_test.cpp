// SPDX-License-Identifier: MIT
#include "core/numeric/monotone_cubic.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace {

using core::MonotoneCubic;

TEST(MonotoneCubic, PassesThroughItsSamplesAndIsConstantBeyondThem) {
    const MonotoneCubic curve({0, 1, 4, 5}, {2, -1, 3, 3});
    EXPECT_DOUBLE_EQ(curve(0), 2);
    EXPECT_DOUBLE_EQ(curve(1), -1);
    EXPECT_DOUBLE_EQ(curve(4), 3);
    EXPECT_DOUBLE_EQ(curve(-10), 2);
    EXPECT_DOUBLE_EQ(curve(10), 3);
}

TEST(MonotoneCubic, NeverLeavesTheRangeOfItsNeighbours) {
    const std::vector<double> x{0, 1, 1.5, 4, 4.2, 9}, y{0, 10, 10, -3, -2.9, 7};
    const MonotoneCubic curve(x, y);
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        const auto [low, high] = std::minmax(y[i], y[i + 1]);
        for (int k = 0; k <= 100; ++k) {
            const double value = curve(x[i] + (x[i + 1] - x[i]) * k / 100.0);
            EXPECT_GE(value, low - 1e-12);
            EXPECT_LE(value, high + 1e-12);
        }
    }
}

TEST(MonotoneCubic, HasNoKinks) {
    const MonotoneCubic curve({0, 1, 3, 4}, {0, 2, 3, 8});
    constexpr double h = 1e-6;
    for (const double knot : {1.0, 3.0}) {
        const double before = (curve(knot) - curve(knot - h)) / h;
        const double after = (curve(knot + h) - curve(knot)) / h;
        EXPECT_NEAR(before, after, 1e-4);
        EXPECT_GT(after, 0.1);
    }
}

TEST(MonotoneCubic, KeepsAStraightLineStraightInside) {
    const MonotoneCubic curve({0, 1, 2, 3}, {0, 2, 4, 6});
    EXPECT_NEAR(curve(1.5), 3, 1e-12);
    EXPECT_NEAR(curve(1.2), 2.4, 1e-12);
}

TEST(MonotoneCubic, OneSampleIsAConstant) {
    EXPECT_DOUBLE_EQ(MonotoneCubic({3}, {7})(5), 7);
}

} // namespace
