// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>

#include "core/fitting/fit_loop.h"
#include "core/fitting/method.h"

namespace core {

/// Our own method, from silhouettes and the start pose alone: palm before fingers, tau annealed from wide to narrow,
/// coarse to fine, a residual that counts across the outline, and other starts where the silhouettes are left
/// unexplained. method.best says which of these are in use, and whether it is the real-time variant.
FitAttempt fitBest(PoseRefiner& refiner, const Method& method, const HandPoses& start, std::stop_token stop,
                   const FitProgress& progress);

} // namespace core
