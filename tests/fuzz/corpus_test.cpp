// SPDX-License-Identifier: MIT
// Every file of tests/data/fuzz through the reader of its folder: what once went wrong there stays mended.
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

#include "tests/fuzz/fuzz_targets.h"

namespace {

struct Target {
    const char* folder;
    void (*read)(std::string_view);
};

void PrintTo(const Target& target, std::ostream* stream) {
    *stream << target.folder;
}

class Corpus : public testing::TestWithParam<Target> {};

std::vector<std::string> filesOf(const char* folder) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(HANDLENS_TEST_DATA) / "fuzz" / folder))
        paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> files;
    for (const auto& path : paths) {
        std::ifstream stream(path, std::ios::binary);
        files.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    }
    return files;
}

TEST_P(Corpus, IsReadOrRefusedSoon) {
    const std::vector<std::string> files = filesOf(GetParam().folder);
    ASSERT_GE(files.size(), 2u);
    for (const std::string& bytes : files) {
        const std::clock_t start = std::clock(); // of this process: other work on the machine does not count
        // Whole, cut off anywhere, and with each part damaged in turn.
        GetParam().read(bytes);
        for (int part = 1; part < 16; ++part) {
            const std::size_t at = bytes.size() * static_cast<std::size_t>(part) / 16;
            GetParam().read(std::string_view(bytes).substr(0, at));
            std::string damaged = bytes;
            for (std::size_t i = at; i < std::min(at + 3, damaged.size()); ++i)
                damaged[i] = static_cast<char>(damaged[i] ^ 0x5A);
            GetParam().read(damaged);
        }
        EXPECT_LT(std::clock() - start, 30 * CLOCKS_PER_SEC);
    }
}

INSTANTIATE_TEST_SUITE_P(
    OfEveryReader, Corpus,
    testing::Values(Target{"video", fuzz::readVideo}, Target{"video_index", fuzz::readIndex},
                    Target{"small_pictures", fuzz::readSmallPictures}, Target{"network", fuzz::runNetwork},
                    Target{"flat_buffer", fuzz::readFlatBuffer}, Target{"archive", fuzz::readArchive},
                    Target{"package_text", fuzz::readPackageText}, Target{"matlab", fuzz::readMatlab},
                    Target{"hdf5", fuzz::readHdf5}, Target{"pickle", fuzz::readPickle}),
    [](const auto& one) { return std::string(one.param.folder); });

} // namespace
