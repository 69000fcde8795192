// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"

namespace test {

/// Expects core::Error with that code, naming that file, with `word` somewhere in its text, in one line.
template <typename Call>
void expectError(Call&& call, core::ErrorCode code, const std::string& file, const std::string& word) {
    try {
        call();
        ADD_FAILURE() << "no error; expected one about " << word;
    } catch (const core::Error& error) {
        const std::string text = error.what();
        EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(code)) << text;
        EXPECT_NE(text.find(file), std::string::npos) << text << " does not name " << file;
        EXPECT_NE(text.find(word), std::string::npos) << text << " does not say " << word;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
}

void writeText(const std::filesystem::path& file, const std::string& text);

std::string readText(const std::filesystem::path& file);

/// `text` with its first `what` replaced; fails the test if there is none.
std::string replaced(std::string text, const std::string& what, const std::string& by);

} // namespace test
