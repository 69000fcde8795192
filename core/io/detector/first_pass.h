// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/detection/hand_detector.h"
#include "core/io/dataset/dataset.h"
#include "core/labelling/retracking.h"

namespace core {

struct FirstPassOptions : PassOptions {
    std::vector<HandModel> otherHands{}; ///< that are used where the dataset has none (demoHands)
    std::filesystem::path journal{};     ///< keeps what is done while it works; the same pass goes on from there
};

/// Called as frames are done, from the pass's thread.
struct FirstPassCallbacks {
    PassProgress progress{};
    std::function<void(int frame, const std::vector<AutoHand>& hands)> frame{}; ///< again when a frame was improved
};

struct FirstPassResult {
    AutoLabels labels;
    PassResult pass;         ///< poses, and the hands that they are of
    int resumedFrames = 0;   ///< whose detections the journal had already
    bool isFinished = false; ///< else it was stopped: the journal stays for the next run
};

/// Labels frames (ascending) of a sequence without a click (runLabelPass): the one entry point of the command line and
/// of the window. The journal goes when the pass is finished and the caller has kept the labels (finishFirstPass).
/// Throws Error, also if the dataset has no hands and none are given.
FirstPassResult runFirstPass(const Dataset& dataset, const Sequence& sequence, const DetectorNetworks& networks,
                             const std::vector<int>& frames, const FirstPassOptions& options, std::stop_token stop = {},
                             const FirstPassCallbacks& callbacks = {});

/// What a journal's detections are of: the sequence, its cameras and the networks.
std::string detectionWork(const Dataset& dataset, const Sequence& sequence, const DetectorNetworks& networks);

/// The labels are kept: the journal is not needed any more.
void finishFirstPass(const FirstPassOptions& options);

/// `retrack` with the pictures and masks of a dataset. Needs no detector. `hands` and `cameras`: those of the pass
/// (PassResult); labels are seen in the dataset's cameras.
AutoLabels retrackFrames(const Dataset& dataset, const Sequence& sequence, const std::vector<HandModel>& hands,
                         const std::vector<Camera>& cameras, const CorrectedFrame& corrected,
                         const std::vector<int>& frames, const std::vector<int>& reviewed,
                         const PassOptions& options = {}, std::stop_token stop = {},
                         const FirstPassCallbacks& callbacks = {});

} // namespace core
