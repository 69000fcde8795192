// SPDX-License-Identifier: MIT
#pragma once

#include "core/segmentation/seeds.h"

namespace core {

struct SeededCutOptions {
    int mostPixels = 90'000;  ///< of the window; a larger one is cut at a smaller scale, and its edge made sharp then
    int learnPixels = 40'000; ///< of a window that colours are learnt from; a larger one is scaled down further for it
    int iterations = 2;       ///< of learning colours and cutting
};

/// Cuts the foreground out of a picture (CV_8UC3 BGR) by the colours of the seeds: GrabCut (Rother, Kolmogorov, Blake
/// 2004) within the seeds' window: colours are learnt at a small scale, which decide at a larger one; then the edge at
/// full size (sharpEdge). CV_8U of the window's size, 0 and 255. Where
/// the seeds hold no foreground or no background there is nothing to learn: what they take for foreground is the
/// answer. The same on every thread.
cv::Mat seededCut(const cv::Mat& picture, const Seeds& seeds, const SeededCutOptions& options = {});

} // namespace core
