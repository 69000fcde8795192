// SPDX-License-Identifier: MIT
#include "core/fitting/best_fit.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace core {

namespace {

constexpr double kTangentWeight = 0.1; ///< rims may slide along the outline: what is measured is across it
constexpr double kStartPrior = 1;      ///< mm^2 per rad^2 and correspondence: holds what the outlines do not determine

/// Mean distance of the two silhouettes' outlines, px, above which other starts are tried; good fits reach 0.4 to 0.6.
constexpr double kUnexplainedPx = 0.75;
/// With noise sigma on the contour, good fits reach at most 2.9 (sigma - 0.3 px): exact contours have a sigma of 0.4 px
/// from the coarse level of the mesh alone.
constexpr double kUnexplainedPerNoise = 3.2;
constexpr double kExactNoisePx = 0.3;

/// Cauchy scale of the last iterations in standard deviations of the contour's noise, which is taken to be at least so
/// much.
constexpr double kRobustPerNoise = 2;
constexpr double kLeastNoisePx = 0.75;

IterationSettings baseSettings(const Method& method) {
    IterationSettings settings;
    settings.rule = matchRule(method);
    settings.tangentWeight = method.best->across ? kTangentWeight : 1;
    settings.startPrior = method.best->prior ? kStartPrior : 0;
    settings.robustMm = method.best->robustMm;
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

/// Replaces `best` by another attempt that explains the masks better, as long as they are left unexplained. False if
/// the fit is over. `relative`: how much may be left unexplained goes with the noise of the contours.
bool improve(PoseRefiner& refiner, FitLoop& loop, const BestPhases& phases, std::span<const StartKind> otherStarts,
             const HandPoses& start, bool relative, FitAttempt& best) {
    double bestScore = refiner.silhouetteDifferencePx(best.poses);
    double explainedPx = kUnexplainedPx;
    if (relative && bestScore > explainedPx) {
        const double noisePx = refiner.contourNoise(best.poses).px;
        explainedPx = std::max(explainedPx, kUnexplainedPerNoise * (noisePx - kExactNoisePx));
    }
    for (const StartKind kind : otherStarts) {
        if (bestScore <= explainedPx)
            return true;
        const bool again = kind == StartKind::Start;
        FitAttempt attempt;
        attempt.poses = again ? start : withFingers(refiner.hands(), best.poses, kind);
        if (!loop.run(again ? phases.again : phases.fromOtherFingers, attempt)) {
            best.termination = attempt.termination;
            return false;
        }
        const double score = refiner.silhouetteDifferencePx(attempt.poses);
        if (score < bestScore) {
            bestScore = score;
            best = std::move(attempt);
        }
    }
    return true;
}

/// What the iterations on the full mesh share: matches that are far off for the noise of the contours count less.
IterationSettings polishSettings(PoseRefiner& refiner, const Method& method, const HandPoses& poses) {
    IterationSettings settings = baseSettings(method);
    if (method.best->noise && !method.best->live)
        settings.robustPx = kRobustPerNoise * std::max(kLeastNoisePx, refiner.contourNoise(poses).px);
    return settings;
}

} // namespace

FitAttempt fitBest(PoseRefiner& refiner, const Method& method, const HandPoses& start, std::stop_token stop,
                   const FitProgress& progress) {
    const BestOptions& options = *method.best;
    const BestPhases phases = bestPhases(options);
    const int expected = mostIterations(phases.main) + mostIterations(phases.polish);
    FitLoop loop(refiner, baseSettings(method), std::move(stop), progress, expected);
    const std::span<const StartKind> otherStarts =
        options.live ? std::span<const StartKind>(kOtherLiveStarts) : std::span<const StartKind>(kOtherStarts);
    FitAttempt attempt;
    attempt.poses = start;
    if (loop.run(phases.main, attempt) && (!options.restarts || improve(refiner, loop, phases, otherStarts, start,
                                                                        options.noise && !options.live, attempt))) {
        loop.setBase(polishSettings(refiner, method, attempt.poses));
        loop.run(phases.polish, attempt);
    }
    return attempt;
}

} // namespace core
