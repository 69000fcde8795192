// SPDX-License-Identifier: MIT
#include "core/detection/landmark_spread.h"

#include <array>

#include "core/detection/hand_landmarks.h"

namespace core {

const LandmarkSpread& landmarkSpread(std::size_t landmark) {
    // Shares below 0.015 are raised to it: their distributions have long tails. The rendered hands have no finger tips
    // and no wrist, and mean another point by thumb_cmc: these have no bias and the spread of their neighbours.
    static const std::array<LandmarkSpread, kLandmarkCount> kSpreads{{
        {0.024, {0, 0, 0}, 3.0},              // wrist
        {0.020, {0, 0, 0}, 3.0},              // thumb_cmc
        {0.016, {-0.025, 0.026, 0.020}, 1.8}, // thumb_mcp
        {0.015, {-0.027, -0.038, 0.013}, 1.8},
        {0.018, {0, 0, 0}, 2.5}, // thumb_tip
        {0.023, {0.005, -0.006, 0.027}, 2.6},
        {0.015, {-0.013, -0.025, 0.024}, 2.1},
        {0.015, {-0.007, -0.019, 0.028}, 2.2},
        {0.018, {0, 0, 0}, 2.5}, // index_tip
        {0.026, {-0.015, -0.015, 0.064}, 2.5},
        {0.018, {-0.012, -0.020, 0.044}, 2.3},
        {0.016, {-0.003, -0.025, 0.059}, 1.9},
        {0.018, {0, 0, 0}, 2.5}, // middle_tip
        {0.027, {-0.010, -0.022, 0.071}, 1.6},
        {0.016, {-0.005, -0.013, 0.039}, 1.5},
        {0.015, {0.007, -0.025, 0.040}, 1.6},
        {0.018, {0, 0, 0}, 2.5}, // ring_tip
        {0.024, {0.016, -0.031, 0.015}, 2.2},
        {0.015, {0.006, -0.011, 0.014}, 1.5},
        {0.015, {0.003, -0.015, 0.020}, 1.6},
        {0.018, {0, 0, 0}, 2.5}, // little_tip
    }};
    return kSpreads.at(landmark);
}

} // namespace core
