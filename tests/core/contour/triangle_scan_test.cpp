// SPDX-License-Identifier: MIT
#include "core/contour/triangle_scan.h"

#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/random_values.h"

namespace {

using core::FixedPoint;
using core::ImageSize;
using core::kFixedPerPixel;

constexpr ImageSize kSize{40, 30};

FixedPoint atPixel(int x, int y) {
    return core::toFixed(Eigen::Vector2d(x, y));
}

/// How often each pixel of the image is visited.
class Counts {
public:
    void scan(FixedPoint a, FixedPoint b, FixedPoint c) {
        core::scanTriangle(
            a, b, c, kSize,
            [&](int x, int y) {
                ASSERT_TRUE(x >= 0 && y >= 0 && x < kSize.width && y < kSize.height);
                ++m_counts[{x, y}];
            });
    }
    int at(int x, int y) const {
        const auto found = m_counts.find({x, y});
        return found == m_counts.end() ? 0 : found->second;
    }

private:
    std::map<std::pair<int, int>, int> m_counts;
};

/// Twice the signed area of a, b and the centre of a pixel: exact in 64 bits.
std::int64_t sideOf(const FixedPoint& a, const FixedPoint& b, int x, int y) {
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
    return dx * (y * kFixedPerPixel - a.y) - dy * (x * kFixedPerPixel - a.x);
}

/// 1 if the centre of the pixel lies inside the triangle, 0 on its outline, -1 outside.
int inside(const FixedPoint& a, const FixedPoint& b, const FixedPoint& c, int x, int y) {
    const std::int64_t s0 = sideOf(a, b, x, y), s1 = sideOf(b, c, x, y), s2 = sideOf(c, a, x, y);
    if ((s0 > 0 && s1 > 0 && s2 > 0) || (s0 < 0 && s1 < 0 && s2 < 0))
        return 1;
    return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0) ? 0 : -1;
}

template <typename Visit>
void forEachPixel(Visit&& visit) {
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x)
            visit(x, y);
}

TEST(TriangleScan, VisitsExactlyThePixelsWhoseCentresLieInside) {
    test::RandomValues random("scan");
    int visited = 0, onOutline = 0;
    for (int trial = 0; trial < 400; ++trial) {
        // Every third triangle has its corners at pixel centres or halfway, so that centres fall on its edges.
        const double grid = trial % 3 ? 0 : 0.5;
        std::array<FixedPoint, 3> p;
        for (FixedPoint& corner : p) {
            Eigen::Vector2d px(random.between(-15, 55), random.between(-15, 45));
            corner = core::toFixed(grid > 0 ? Eigen::Vector2d(grid * (px / grid).array().round()) : px);
        }
        Counts counts;
        counts.scan(p[0], p[1], p[2]);
        forEachPixel([&](int x, int y) {
            const int place = inside(p[0], p[1], p[2], x, y), count = counts.at(x, y);
            visited += count;
            onOutline += place == 0;
            EXPECT_LE(count, 1);
            if (place != 0)
                EXPECT_EQ(count, place > 0 ? 1 : 0) << x << " " << y;
        });
    }
    EXPECT_GT(visited, 10000);
    EXPECT_GT(onOutline, 100);
}

TEST(TriangleScan, OrientationAndFirstCornerDoNotMatter) {
    test::RandomValues random("orientation");
    for (int trial = 0; trial < 50; ++trial) {
        std::array<FixedPoint, 3> p;
        for (FixedPoint& corner : p)
            corner = atPixel(random.below(30), random.below(25));
        Counts once, turned, mirrored;
        once.scan(p[0], p[1], p[2]);
        turned.scan(p[2], p[0], p[1]);
        mirrored.scan(p[1], p[0], p[2]);
        forEachPixel([&](int x, int y) {
            EXPECT_EQ(once.at(x, y), turned.at(x, y));
            EXPECT_EQ(once.at(x, y), mirrored.at(x, y));
        });
    }
}

TEST(TriangleScan, TrianglesThatShareEdgesCoverEveryPixelOnce) {
    test::RandomValues random("fan");
    for (int trial = 0; trial < 100; ++trial) {
        // A fan about a point that may be a pixel centre; the rim runs around the image.
        const Eigen::Vector2d middle = trial % 2 ? Eigen::Vector2d(random.between(5, 35), random.between(5, 25))
                                                 : Eigen::Vector2d(5 + random.below(30), 5 + random.below(20));
        std::vector<FixedPoint> rim;
        const int spokes = 3 + random.below(9);
        for (int i = 0; i < spokes; ++i) {
            const double angle = 2 * M_PI * i / spokes + (trial % 4 ? 0.1 * trial : 0);
            rim.push_back(core::toFixed(middle + 150 * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
        }
        Counts counts;
        for (int i = 0; i < spokes; ++i) {
            const FixedPoint &a = rim[static_cast<std::size_t>(i)],
                             &b = rim[static_cast<std::size_t>((i + 1) % spokes)];
            if (i % 2)
                counts.scan(core::toFixed(middle), a, b);
            else
                counts.scan(b, a, core::toFixed(middle)); // mixed orientations, as front and back faces
        }
        forEachPixel([&](int x, int y) { EXPECT_EQ(counts.at(x, y), 1) << x << " " << y << " trial " << trial; });
    }
}

TEST(TriangleScan, AGridOfSquaresOnPixelCentresCoversEveryPixelOnce) {
    Counts counts;
    constexpr int kStep = 5;
    for (int y = -kStep; y < kSize.height + kStep; y += kStep) {
        for (int x = -kStep; x < kSize.width + kStep; x += kStep) {
            const auto at = [&](int dx, int dy) { return atPixel(x + dx, y + dy); };
            counts.scan(at(0, 0), at(kStep, 0), at(0, kStep));
            counts.scan(at(kStep, 0), at(kStep, kStep), at(0, kStep));
        }
    }
    forEachPixel([&](int x, int y) { EXPECT_EQ(counts.at(x, y), 1) << x << " " << y; });
}

TEST(TriangleScan, ADegenerateTriangleCoversNothing) {
    Counts counts;
    counts.scan(atPixel(0, 0), atPixel(20, 20), atPixel(10, 10));
    counts.scan(atPixel(1, 1), atPixel(1, 1), atPixel(5, 1));
    forEachPixel([&](int x, int y) { EXPECT_EQ(counts.at(x, y), 0); });
}

TEST(TriangleScan, HugeTrianglesAreStillExact) {
    Counts counts;
    constexpr std::int32_t far = kFixedPerPixel * ((1 << 17) - 1);
    const FixedPoint a{-far, -far}, b{far, -far + 3}, c{-far + 5, far};
    counts.scan(a, b, c);
    forEachPixel([&](int x, int y) { EXPECT_EQ(counts.at(x, y), inside(a, b, c, x, y) > 0 ? 1 : 0) << x << " " << y; });
}

TEST(TriangleScan, FixedPointsRoundToTheNearest) {
    EXPECT_EQ(core::toFixed({1.0, -2.5}).x, 4096);
    EXPECT_EQ(core::toFixed({1.0, -2.5}).y, -10240);
    EXPECT_EQ(core::toFixed({0.6 / 4096, -0.6 / 4096}).x, 1);
    EXPECT_EQ(core::toFixed({0.6 / 4096, -0.6 / 4096}).y, -1);
}

} // namespace
