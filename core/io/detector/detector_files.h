// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "core/detection/hand_detector.h"

namespace core {

/// How a person gets the hand detector's networks, in one sentence.
std::string howToGetDetector();

/// Where installed networks are kept: handlens/detector in the user's data folder (XDG_DATA_HOME, else ~/.local/share).
std::filesystem::path detectorFolder();

/// True if networks have been installed there.
bool isDetectorInstalled(const std::filesystem::path& folder = detectorFolder());

/// Takes the networks out of the npm package @mediapipe/hands (its folder or .tgz), checks that they run, and keeps
/// them in `folder`: what was there before is replaced only then, each file at once. Returns what the package says that
/// it is, such as "@mediapipe/hands 0.4.1675469240". Throws Error naming file and field.
std::string installDetector(const std::filesystem::path& package,
                            const std::filesystem::path& folder = detectorFolder());

/// The installed networks. Throws Error: NotFound with howToGetDetector if there are none, BadInput if a file is
/// damaged.
DetectorNetworks readDetector(const std::filesystem::path& folder = detectorFolder());

} // namespace core
