// SPDX-License-Identifier: MIT
#include "widgets/views/camera/grid_packing.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace {

using namespace widgets;

constexpr double kPortrait = 1080.0 / 1920;
constexpr double kLandscape = 1920.0 / 1080;

TEST(GridPacking, PortraitFootageFillsAWideWindow) {
    EXPECT_EQ(packGrid(8, kPortrait, {1330, 980}, 18), (GridShape{2, 4}));
    EXPECT_EQ(packGrid(8, kPortrait, {1900, 500}, 18), (GridShape{1, 8}));
    EXPECT_EQ(packGrid(2, 1, {1330, 700}, 18), (GridShape{1, 2}));
}

TEST(GridPacking, LandscapeFootageStacks) {
    EXPECT_EQ(packGrid(8, kLandscape, {1330, 980}, 18), (GridShape{3, 3}));
    EXPECT_EQ(packGrid(2, kLandscape, {900, 1000}, 18), (GridShape{2, 1}));
}

TEST(GridPacking, OneViewFillsEverything) {
    EXPECT_EQ(packGrid(1, kPortrait, {640, 480}, 18), (GridShape{1, 1}));
}

/// No other grid shows the pictures larger.
TEST(GridPacking, WastesLeast) {
    for (int count = 1; count <= 16; ++count) {
        for (const double aspect : {kPortrait, 1.0, kLandscape}) {
            for (const QSize area : {QSize(1330, 980), QSize(700, 1000), QSize(1900, 500)}) {
                const auto pictureWidth = [&](GridShape s) {
                    const double width = static_cast<double>(area.width()) / s.columns;
                    const double height = static_cast<double>(area.height()) / s.rows - 18;
                    return std::max(0.0, std::min(width, height * aspect));
                };
                const GridShape best = packGrid(count, aspect, area, 18);
                ASSERT_GE(best.rows * best.columns, count);
                EXPECT_LT(best.rows * best.columns - count, best.columns) << "a row stays empty";
                for (int rows = 1; rows <= count; ++rows) {
                    EXPECT_GE(pictureWidth(best) * (1 + 1e-6), pictureWidth({rows, (count + rows - 1) / rows}))
                        << count;
                }
            }
        }
    }
}

TEST(GridPacking, SurvivesWindowsWithoutRoom) {
    const GridShape shape = packGrid(8, kPortrait, {0, 0}, 18);
    EXPECT_GE(shape.rows * shape.columns, 8);
}

} // namespace
