// SPDX-License-Identifier: MIT
#include "core/fitting/best_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <vector>

namespace core {

namespace {

constexpr double kTangentWeight = 0.1; ///< rims may slide along the outline: what is measured is across it
constexpr double kStartPrior = 1;      ///< mm^2 per rad^2 and correspondence: holds what the outlines do not determine

/// mm^2 per correspondence and squared Mahalanobis distance of the angles from the start's: strong where the outlines
/// still lead astray; then what the noise's variance makes of it, for a standard deviation of 1 px.
constexpr double kMotionPrior = 0.02;
constexpr double kMotionPriorPerNoise = 0.003;
constexpr double kLeastMotionNoisePx = 0.5;

/// Mean distance of the two silhouettes' outlines, px, above which other starts are tried; good fits reach 0.4 to 0.6.
constexpr double kUnexplainedPx = 0.75;
/// The same of the part that the contour's noise cannot explain. Noise leaves less than 0.04, a wrong finger more than
/// 0.1.
constexpr double kUnexplainedDeepPx = 0.06;
constexpr int kFingerSearches = 3;
/// An attempt with another pose whose silhouettes differ by at most this factor more is a rival.
constexpr double kRivalScore = 1.1;

/// Cauchy scale of the last iterations in standard deviations of the contour's noise, which is taken to be at least so
/// much.
constexpr double kRobustPerNoise = 2;
constexpr double kLeastNoisePx = 0.75;

/// Whether the contour's noise is measured. The real-time variant has no time for it.
bool isRelative(const BestOptions& options) {
    return options.noise && !options.live;
}

IterationSettings baseSettings(const Method& method) {
    IterationSettings settings;
    settings.rule = matchRule(method);
    settings.tangentWeight = method.best->across ? kTangentWeight : 1;
    const bool learnt = isRelative(*method.best) && method.best->learnt;
    settings.startPrior = method.best->prior && !learnt ? kStartPrior : 0;
    settings.motionPrior = method.best->prior && learnt ? kMotionPrior : 0;
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

/// The wide degrees of freedom of each finger, from its base outward: those below one child of the root bone.
std::vector<std::vector<std::size_t>> wideDofsPerFinger(const Skeleton& skeleton) {
    constexpr double kWideRad = 1;
    std::map<int, std::vector<std::size_t>> byBase;
    for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
        const DegreeOfFreedom& dof = skeleton.dofs[d];
        int base = dof.bone;
        while (skeleton.bones[static_cast<std::size_t>(base)].parent > 0)
            base = skeleton.bones[static_cast<std::size_t>(base)].parent;
        if (dof.maxRad - dof.minRad > kWideRad)
            byBase[base].push_back(d);
    }
    std::vector<std::vector<std::size_t>> fingers;
    for (auto& [base, dofs] : byBase)
        fingers.push_back(std::move(dofs));
    return fingers;
}

/// Finger by finger, the shape out of a few that explains the masks best; its own where none is better. `score` becomes
/// that of the answer.
HandPoses searchFingers(PoseRefiner& refiner, HandPoses poses, double& score) {
    struct Shape {
        double base, others; ///< how far the first joint and those after it are bent, shares of their range
    };
    constexpr std::array kShapes{Shape{0, 0},     Shape{0.35, 0.35}, Shape{0.7, 0.7},
                                 Shape{0.9, 0.9}, Shape{0, 0.8},     Shape{0.8, 0}};
    for (std::size_t h = 0; h < poses.size(); ++h) {
        const Skeleton& skeleton = refiner.hands().models[h].skeleton;
        for (const std::vector<std::size_t>& finger : wideDofsPerFinger(skeleton)) {
            Pose chosen = poses[h];
            for (const Shape& shape : kShapes) {
                for (std::size_t k = 0; k < finger.size(); ++k) {
                    const DegreeOfFreedom& dof = skeleton.dofs[finger[k]];
                    const double bent = -dof.minRad > dof.maxRad ? dof.minRad : dof.maxRad;
                    poses[h][kRigidDofs + static_cast<Eigen::Index>(finger[k])] =
                        std::clamp((k == 0 ? shape.base : shape.others) * bent, dof.minRad, dof.maxRad);
                }
                const double shapeScore = refiner.silhouetteDifferencePx(poses);
                if (shapeScore < score) {
                    score = shapeScore;
                    chosen = poses[h];
                }
            }
            poses[h] = chosen;
        }
    }
    return poses;
}

/// Replaces `best` by attempts from other shapes of single fingers, as long as the silhouettes differ by more than the
/// contour's noise explains and a shape is found that is better. False if the fit is over.
bool improveByFingers(PoseRefiner& refiner, FitLoop& loop, const BestPhases& phases, FitAttempt& best) {
    double bestScore = refiner.silhouetteDifferencePx(best.poses);
    if (bestScore <= kUnexplainedPx)
        return true;
    const int depthPx = beyondNoisePx(refiner.contourNoise(best.poses).px);
    for (int search = 0; search < kFingerSearches; ++search) {
        if (refiner.deepDifferencePx(best.poses, depthPx) <= kUnexplainedDeepPx)
            return true;
        FitAttempt attempt;
        double found = bestScore;
        attempt.poses = searchFingers(refiner, best.poses, found);
        if (found >= bestScore)
            return true;
        if (!loop.run(phases.fromOtherFingers, attempt)) {
            best.termination = attempt.termination;
            return false;
        }
        const double score = refiner.silhouetteDifferencePx(attempt.poses);
        const double apartMm = meanJointDistanceMm(refiner.hands().models, best.poses, attempt.poses);
        const bool better = score < bestScore;
        const double rivalMm = std::max(score, bestScore) <= kRivalScore * std::min(score, bestScore) ? apartMm : 0;
        attempt.rivalMm = best.rivalMm = rivalMm;
        if (!better)
            return true;
        bestScore = score;
        best = std::move(attempt);
    }
    return true;
}

/// Replaces `best` by an attempt from another start that explains the masks better, as long as they are left
/// unexplained by more than the contour's noise. False if the fit is over.
bool improveBeyondNoise(PoseRefiner& refiner, FitLoop& loop, const BestPhases& phases,
                        std::span<const StartKind> otherStarts, const HandPoses& start, FitAttempt& best) {
    double bestScore = refiner.silhouetteDifferencePx(best.poses);
    if (bestScore <= kUnexplainedPx)
        return true;
    const int depthPx = beyondNoisePx(refiner.contourNoise(best.poses).px);
    for (const StartKind kind : otherStarts) {
        if (refiner.deepDifferencePx(best.poses, depthPx) <= kUnexplainedDeepPx)
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

/// Replaces `best` by another attempt that explains the masks better, as long as they are left unexplained. False if
/// the fit is over.
bool improve(PoseRefiner& refiner, FitLoop& loop, const BestPhases& phases, std::span<const StartKind> otherStarts,
             const HandPoses& start, FitAttempt& best) {
    double bestScore = refiner.silhouetteDifferencePx(best.poses);
    for (const StartKind kind : otherStarts) {
        if (bestScore <= kUnexplainedPx)
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
    if (!isRelative(*method.best))
        return settings;
    const double noisePx = refiner.contourNoise(poses).px;
    settings.robustPx = kRobustPerNoise * std::max(kLeastNoisePx, noisePx);
    if (settings.motionPrior > 0)
        settings.motionPrior = kMotionPriorPerNoise * std::pow(std::max(kLeastMotionNoisePx, noisePx), 2);
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
    const auto improved = [&] {
        if (!isRelative(options))
            return improve(refiner, loop, phases, otherStarts, start, attempt);
        const std::span<const StartKind> all(kOtherStarts);
        return improveBeyondNoise(refiner, loop, phases, all.first(1), start, attempt) &&
               improveByFingers(refiner, loop, phases, attempt) &&
               improveBeyondNoise(refiner, loop, phases, all.subspan(1), start, attempt) &&
               improveByFingers(refiner, loop, phases, attempt);
    };
    if (loop.run(phases.main, attempt) && (!options.restarts || improved())) {
        loop.setBase(polishSettings(refiner, method, attempt.poses));
        loop.run(phases.polish, attempt);
    }
    return attempt;
}

} // namespace core
