// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace core {

/// One node of a skeleton in a picture. Pixel centres are at integers.
struct SleapPoint {
    std::string node;
    double x = 0, y = 0;
    std::optional<double> score; ///< of a guess
};

/// One skeleton in one picture: labelled by a person, or guessed.
struct SleapInstance {
    std::string video; ///< name without folder and ending; the folder of single pictures; empty if unknown
    int frame = 0;     ///< of the video, from 0
    std::string track; ///< empty if there is none
    bool isGuess = false;
    std::vector<SleapPoint> points; ///< those that are there
};

struct SleapFile {
    std::vector<SleapInstance> instances;
    int hiddenPoints = 0; ///< labels that are marked as not visible; left out
};

/// Reads a SLEAP project (.slp) or an analysis export (.h5); the content tells them apart. Guesses that a person has
/// corrected are left out. Labels of projects before format 1.1 count pixels from their corners and are moved by half a
/// pixel; guesses never did. Throws Error(BadInput) naming file and dataset.
SleapFile readSleapFile(const std::filesystem::path& file);

/// The name of a video: without folder and ending; the folder's name for a picture.
std::string sleapVideoName(std::string path);

} // namespace core
