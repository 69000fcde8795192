// SPDX-License-Identifier: MIT
#include "core/fitting/best_fit.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <numbers>
#include <span>
#include <vector>

namespace core {

namespace {

/// A run of iterations with the same settings; it ends early when a step moves the joints less than `convergedMm`.
struct Phase {
    int iterations;
    bool rigidOnly;
    double tauDeg;
    Detail detail;
    int points;
    double convergedMm;
};

constexpr double kTangentWeight = 0.1; ///< rims may slide along the outline: what is measured is across it
constexpr double kStartPrior = 1;      ///< mm^2 per rad^2 and correspondence: holds what the outlines do not tell

// The palm first, then the fingers, on the coarse level; the full mesh has the last word.
constexpr Phase kPalm{8, true, 45, Detail::Coarse, 120, 0.1};
constexpr Phase kFingers{17, false, 45, Detail::Coarse, 120, 0.05};
constexpr Phase kPolish{4, false, 22.5, Detail::Full, 300, 0.02};

// Other ways out of the start, tried only where the outlines are left unexplained.
constexpr Phase kLongPalm{16, true, 90, Detail::Coarse, 120, 0.1};
constexpr Phase kNarrowFingers{25, false, 22.5, Detail::Coarse, 200, 0.05};
constexpr Phase kWideFingers{25, false, 90, Detail::Coarse, 200, 0.05};

constexpr Phase kLivePalm{4, true, 45, Detail::Coarse, 100, 0.2};
constexpr Phase kLiveFingers{7, false, 45, Detail::Coarse, 100, 0.1};
constexpr Phase kLivePolish{1, false, 22.5, Detail::Medium, 150, 0};

/// Mean distance of the two silhouettes' outlines, px, above which other starts are tried; good fits reach 0.4 to 0.6.
constexpr double kUnexplainedPx = 0.75;

IterationSettings settingsOf(const Phase& phase) {
    IterationSettings settings;
    settings.rule.tauRad = static_cast<float>(phase.tauDeg * std::numbers::pi / 180);
    settings.detail = phase.detail;
    settings.pointsPerCamera = phase.points;
    settings.rigidOnly = phase.rigidOnly;
    settings.tangentWeight = kTangentWeight;
    settings.startPrior = kStartPrior;
    return settings;
}

/// Where another attempt begins: at the start pose, or at the best pose so far with all fingers stretched, half bent or
/// bent, as if the fingers had been caught by the wrong outlines.
enum class StartKind { Start, Stretched, HalfBent, Bent };
constexpr std::array kOtherStarts{StartKind::Start, StartKind::Stretched, StartKind::HalfBent, StartKind::Bent};
constexpr std::array kOtherLiveStarts{StartKind::Stretched, StartKind::Bent};

double bendShare(StartKind kind) {
    return kind == StartKind::HalfBent ? 0.35 : kind == StartKind::Bent ? 0.7 : 0;
}

/// The same place of the hands with other fingers: wide joints bent by a share of their range, all others straight.
HandPoses withFingers(const FittingHands& hands, HandPoses poses, StartKind kind) {
    constexpr double kWideRad = 1;
    for (std::size_t h = 0; h < poses.size(); ++h) {
        const std::vector<DegreeOfFreedom>& dofs = hands.models[h].skeleton.dofs;
        for (std::size_t d = 0; d < dofs.size(); ++d) {
            const DegreeOfFreedom& dof = dofs[d];
            const double bent = -dof.minRad > dof.maxRad ? dof.minRad : dof.maxRad;
            const double share = dof.maxRad - dof.minRad > kWideRad ? bendShare(kind) : 0;
            poses[h][kRigidDofs + static_cast<Eigen::Index>(d)] = std::clamp(share * bent, dof.minRad, dof.maxRad);
        }
    }
    return poses;
}

/// One way from the start to a pose, with its own history.
struct Attempt {
    HandPoses poses;
    std::vector<FitIteration> history;
    FitTermination termination = FitTermination::MaxIterations;
};

class BestFit {
public:
    BestFit(PoseRefiner& refiner, std::stop_token stop, const FitProgress& progress, int expectedIterations)
        : m_refiner(refiner)
        , m_stop(stop)
        , m_progress(progress)
        , m_expected(expectedIterations) {}

