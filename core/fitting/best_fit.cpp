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

constexpr double kNarrowTauDeg = 22.5;

IterationSettings settingsOf(const Phase& phase, const BestIdeas& ideas) {
    IterationSettings settings;
    const double tauDeg = ideas.wide ? phase.tauDeg : kNarrowTauDeg;
    settings.rule.tauRad = static_cast<float>(tauDeg * std::numbers::pi / 180);
    if (ideas.withinTau) {
        settings.rule.search = MatchRule::Search::WithinTau;
    }
    settings.detail = ideas.coarse ? phase.detail : Detail::Full;
    settings.pointsPerCamera = phase.points;
    settings.contourPointsPerCamera = ideas.bothWays ? phase.points : 0;
    settings.rigidOnly = phase.rigidOnly && ideas.palm;
    settings.tangentWeight = ideas.across ? kTangentWeight : 1;
    settings.startPrior = ideas.prior ? kStartPrior : 0;
    settings.robustMm = ideas.robustMm;
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

class BestFit {
public:
    BestFit(PoseRefiner& refiner, const Method& method, std::stop_token stop, const FitProgress& progress,
            int expectedIterations)
        : m_refiner(refiner)
        , m_ideas(method.ideas)
        , m_loop(refiner, stop, progress, expectedIterations) {}

    /// False if the fit is over: stopped or without matches.
    bool run(const Phase& phase, FitAttempt& attempt) {
        const IterationSettings settings = settingsOf(phase, m_ideas);
        for (int i = 0; i < phase.iterations; ++i) {
            const FitLoop::Outcome outcome = m_loop.iterate(attempt, settings, phase.convergedMm);
            if (outcome == FitLoop::Outcome::Over) {
                return false;
            }
            if (outcome == FitLoop::Outcome::Settled) {
                attempt.termination = FitTermination::Converged;
                return true;
            }
        }
        attempt.termination = FitTermination::MaxIterations;
        return true;
    }

    bool runAll(std::initializer_list<Phase> phases, FitAttempt& attempt) {
        return std::all_of(phases.begin(), phases.end(), [&](const Phase& phase) { return run(phase, attempt); });
    }

    double score(const FitAttempt& attempt) { return m_refiner.silhouetteDifferencePx(attempt.poses); }

    /// Replaces `best` by the alternative that explains the masks better. False if the fit is over.
    bool improve(FitAttempt& best, const HandPoses& start, std::span<const StartKind> otherStarts) {
        if (!m_ideas.restarts) {
            return true;
        }
        double bestScore = score(best);
        const auto tryFrom = [&](const HandPoses& from, std::initializer_list<Phase> phases) {
            FitAttempt attempt;
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

    bool polish(const Phase& phase, FitAttempt& attempt) { return !m_ideas.polish || run(phase, attempt); }

private:
    PoseRefiner& m_refiner;
    const BestIdeas& m_ideas;
    FitLoop m_loop;
};

} // namespace

FitAttempt fitBest(PoseRefiner& refiner, const Method& method, const HandPoses& start, std::stop_token stop,
                   const FitProgress& progress) {
    const bool live = method.live;
    const int expected = live ? kLivePalm.iterations + kLiveFingers.iterations + kLivePolish.iterations
                              : kPalm.iterations + kFingers.iterations + kPolish.iterations;
    BestFit fit(refiner, method, stop, progress, expected);
    FitAttempt attempt;
    attempt.poses = start;
    if (live) {
        if (fit.runAll({kLivePalm, kLiveFingers}, attempt) && fit.improve(attempt, start, kOtherLiveStarts)) {
            fit.polish(kLivePolish, attempt);
        }
    } else if (fit.runAll({kPalm, kFingers}, attempt) && fit.improve(attempt, start, kOtherStarts)) {
        fit.polish(kPolish, attempt);
    }
    return attempt;
}

} // namespace core
