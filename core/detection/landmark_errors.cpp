// SPDX-License-Identifier: MIT
#include "core/detection/landmark_errors.h"

#include <array>

#include "core/detection/hand_landmarks.h"

namespace core {

const LandmarkError& landmarkError(std::size_t landmark) {
    static const std::array<LandmarkError, kLandmarkCount> kErrors = [] {
        std::array<LandmarkError, kLandmarkCount> errors;
        errors.fill({0.02, 3});
        return errors;
    }();
    return kErrors.at(landmark);
}

} // namespace core
