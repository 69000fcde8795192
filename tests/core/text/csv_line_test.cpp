// SPDX-License-Identifier: MIT
#include "core/text/csv_line.h"

#include <gtest/gtest.h>

namespace {

TEST(CsvLine, QuotesOnlyCellsThatNeedIt) {
    EXPECT_EQ(core::csvCell("plain text"), "plain text");
    EXPECT_EQ(core::csvCell(""), "");
    EXPECT_EQ(core::csvCell("a,b"), "\"a,b\"");
    EXPECT_EQ(core::csvCell("say \"no\""), "\"say \"\"no\"\"\"");
    EXPECT_EQ(core::csvCell("two\nlines"), "\"two\nlines\"");
    EXPECT_EQ(core::csvCell("carriage\rreturn"), "\"carriage\rreturn\"");
}

TEST(CsvLine, SeparatesCellsAndKeepsEmptyOnes) {
    EXPECT_EQ(core::csvLine({"a", "", "c,d"}), "a,,\"c,d\"\n");
    EXPECT_EQ(core::csvLine({"", "", ""}), ",,\n");
    EXPECT_EQ(core::csvLine({""}), "\n");
}

} // namespace
