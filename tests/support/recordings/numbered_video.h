// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace test {

/// Pictures that carry their number as ten large squares, black or white, so that it survives compression; a texture
/// moves behind them.
inline constexpr int kNumberedWidth = 160, kNumberedHeight = 96;

cv::Mat numberedPicture(int number, cv::Size size = {kNumberedWidth, kNumberedHeight});

int numberInPicture(const cv::Mat& image);

bool hasFfmpeg();

/// Encodes pictures with these numbers; `options` are ffmpeg's of the output. False if this machine's ffmpeg cannot.
bool encodeNumbered(const std::filesystem::path& file, const std::string& options, const std::vector<int>& numbers,
                    int rate = 25);

/// 0 to count - 1.
std::vector<int> countTo(int count);

} // namespace test
