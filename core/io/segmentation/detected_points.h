// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/annotation/sequence_points.h"
#include "core/detection/hand_detector.h"
#include "core/io/dataset/dataset.h"
#include "core/io/detector/first_pass.h"

namespace core {

/// The joints of labels that were found without a click.
SequencePoints pointsOfLabels(const AutoLabels& labels);

/// Detects hands in these frames; what was detected is kept in `journalFile`, from where the next run goes on. No value
/// if it was stopped. `otherHands`: used where the dataset has none.
std::optional<SequencePoints> detectPoints(const Dataset& dataset, const Sequence& sequence,
                                           const DetectorNetworks& networks, const std::vector<int>& frames,
                                           const std::filesystem::path& journalFile, std::stop_token stop,
                                           const std::function<void(int done, int total)>& progress,
                                           const std::vector<HandModel>& otherHands = {});

} // namespace core
