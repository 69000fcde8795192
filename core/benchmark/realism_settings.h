// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/simulation/imperfection.h"

namespace core {

/// One level of realism at which methods are compared.
struct RealismSetting {
    std::string id;    ///< names its folder, such as "rig-0.08"
    std::string title; ///< for people
    std::string axis;  ///< "contour", "rig", "hand": one imperfection alone; "ladder": each one added; "clean"
    double value = 0;  ///< along the axis: px, degrees, % of size; on the ladder its step
    Imperfection world;
    bool isClicked = false; ///< errors are against triangulated clicks (1 px of noise), else against the true joints
    bool isAdapted = false; ///< after the rig was refined and the hands measured from five annotated frames
};

/// The clean setting first, then the axes, then the ladder as it is and adapted.
std::vector<RealismSetting> realismSettings();

/// What the values of an axis are: "contour noise (px)".
std::string realismAxisLabel(const std::string& axis);

} // namespace core
