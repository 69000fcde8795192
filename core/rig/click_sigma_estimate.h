// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/annotation/click_sigmas.h"
#include "core/rig/rig_residuals.h"

namespace core {

/// What all clicks of a dataset say of how far clicks scatter, per rater and camera, after the systematic part of each
/// camera is taken off, and how large that part is (RigErrorModel). A rater with fewer than kLeastSigmaFreedom
/// redundant coordinates is not known and stays assumed. O(clicks * cameras + cameras^3).
ClickSigmas estimateClickSigmas(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints,
                                const RigResiduals& residuals);
ClickSigmas estimateClickSigmas(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints);

/// About three joints in eight views: sigma is known to 13 %.
inline constexpr double kLeastSigmaFreedom = 30;

} // namespace core
