// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace core {

/// How far the detector's landmarks are from the joints that they stand for.
struct LandmarkError {
    double spread = 0;  ///< standard deviation per axis in one picture, share of the side of the hand's square
    double floorMm = 0; ///< standard deviation per axis in space that more views do not lessen: what it gets wrong
                        ///< alike in all of them, and where it means another point of the joint
};

/// Learnt from rendered hands with known joints.
const LandmarkError& landmarkError(std::size_t landmark);

} // namespace core
