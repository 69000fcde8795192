// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "core/annotation/edit.h"
#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace test {

/// The code of the error that the work throws.
inline core::ErrorCode errorOf(const std::function<void()>& work) {
    try {
        work();
    } catch (const core::Error& error) {
        return error.code();
    }
    ADD_FAILURE() << "no error";
    return core::ErrorCode::Usage;
}

/// Puts a mark into a frame that has none.
inline core::Edit place(int frame, double x) {
    return {{.text = "place"},
            {{core::MarkKey{frame, "ann", {core::Side::Left, "wrist"}, "cam0"}, std::nullopt, core::Mark{{x, 2.5}}}},
            {}};
}

inline std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

/// A place for an annotation file that is not there yet.
class AnnotationStoreTest : public testing::Test {
protected:
    TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "annotations/01.sqlite";
};

} // namespace test
