// SPDX-License-Identifier: MIT
#include "core/fitting/best_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <span>
#include <vector>

namespace core {

namespace {

constexpr double kTangentWeight = 0.1; ///< rims may slide along the outline: what is measured is across it
constexpr double kStartPrior = 1;      ///< mm^2 per rad^2 and correspondence: holds what the outlines do not determine

/// Mean distance of the two silhouettes' outlines, px, above which other starts are tried; good fits reach 0.4 to 0.6.
constexpr double kUnexplainedPx = 0.75;
/// The same of the part that the contour's noise cannot explain. Noise leaves less than 0.04, in speckled masks of
/// another hand up to 0.09; a wrong finger more than 0.1.
constexpr double kUnexplainedDeepPx = 0.06, kUnexplainedNoisyDeepPx = 0.1;
constexpr int kFingerSearches = 3;
/// Contours that lie farther off than noise takes them, everywhere alike: the person's hands are others than the
/// models, the calibration is off, or masks are rough. A lost hand leaves more unexplained, and in places. No start
/// explains that; fingers are searched, roughly, and only what explains more by this share is followed.
constexpr double kSystematicPx = 2, kSystematicDeepPx = 0.4, kSystematicScore = 2, kWorthwhileShare = 0.005;
/// Noisy silhouettes that leave less than this unexplained have no more than a wrong finger: not all fingers are tried.
constexpr double kFingerDeepPx = 0.25;
/// An attempt with another pose whose silhouettes differ by at most this factor more is a rival.
constexpr double kRivalScore = 1.1;

/// Whether the contour's noise is measured. The real-time variant has no time for it.
bool isRelative(const Method& method) {
    return method.noise && !method.best->live;
}

IterationSettings baseSettings(const Method& method) {
    IterationSettings settings;
    settings.rule = matchRule(method);
    settings.tangentWeight = method.best->across ? kTangentWeight : 1;
    const bool learnt = isRelative(method) && method.best->learnt;
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

/// Bends of fingers and thumbs, not spreads and twists.
bool isWide(const DegreeOfFreedom& dof) {
    constexpr double kWideRad = 1;
    return dof.maxRad - dof.minRad > kWideRad;
}

/// Bent by a share of its range from straight, within its limits, rad.
double bentAngle(const DegreeOfFreedom& dof, double share) {
    const double bent = -dof.minRad > dof.maxRad ? dof.minRad : dof.maxRad;
    return std::clamp(share * bent, dof.minRad, dof.maxRad);
}

/// The same place of the hands with other fingers: wide joints bent by a share of their range, all others straight.
HandPoses withFingers(const FittingHands& hands, HandPoses poses, StartKind kind) {
    for (std::size_t h = 0; h < poses.size(); ++h) {
        const std::vector<DegreeOfFreedom>& dofs = hands.models[h].skeleton.dofs;
        for (std::size_t d = 0; d < dofs.size(); ++d) {
            const double share = isWide(dofs[d]) ? bendShare(kind) : 0;
            poses[h][kRigidDofs + static_cast<Eigen::Index>(d)] = bentAngle(dofs[d], share);
        }
    }
    return poses;
}

/// The wide degrees of freedom of each finger, from its base outward: those below one child of the root bone.
std::vector<std::vector<std::size_t>> wideDofsPerFinger(const Skeleton& skeleton) {
    std::map<int, std::vector<std::size_t>> byBase;
    for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
        const DegreeOfFreedom& dof = skeleton.dofs[d];
        int base = dof.bone;
        while (skeleton.bones[static_cast<std::size_t>(base)].parent > 0)
            base = skeleton.bones[static_cast<std::size_t>(base)].parent;
        if (isWide(dof))
            byBase[base].push_back(d);
    }
    std::vector<std::vector<std::size_t>> fingers;
    for (auto& [base, dofs] : byBase)
        fingers.push_back(std::move(dofs));
    return fingers;
}

/// Finger by finger, the shape out of a few that explains the masks best; its own where none is better. `score` becomes
/// that of the answer. cellPx: of the scores.
HandPoses searchFingers(PoseRefiner& refiner, HandPoses poses, double& score, float cellPx) {
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
                for (std::size_t k = 0; k < finger.size(); ++k)
                    poses[h][kRigidDofs + static_cast<Eigen::Index>(finger[k])] =
                        bentAngle(skeleton.dofs[finger[k]], k == 0 ? shape.base : shape.others);
                const double shapeScore = refiner.silhouetteDifferencePx(poses, cellPx);
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

/// The best attempt so far, and the search for a better one from other starts.
class OtherStarts {
public:
    OtherStarts(PoseRefiner& refiner, FitLoop& loop, const BestPhases& phases, const HandPoses& start, FitAttempt& best)
        : m_refiner(refiner)
        , m_loop(loop)
        , m_phases(phases)
        , m_start(start)
        , m_best(best)
        , m_scorePx(refiner.silhouetteDifferencePx(best.poses)) {}

    /// Whether the contours are so far off that finding out by attempts whether another start is better is of no use.
    /// Only where arms are seen: silhouettes that end with the hands are searched as ever.
    bool isSystematic() {
        const double noisePx = m_refiner.contourNoise(m_best.poses).px;
        return m_refiner.forearms().any() && noisePx > kSystematicPx && m_scorePx < kSystematicScore * noisePx &&
               deepPx(noisePx) < kSystematicDeepPx;
    }
    bool isOneFinger() { return deepPx(m_refiner.contourNoise(m_best.poses).px) < kFingerDeepPx; }

    bool isExplained() const { return m_scorePx <= kUnexplainedPx; }
    /// Whether the contour's noise, as it is at the best attempt when this is asked for, explains what is left.
    std::function<bool()> explainedByNoise() {
        const double mostPx = m_refiner.isNoisy() ? kUnexplainedNoisyDeepPx : kUnexplainedDeepPx;
        return [this, mostPx, noisePx = m_refiner.contourNoise(m_best.poses).px] { return deepPx(noisePx) <= mostPx; };
    }

    /// Attempts from whole other starts, until what is left is explained. False if the fit is over.
    bool tryStarts(std::span<const StartKind> kinds, const std::function<bool()>& explained);
    /// Attempts from other shapes of single fingers, as long as a shape is found that is better. False if the fit is
    /// over.
    bool tryFingers(const std::function<bool()>& explained);
    /// The same in few steps, for contours that are off everywhere.
    bool tryFingersRoughly(const std::function<bool()>& explained);

private:
    bool run(const std::vector<Phase>& phases, FitAttempt& attempt) {
        const bool goesOn = m_loop.run(phases, attempt);
        if (!goesOn)
            m_best.termination = attempt.termination;
        return goesOn;
    }
    /// False if it is not better.
    bool take(FitAttempt attempt, double scorePx) {
        if (scorePx >= m_scorePx)
            return false;
        m_scorePx = scorePx;
        m_best = std::move(attempt);
        return true;
    }

    /// What contours with that noise do not explain of the best attempt.
    double deepPx(double noisePx) { return m_refiner.deepDifferencePx(m_best.poses, beyondNoisePx(noisePx)); }

    PoseRefiner& m_refiner;
    FitLoop& m_loop;
    const BestPhases& m_phases;
    const HandPoses& m_start;
    FitAttempt& m_best;
    double m_scorePx;
};

bool OtherStarts::tryStarts(std::span<const StartKind> kinds, const std::function<bool()>& explained) {
    for (const StartKind kind : kinds) {
        if (explained())
            return true;
        const bool again = kind == StartKind::Start;
        FitAttempt attempt;
        attempt.poses = again ? m_start : withFingers(m_refiner.hands(), m_best.poses, kind);
        if (!run(again ? m_phases.again : m_phases.fromOtherFingers, attempt))
            return false;
        const double scorePx = m_refiner.silhouetteDifferencePx(attempt.poses);
        take(std::move(attempt), scorePx);
    }
    return true;
}

bool OtherStarts::tryFingers(const std::function<bool()>& explained) {
    for (int search = 0; search < kFingerSearches && !explained(); ++search) {
        FitAttempt attempt;
        double foundPx = m_scorePx;
        attempt.poses = searchFingers(m_refiner, m_best.poses, foundPx, PoseRefiner::kScoreCellPx);
        if (foundPx >= m_scorePx)
            return true;
        if (!run(m_phases.fromOtherFingers, attempt))
            return false;
        const double scorePx = m_refiner.silhouetteDifferencePx(attempt.poses);
        const bool isRival = std::max(scorePx, m_scorePx) <= kRivalScore * std::min(scorePx, m_scorePx);
        attempt.rivalMm = m_best.rivalMm =
            isRival ? meanJointDistanceMm(m_refiner.hands().models, m_best.poses, attempt.poses) : 0;
        if (!take(std::move(attempt), scorePx))
            return true;
    }
    return true;
}

bool OtherStarts::tryFingersRoughly(const std::function<bool()>& explained) {
    constexpr float kCellPx = PoseRefiner::kRoughScoreCellPx;
    for (int search = 0; search < kFingerSearches && !explained(); ++search) {
        FitAttempt attempt;
        const double beforePx = m_refiner.silhouetteDifferencePx(m_best.poses, kCellPx);
        double foundPx = beforePx;
        attempt.poses = searchFingers(m_refiner, m_best.poses, foundPx, kCellPx);
        if (foundPx > (1 - kWorthwhileShare) * beforePx)
            return true;
        if (!run(m_phases.fromOtherFingers, attempt))
            return false;
        const double scorePx = m_refiner.silhouetteDifferencePx(attempt.poses);
        if (!take(std::move(attempt), scorePx))
            return true;
    }
    return true;
}

/// Replaces `best` by attempts that explain the masks better, as long as they are left unexplained. False if the fit is
/// over.
bool improve(PoseRefiner& refiner, FitLoop& loop, const BestPhases& phases, const Method& method,
             const HandPoses& start, FitAttempt& best) {
    OtherStarts others(refiner, loop, phases, start, best);
    const std::span<const StartKind> all(kOtherStarts);
    if (!isRelative(method))
        return others.tryStarts(method.best->live ? std::span<const StartKind>(kOtherLiveStarts) : all,
                                [&others] { return others.isExplained(); });
    if (others.isExplained() || others.explainedByNoise()())
        return true;
    const auto search = [&](const auto& stage) { return others.isExplained() || stage(others.explainedByNoise()); };
    const auto fingers = [&](const auto& explained) { return others.tryFingers(explained); };
    const auto roughFingers = [&](const auto& explained) { return others.tryFingersRoughly(explained); };
    if (others.isSystematic())
        return search(roughFingers);
    if (!search([&](const auto& explained) { return others.tryStarts(all.first(1), explained); }))
        return false;
    if (others.isSystematic())
        return search(roughFingers);
    if (refiner.isNoisy() && others.isOneFinger())
        return search(fingers);
    // Stretched fingers are what helps most often where noisy silhouettes leave much unexplained.
    const std::size_t before = refiner.isNoisy() ? 1 : 0;
    const auto stretched = [&](const auto& explained) { return others.tryStarts(all.subspan(1, before), explained); };
    const auto rest = [&](const auto& explained) { return others.tryStarts(all.subspan(1 + before), explained); };
    return search(stretched) && search(fingers) && search(rest) && search(fingers);
}

/// What the iterations on the full mesh share: matches that are far off for the noise of the contours count less.
IterationSettings polishSettings(PoseRefiner& refiner, const Method& method, const HandPoses& poses) {
    const IterationSettings settings = baseSettings(method);
    return isRelative(method) ? settledOn(settings, refiner.contourNoise(poses).px) : settings;
}

} // namespace

FitAttempt fitBest(PoseRefiner& refiner, const Method& method, const HandPoses& start, std::stop_token stop,
                   const FitProgress& progress) {
    const BestOptions& options = *method.best;
    const BestPhases phases = bestPhases(options, refiner.isNoisy());
    const int expected = mostIterations(phases.main) + mostIterations(phases.polish);
    FitLoop loop(refiner, baseSettings(method), std::move(stop), progress, expected);
    FitAttempt attempt;
    attempt.poses = start;
    if (loop.runAndCutSleeves(phases.main, attempt) &&
        (!refiner.updateForearms(attempt.poses) || loop.run(std::span(phases.main).last(1), attempt)) &&
        (!options.restarts || improve(refiner, loop, phases, method, start, attempt))) {
        loop.setBase(polishSettings(refiner, method, attempt.poses));
        loop.run(phases.polish, attempt);
    }
    return attempt;
}

} // namespace core
