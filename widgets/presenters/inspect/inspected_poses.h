// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "core/io/dataset/dataset.h"
#include "widgets/jobs/fit_runner.h"
#include "widgets/presenters/layer_look.h"

namespace widgets {

/// The hands of a fitted pair at one iteration, posed once for all views.
struct InspectedPoses {
    MeshLayer start;                ///< where every method began
    MeshLayer truth;                ///< the recorded pose; no surfaces if there is none
    MeshLayer recorded;             ///< the same where the target was drawn from it; else no surfaces
    std::vector<MeshLayer> methods; ///< as in the outcome
    /// The same in the colours of their vertices' distance to the recorded pose (colouredByError).
    std::vector<MeshLayer> methodsByError;
    std::vector<core::HandPoses> poses; ///< of the methods
};

/// A method's poses after `iteration` steps.
const core::HandPoses& inspectedPosesAt(const FitOutcome& outcome, const MethodOutcome& method, int iteration);
/// True if those are the method's result.
bool isAtResult(const MethodOutcome& method, int iteration);

/// Poses the hands after `iteration` steps of every method; a method that ended before stays at its result, 0 is the
/// start. Surfaces of `before`, which is of the same pair, are used again where nothing has moved: views draw nothing
/// anew then.
InspectedPoses inspectedPoses(const core::Dataset& dataset, const FitOutcome& outcome, int iteration,
                              const std::stop_token& stop, const InspectedPoses* before = nullptr);

/// Mean joint error of a method after `iteration` steps, mm; NaN without a reference.
double inspectedErrorMm(const FitOutcome& outcome, const MethodOutcome& method, int iteration);

/// What the views of a method's column show: the start pose if it is wanted, the method, and the recorded silhouette as
/// a white line.
std::vector<MeshLayer> inspectedColumn(const InspectedPoses& poses, std::size_t method, const LayerLook& look,
                                       bool startShown, bool recordedShown);

} // namespace widgets
