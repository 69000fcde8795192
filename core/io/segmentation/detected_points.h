// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/annotation/sequence_points.h"
#include "core/detection/hand_detector.h"
#include "core/detection/hand_views.h"
#include "core/io/dataset/dataset.h"

namespace core {

/// The landmarks in space of what the detector saw, by frame; of the calibration's unit. Sides are those that all views
/// of all frames speak for.
SequencePoints pointsOfDetections(const std::vector<Camera>& cameras, const std::map<int, ViewDetections>& views);

/// Detects hands in these frames (ascending), and nothing else; what was detected is kept in `journalFile`, from where
/// the next run goes on. No value if it was stopped. Throws Error.
std::optional<SequencePoints> detectPoints(const Dataset& dataset, const Sequence& sequence,
                                           const DetectorNetworks& networks, const std::vector<int>& frames,
                                           const std::filesystem::path& journalFile, std::stop_token stop,
                                           const std::function<void(int done, int total)>& progress);

} // namespace core
