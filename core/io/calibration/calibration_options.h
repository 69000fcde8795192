// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "core/geometry/camera.h"

namespace core {

/// What a person says about a calibration file beside its name.
struct CalibrationOptions {
    std::string kind;                ///< empty: told from the content
    std::optional<ImageSize> size;   ///< for files that hold none; files that do hold one keep theirs
    std::optional<double> mmPerUnit; ///< overrides the kind's usual unit
    std::string section;             ///< which capture of an InterHand file; empty if there is one only
    bool assumeSize = false;         ///< where no size is known, twice the mean principal point is taken, and noted
};

} // namespace core
