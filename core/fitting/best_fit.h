// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>

#include "core/fitting/pose_estimator.h"
#include "core/fitting/pose_refiner.h"

namespace core {

/// Our own method, from silhouettes and the start pose alone: palm before fingers, both directions, tau annealed from
/// wide to narrow, coarse to fine, and several starts of which the score picks one. `live` is the real-time variant.
/// Continues from result.poses and fills history and termination.
void fitBest(PoseRefiner& refiner, bool live, std::stop_token stop, const FitProgress& progress, FitResult& result);

} // namespace core
