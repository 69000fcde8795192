// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <stop_token>
#include <vector>

#include "core/detection/hand_detector.h"
#include "core/detection/hand_doubt.h"
#include "core/io/dataset/dataset.h"
#include "core/io/detector/detection_journal.h"

namespace core {

/// A hand as the first pass labels it, without a click.
struct AutoHand {
    SidedHand hand;
    double doubt = 0; ///< 0 = sure .. 1 = lost
};
/// By frame; frames in which nothing was found have none.
using AutoLabels = std::map<int, std::vector<AutoHand>>;

/// What a sequence's detections depend on, for DetectionJournal.
std::string firstPassWork(const Dataset& dataset, const Sequence& sequence, const DetectorNetworks& networks);

/// Detects hands in these frames (ascending), those aside that the journal has already. Says after each how many are
/// done. Returns false if it was stopped.
bool detectFrames(const Dataset& dataset, const Sequence& sequence, const DetectorNetworks& networks,
                  const std::vector<int>& frames, DetectionJournal& journal, std::stop_token stop,
                  const std::function<void(int done, int total)>& progress);

/// The hands of these frames in space, with their sides and doubts.
AutoLabels labelsOf(const Dataset& dataset, const Sequence& sequence, const std::map<int, ViewDetections>& detections,
                    const std::vector<int>& frames);

} // namespace core
