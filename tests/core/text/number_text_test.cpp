// SPDX-License-Identifier: MIT
#include "core/text/number_text.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/random_values.h"

namespace {

TEST(NumberText, ExactTextIsShortAndReadsBackAsTheSameNumber) {
    EXPECT_EQ(core::exactText(0.1), "0.1");
    EXPECT_EQ(core::exactText(-25), "-25");
    EXPECT_EQ(core::exactText(std::nan("")), "");
    test::RandomValues random("exact text");
    for (int i = 0; i < 1000; ++i) {
        const double value = std::ldexp(random.between(-1, 1), static_cast<int>(random.between(-60, 60)));
        double back = 0;
        ASSERT_TRUE(core::parseNumber(core::exactText(value), back));
        EXPECT_EQ(back, value);
    }
}

TEST(NumberText, FixedTextHasThatManyDigits) {
    EXPECT_EQ(core::fixedText(1.005, 1), "1.0");
    EXPECT_EQ(core::fixedText(2.0 / 3, 4), "0.6667");
    EXPECT_EQ(core::fixedText(std::numeric_limits<double>::max(), 0).size(), 309u);
    EXPECT_EQ(core::fixedText(std::nan(""), 2), "");
}

TEST(NumberText, ParsesAWholeWordOrNothing) {
    double value = -1;
    EXPECT_TRUE(core::parseNumber("+1.5e2", value));
    EXPECT_EQ(value, 150);
    for (const char* wrong : {"", "x", "1,5", "1 2", " 1", "1 ", "inf", "nan", "0x10", "1e999"})
        EXPECT_FALSE(core::parseNumber(wrong, value)) << wrong;
}

} // namespace
