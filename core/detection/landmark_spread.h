// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace core {

/// How far the detector's landmarks are from the joints that they stand for.
struct LandmarkSpread {
    double share = 0; ///< standard deviation per axis in one picture, share of the side of the hand's square
    Eigen::Vector3d bias =
        Eigen::Vector3d::Zero(); ///< mean in space, in the landmark's frame, share of the palm's length
    double floorMm = 0; ///< standard deviation per axis in space that more views do not lessen, the mean taken off
};

/// Learnt from rendered hands with known joints (tests/benchmarks/learn_landmark_errors.py).
const LandmarkSpread& landmarkSpread(std::size_t landmark);

} // namespace core
