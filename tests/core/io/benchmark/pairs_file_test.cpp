// SPDX-License-Identifier: MIT
#include "core/io/benchmark/pairs_file.h"

#include <fstream>

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace core {
namespace {

TEST(PairsFile, ReadsBackWhatItWrote) {
    const test::TemporaryFolder folder;
    const std::vector<FramePair> pairs = {{"01", 5, 20}, {"01", 19, 20}, {"a \"b\"", 0, 1}};
    writePairs(folder / "pairs.json", pairs);
    EXPECT_EQ(readPairs(folder / "pairs.json"), pairs);
}

TEST(PairsFile, ReadsPairsWrittenByHand) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "p.json") << R"({"pairs": [{"sequence": "x", "start": 3, "test": 1}]})";
    EXPECT_EQ(readPairs(folder / "p.json"), (std::vector<FramePair>{{"x", 3, 1}}));
}

TEST(PairsFile, RefusesWhatMakesNoSense) {
    const test::TemporaryFolder folder;
    for (const char* const text :
         {"", "[]", "{}", R"({"pairs": 3})", R"({"pairs": [{}]})",
          R"({"pairs": [{"sequence": 1, "start": 0, "test": 1}]})",
          R"({"pairs": [{"sequence": "x", "start": -1, "test": 1}]})",
          R"({"pairs": [{"sequence": "x", "start": 0.5, "test": 1}]})",
          R"({"pairs": [{"sequence": "x", "start": 0, "test": 5, "difference": 4}]})",
          R"({"pairs": [{"sequence": "x", "start": 0, "test": 5}, {"sequence": "x", "start": 0, "test": 5}]})"}) {
        std::ofstream(folder / "p.json", std::ios::trunc) << text;
        EXPECT_THROW(readPairs(folder / "p.json"), Error) << text;
    }
    EXPECT_THROW(readPairs(folder / "missing.json"), Error);
}

} // namespace
} // namespace core
