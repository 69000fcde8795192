// SPDX-License-Identifier: MIT
#include "core/contour/visible_rim.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/random_values.h"

namespace {

TEST(CoverageMask, HoldsTheCellsWhoseCentresLieInATriangle) {
    test::RandomValues random("coverage");
    int covered = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Eigen::Vector2f origin(static_cast<float>(random.between(-20, 20)),
                                     static_cast<float>(random.between(-20, 20)));
        const float cell = trial % 2 ? 2.0f : 3.7f;
        core::CoverageMask coverage;
        coverage.reset(origin, origin + Eigen::Vector2f(60, 40), cell);
        std::array<Eigen::Vector2f, 3> p;
        for (Eigen::Vector2f& corner : p)
            corner = origin + random.vector(2, 50).cast<float>() + Eigen::Vector2f(30, 20);
        coverage.add(p[0], p[1], p[2]);
        for (int y = 0; y < coverage.height(); ++y) {
            for (int x = 0; x < coverage.width(); ++x) {
                const Eigen::Vector2f centre =
                    origin + cell * Eigen::Vector2f(static_cast<float>(x), static_cast<float>(y));
                const auto side = [&](const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
                    return (b.x() - a.x()) * (centre.y() - a.y()) - (b.y() - a.y()) * (centre.x() - a.x());
                };
                const float s0 = side(p[0], p[1]), s1 = side(p[1], p[2]), s2 = side(p[2], p[0]);
                const float margin = std::max(std::min({s0, s1, s2}), std::min({-s0, -s1, -s2}));
                if (std::abs(margin) > 0.05f) { // px^2: not on an edge
                    EXPECT_EQ(coverage.covers(centre), margin > 0) << trial;
                    EXPECT_EQ(coverage.covers(centre + Eigen::Vector2f(0.4f, -0.4f) * cell), margin > 0)
                        << "the same cell";
                    covered += margin > 0;
                }
            }
        }
        EXPECT_FALSE(coverage.covers(origin - Eigen::Vector2f(2 * cell, 0)));
        EXPECT_FALSE(coverage.covers(origin + Eigen::Vector2f(60 + 2 * cell, 0)));
    }
    EXPECT_GT(covered, 2000);
}

} // namespace
