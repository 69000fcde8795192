// SPDX-License-Identifier: MIT
#include "core/io/files/text_file.h"

#include <gtest/gtest.h>

#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

TEST(LineReader, SkipsEmptyLinesAndBothKindsOfLineEnds) {
    core::LineReader lines("f.txt", "\r\n\n  Lower Arm L \r\n1 2.5\t-3e2\n\n7");
    EXPECT_EQ(lines.next("a name"), "Lower Arm L");
    EXPECT_EQ(lines.nextNumbers(3, "numbers"), (std::vector<double>{1, 2.5, -300}));
    EXPECT_FALSE(lines.atEnd());
    EXPECT_EQ(lines.nextInteger(0, 10, "a count"), 7);
    EXPECT_TRUE(lines.atEnd());
}

TEST(LineReader, NamesFileAndLineOfWhatIsWrong) {
    const auto numbers = [](const std::string& text) {
        return [text] {
            core::LineReader lines("f.txt", text);
            lines.nextNumbers(2, "a pair");
        };
    };
    using enum core::ErrorCode;
    test::expectError(numbers(""), BadInput, "f.txt", "a pair is expected");
    test::expectError(numbers("\n\n1 2 3"), BadInput, "f.txt: line 3", "2 numbers expected");
    test::expectError(numbers("1 x"), BadInput, "f.txt: line 1", "'x' is not a finite number");
    test::expectError(numbers("1 nan"), BadInput, "f.txt: line 1", "finite");
    test::expectError(numbers("1 1e999"), BadInput, "f.txt: line 1", "finite");
    test::expectError(numbers("1 2x"), BadInput, "f.txt: line 1", "'2x'");
    test::expectError([] { core::LineReader("f.txt", "2.5").nextInteger(0, 9, "a count"); }, BadInput, "f.txt",
                      "whole number from 0 to 9");
    test::expectError([] { core::LineReader("f.txt", "10").nextInteger(0, 9, "a count"); }, BadInput, "f.txt",
                      "whole number from 0 to 9");
}

TEST(ReadTextFile, TellsMissingFilesFoldersAndGiantsApart) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "big", std::string(100, 'x'));
    test::expectError([&] { core::readTextFile(folder / "none"); }, core::ErrorCode::NotFound, "none", "no such file");
    test::expectError([&] { core::readTextFile(folder.path()); }, core::ErrorCode::BadInput, folder.path().string(),
                      "folder");
    test::expectError([&] { core::readTextFile(folder / "big", 99); }, core::ErrorCode::BadInput, "big", "too large");
    EXPECT_EQ(core::readTextFile(folder / "big", 100).size(), 100u);
}

TEST(SplitWords, SplitsAtBlanksAndOnRequestAtCommas) {
    EXPECT_EQ(core::splitWords(" a\tb,c ").size(), 2u);
    EXPECT_EQ(core::splitWords(" a\tb,c ", true).size(), 3u);
    EXPECT_TRUE(core::splitWords("  \t").empty());
}

} // namespace