    /// False if the fit is over: stopped or without matches.
    bool run(const Phase& phase, Attempt& attempt) {
        const IterationSettings settings = settingsOf(phase);
        for (int i = 0; i < phase.iterations; ++i) {
            if (m_stop.stop_requested()) {
                attempt.termination = FitTermination::Stopped;
                return false;
            }
            FitIteration record = m_refiner.iterate(attempt.poses, settings);
            record.iteration = static_cast<int>(attempt.history.size());
            record.poses = attempt.poses;
            attempt.history.push_back(record);
            ++m_done;
            if (m_progress) {
                m_progress(std::min(m_done, m_expected), m_expected);
            }
            if (record.matches == 0) {
                attempt.termination = FitTermination::NoMatches;
                return false;
            }
            if (record.stepMm < phase.convergedMm) {
                attempt.termination = FitTermination::Converged;
                return true;
            }
        }
        attempt.termination = FitTermination::MaxIterations;
        return true;
    }

    bool runAll(std::initializer_list<Phase> phases, Attempt& attempt) {
        for (const Phase& phase : phases) {
            if (!run(phase, attempt)) {
                return false;
            }
        }
        return true;
    }

    double score(const Attempt& attempt) { return m_refiner.silhouetteDifferencePx(attempt.poses); }

    /// Replaces `best` by the alternative that explains the masks better. False if the fit is over.
    bool improve(Attempt& best, const HandPoses& start, std::span<const StartKind> otherStarts) {
        double bestScore = score(best);
        const auto tryFrom = [&](const HandPoses& from, std::initializer_list<Phase> phases) {
            Attempt attempt;
            attempt.poses = from;
            if (!runAll(phases, attempt)) {
                best.termination = attempt.termination;
                return false;
            }
            const double attemptScore = score(attempt);
            if (attemptScore < bestScore) {
                bestScore = attemptScore;
                best = std::move(attempt);
            }
            return true;
        };
        for (const StartKind kind : otherStarts) {
            if (bestScore <= kUnexplainedPx) {
                return true;
            }
            const bool goOn = kind == StartKind::Start ? tryFrom(start, {kLongPalm, kNarrowFingers})
                                                       : tryFrom(withFingers(m_refiner.hands(), best.poses, kind),
                                                                 {kWideFingers, kNarrowFingers});
            if (!goOn) {
                return false;
            }
        }
        return true;
    }

private:
    PoseRefiner& m_refiner;
    std::stop_token m_stop;
    const FitProgress& m_progress;
    int m_expected;
    int m_done = 0;
};

} // namespace

void fitBest(PoseRefiner& refiner, bool live, std::stop_token stop, const FitProgress& progress, FitResult& result) {
    const int expected = live ? kLivePalm.iterations + kLiveFingers.iterations + kLivePolish.iterations
                              : kPalm.iterations + kFingers.iterations + kPolish.iterations;
    BestFit fit(refiner, stop, progress, expected);
    Attempt attempt;
    attempt.poses = result.poses;
    if (live) {
        if (fit.runAll({kLivePalm, kLiveFingers}, attempt) && fit.improve(attempt, result.poses, kOtherLiveStarts)) {
            fit.run(kLivePolish, attempt);
        }
    } else if (fit.runAll({kPalm, kFingers}, attempt) && fit.improve(attempt, result.poses, kOtherStarts)) {
        fit.run(kPolish, attempt);
    }
    result.poses = attempt.poses;
    result.history = std::move(attempt.history);
    result.termination = attempt.termination;
}

} // namespace core
