// SPDX-License-Identifier: MIT
#include "core/io/files/csv_text.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/text/number_text.h"

namespace {

using Rows = std::vector<core::CsvRow>;

TEST(CsvText, ReadsQuotesLineEndsAndByteOrderMarks) {
    EXPECT_EQ(core::parseCsv("\xEF\xBB\xBF"
                             "a,b\r\n\"x,1\",\"he said \"\"no\"\"\"\r\n",
                             "f"),
              (Rows{{"a", "b"}, {"x,1", "he said \"no\""}}));
    EXPECT_EQ(core::parseCsv("a,,c\n,,\n\n\"two\nlines\"", "f"), (Rows{{"a", "", "c"}, {"", "", ""}, {"two\nlines"}}));
    EXPECT_EQ(core::parseCsv("old\rmac", "f"), (Rows{{"old"}, {"mac"}}));
    EXPECT_TRUE(core::parseCsv("", "f").empty());
    EXPECT_THROW(core::parseCsv("\"open", "f"), core::Error);
    EXPECT_THROW(core::parseCsv("\"a\"b\n", "f"), core::Error);
}

TEST(CsvText, WritesWhatItReads) {
    const Rows rows{{"plain", "with, comma", "with \"quote\"", "", "two\r\nlines"}, {"", "x"}};
    EXPECT_EQ(core::parseCsv(core::csvLine(rows[0]) + core::csvLine(rows[1]), "f"), rows);
}

TEST(CsvText, NumbersComeBackExactly) {
    std::mt19937_64 random(5);
    for (int i = 0; i < 1000; ++i) {
        const double value = std::ldexp(static_cast<double>(random()) - 9e18, static_cast<int>(random() % 80) - 60);
        EXPECT_EQ(core::cellNumber(core::exactText(value), "f", ""), value);
    }
    EXPECT_EQ(core::exactText(0.1), "0.1");
}

TEST(CsvText, MissingIsNotZeroAndTextIsNotANumber) {
    for (const char* missing : {"", " ", "NaN", "nan", "NA", "null"})
        EXPECT_FALSE(core::cellNumber(missing, "f", "")) << missing;
    EXPECT_EQ(core::cellNumber(" 0 ", "f", ""), 0.0);
    for (const char* wrong : {"x", "1,5", "1 2", "inf", "0x10"})
        EXPECT_THROW(core::cellNumber(wrong, "f", ""), core::Error) << wrong;
}

TEST(CsvText, SemicolonsSeparateWhereTheCommaIsTheDecimalSign) {
    EXPECT_EQ(core::parseCsv("a;b;c\r\n1,5;-2,25e3;x, y\r\n", "f"),
              (Rows{{"a", "b", "c"}, {"1.5", "-2.25e3", "x, y"}}));
    EXPECT_EQ(core::parseCsv("sep=;\r\na;\"b;c\"\n", "f"), (Rows{{"a", "b;c"}}));
    EXPECT_EQ(core::parseCsv("a;b\n0.5;img1.png\n", "f"), (Rows{{"a", "b"}, {"0.5", "img1.png"}}));
    EXPECT_EQ(core::parseCsv("a,\"b;c;d\"\n1,2\n", "f"), (Rows{{"a", "b;c;d"}, {"1", "2"}}))
        << "quoted semicolons are text";
    EXPECT_THROW(core::parseCsv("a;b\n1,5;2.5\n", "f"), core::Error) << "may be thousands";
}

} // namespace
