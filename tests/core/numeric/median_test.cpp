// SPDX-License-Identifier: MIT
#include "core/numeric/median.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/random_values.h"

namespace {

TEST(Median, IsTheMiddleValueOrTheMeanOfTheTwoMiddleOnes) {
    EXPECT_EQ(core::medianOf({7}), 7);
    EXPECT_EQ(core::medianOf({9, 1}), 5);
    EXPECT_EQ(core::medianOf({3, -2, 100}), 3);
    EXPECT_EQ(core::medianOf({4, 1, 3, 2}), 2.5);
    EXPECT_EQ(core::medianOf({5, 5, 5, 0}), 5);
}

TEST(Median, AgreesWithSortingForAnyOrder) {
    test::RandomValues random("median");
    for (int count = 1; count < 40; ++count) {
        std::vector<double> values;
        for (int i = 0; i < count; ++i)
            values.push_back(random.between(-10, 10));
        std::vector<double> sorted = values;
        std::sort(sorted.begin(), sorted.end());
        const auto half = static_cast<std::size_t>(count / 2);
        const double expected = count % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
        EXPECT_EQ(core::medianOf(values), expected);
    }
}

} // namespace
