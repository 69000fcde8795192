// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>
#include <vector>

#include "core/fitting/pose_estimator.h"
#include "core/fitting/pose_refiner.h"

namespace core {

/// One way from a start to a pose, with its own history.
struct FitAttempt {
    HandPoses poses;
    std::vector<FitIteration> history;
    FitTermination termination = FitTermination::MaxIterations;
};

/// The one loop of every method: it asks whether to stop, iterates, records and reports.
class FitLoop {
public:
    /// `expectedIterations` is what progress is measured against; more may follow.
    FitLoop(PoseRefiner& refiner, std::stop_token stop, const FitProgress& progress, int expectedIterations)
        : m_refiner(refiner)
        , m_stop(stop)
        , m_progress(progress)
        , m_expected(expectedIterations) {}

    enum class Outcome {
        Moving,  ///< the step moved the joints by `settledMm` or more
        Settled, ///< by less
        Over     ///< stopped or without matches, as attempt.termination says
    };
    Outcome iterate(FitAttempt& attempt, const IterationSettings& settings, double settledMm);

private:
    PoseRefiner& m_refiner;
    std::stop_token m_stop;
    const FitProgress& m_progress;
    int m_expected;
    int m_done = 0;
};

} // namespace core
