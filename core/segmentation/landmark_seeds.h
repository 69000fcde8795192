// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/segmentation/hand_in_view.h"
#include "core/segmentation/seeds.h"

namespace core {

/// Thicknesses of what is drawn between the landmarks, in lengths of the palm.
struct LandmarkSeedOptions {
    double surePalms = 0.1;        ///< lines that lie in the hand whatever the landmarks' errors are
    double probablePalms = 0.18;   ///< about as thick as a finger
    double reachPalms = 0.2;       ///< farther than that from every line, and not in the palm, is background
    double forearmPalms = 0.5;     ///< probable thickness of the forearm
    double forearmHullPalms = 0.9; ///< and how wide it may be
    double marginPalms = 0.35;     ///< background around it all that colours are learnt from
};

/// Seeds of the hands of a picture by their landmarks: a thin skeleton is sure foreground, a thick one and the forearm
/// are probable, what is near it may be either, the rest is background. The window is empty if no hand is known.
Seeds landmarkSeeds(const cv::Size& picture, const std::vector<HandInView>& hands,
                    const LandmarkSeedOptions& options = {});

} // namespace core
