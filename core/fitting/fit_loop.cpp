// SPDX-License-Identifier: MIT
#include "core/fitting/fit_loop.h"

#include <algorithm>

namespace core {

FitLoop::Outcome FitLoop::iterate(FitAttempt& attempt, const IterationSettings& settings, double settledMm) {
    if (m_stop.stop_requested()) {
        attempt.termination = FitTermination::Stopped;
        return Outcome::Over;
    }
    FitIteration record = m_refiner.iterate(attempt.poses, settings);
    record.iteration = static_cast<int>(attempt.history.size());
    record.poses = attempt.poses;
    const bool hasMatches = record.matches > 0;
    const bool settled = record.stepMm < settledMm;
    attempt.history.push_back(std::move(record));
    ++m_done;
    if (m_progress) {
        m_progress(std::min(m_done, m_expected), m_expected);
    }
    if (!hasMatches) {
        attempt.termination = FitTermination::NoMatches;
        return Outcome::Over;
    }
    return settled ? Outcome::Settled : Outcome::Moving;
}

} // namespace core
