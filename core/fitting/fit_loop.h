// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/fitting/fit_result.h"
#include "core/fitting/phases.h"
#include "core/fitting/pose_refiner.h"

namespace core {

/// From one start to a pose, with its own history.
struct FitAttempt {
    HandPoses poses;
    std::vector<FitIteration> history;
    FitTermination termination = FitTermination::MaxIterations;
    double rivalMm = 0; ///< how far the joints of another attempt lie that explains the silhouettes nearly as well
};

/// The one loop of every method: it asks whether to stop, iterates, records and reports.
class FitLoop {
public:
    /// `base` holds what all phases share. `expectedIterations` is what progress is measured against; more may follow.
    FitLoop(PoseRefiner& refiner, const IterationSettings& base, std::stop_token stop, const FitProgress& progress,
            int expectedIterations)
        : m_refiner(refiner)
        , m_base(base)
        , m_stop(std::move(stop))
        , m_progress(progress)
        , m_expected(expectedIterations) {}

    /// From now on, all phases share these settings.
    void setBase(const IterationSettings& base) { m_base = base; }

    /// Runs the phases in their order from attempt.poses on. False if the fit is over: it was stopped or has no
    /// matches, as attempt.termination says. Else the termination is that of the last phase.
    bool run(std::span<const Phase> phases, FitAttempt& attempt);
    /// The same; after the first stage, when the hands are about where they belong, sleeves are cut off.
    bool runAndCutSleeves(std::span<const Phase> phases, FitAttempt& attempt);

private:
    enum class Outcome {
        Moving,  ///< the step moved the joints by `settledMm` or more on average
        Settled, ///< by less
        Over     ///< stopped or without matches, as attempt.termination says
    };
    Outcome iterate(const IterationSettings& settings, double settledMm, FitAttempt& attempt);
    Outcome runPhase(const Phase& phase, FitAttempt& attempt);

    PoseRefiner& m_refiner;
    IterationSettings m_base;
    std::stop_token m_stop;
    const FitProgress& m_progress;
    int m_expected;
    int m_done = 0;
};

} // namespace core
