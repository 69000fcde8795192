// SPDX-License-Identifier: MIT
#include "core/fitting/fit_loop.h"

#include <algorithm>

namespace core {

FitLoop::Outcome FitLoop::iterate(const IterationSettings& settings, double settledMm, FitAttempt& attempt) {
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
    if (m_progress)
        m_progress(std::min(m_done, m_expected), m_expected);
    if (!hasMatches) {
        attempt.termination = FitTermination::NoMatches;
        return Outcome::Over;
    }
    return settled ? Outcome::Settled : Outcome::Moving;
}

FitLoop::Outcome FitLoop::runPhase(const Phase& phase, FitAttempt& attempt) {
    const IterationSettings settings = settingsOf(phase, m_base);
    const int first = static_cast<int>(attempt.history.size());
    attempt.termination = FitTermination::MaxIterations;
    for (int i = first; i < phase.until && i - first < phase.iterations; ++i) {
        const Outcome outcome = iterate(settings, phase.settledMm, attempt);
        if (outcome == Outcome::Settled)
            attempt.termination = FitTermination::Converged;
        if (outcome != Outcome::Moving)
            return outcome;
    }
    return Outcome::Moving;
}

bool FitLoop::run(std::span<const Phase> phases, FitAttempt& attempt) {
    for (std::size_t p = 0; p < phases.size(); ++p) {
        const Outcome outcome = runPhase(phases[p], attempt);
        if (outcome == Outcome::Over)
            return false;
        while (outcome == Outcome::Settled && p + 1 < phases.size() && phases[p + 1].stage == phases[p].stage)
            ++p; // the rest of this stage would move no further
    }
    return true;
}

bool FitLoop::runAndCutSleeves(std::span<const Phase> phases, FitAttempt& attempt) {
    const auto next =
        std::find_if(phases.begin(), phases.end(), [&](const Phase& p) { return p.stage != phases.front().stage; });
    if (next == phases.end())
        return run(phases, attempt);
    const auto first = static_cast<std::size_t>(next - phases.begin());
    if (!run(phases.first(first), attempt))
        return false;
    m_refiner.cutSleeves(attempt.poses);
    return run(phases.subspan(first), attempt);
}

} // namespace core
