// SPDX-License-Identifier: MIT
#include "core/fitting/pose_estimator.h"

#include <algorithm>
#include <string>

#include "core/error.h"
#include "core/fitting/best_fit.h"
#include "core/fitting/fit_target.h"
#include "core/fitting/pose_refiner.h"
#include "core/fitting/stopwatch.h"

namespace core {

namespace {

constexpr int kRigidIterations = 14;     ///< of the first phase of the default schedule
constexpr int kFullDetailIterations = 5; ///< of the default schedule use the full mesh; those before, coarser levels
constexpr double kSettledShare =
    0.6; ///< of the iterations, after which the default schedule narrows the gate of Quant and Quant2
constexpr float kNarrowGatePx = 12;
constexpr double kConvergedMm = 0.01; ///< mean joint displacement of a step below which a phase ends

void checkInput(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                const std::vector<cv::Mat>& masks, const HandPoses& start) {
    if (masks.size() != cameras.size()) {
        throw Error(ErrorCode::BadInput, "", "masks",
                    "there are " + std::to_string(masks.size()) + " for " + std::to_string(cameras.size()) +
                        " cameras");
    }
    for (std::size_t c = 0; c < cameras.size(); ++c) {
        const bool fits = masks[c].type() == CV_8U && masks[c].cols == cameras[c].size.width &&
                          masks[c].rows == cameras[c].size.height;
        if (!masks[c].empty() && !fits) {
            throw Error(ErrorCode::BadInput, "", "mask of " + cameras[c].name,
                        "must be an 8-bit image of the camera's size");
        }
    }
    if (start.size() != hands.size()) {
        throw Error(ErrorCode::BadInput, "", "start", "must hold one pose per hand");
    }
    for (std::size_t h = 0; h < hands.size(); ++h) {
        if (start[h].size() != hands[h].skeleton.poseSize() || !start[h].allFinite()) {
            throw Error(ErrorCode::BadInput, "", "start", "pose " + std::to_string(h) + " does not fit its hand");
        }
    }
}

FitTargetOptions targetOptions(const Method& method, const MatchRule& rule) {
    FitTargetOptions options;
    options.contour.normals = method.chordTangent ? ContourNormals::Chord : ContourNormals::Polygon;
    options.contour.polygonEpsilonPx = method.polygonEpsilonPx;
    options.bins = rule.bins;
    options.wholePixels = rule.wholePixels;
    if (method.kind == MethodKind::DchDt3 && method.backend == Dt3Backend::Tensor) {
        options.tensorLambdaPxPerRad = method.lambdaPxPerRad;
    }
    return options;
}

/// The paper's loop; with the default schedule its first iterations move each hand as a whole.
FitAttempt runPaperMethod(PoseRefiner& refiner, const Method& method, const MatchRule& rule, const HandPoses& start,
                          std::stop_token stop, const FitProgress& progress) {
    const bool rigidFirst = method.schedule == Schedule::RigidFirst;
    const bool gated = method.kind == MethodKind::DchQuant || method.kind == MethodKind::DchQuant2;
    FitLoop loop(refiner, stop, progress, method.maxIterations);
    FitAttempt attempt;
    attempt.poses = start;
    IterationSettings settings;
    settings.rule = rule;
    settings.damping = method.damping;
    settings.rigidOnly = rigidFirst;
    for (int i = 0; i < method.maxIterations; ++i) {
        settings.rigidOnly = settings.rigidOnly && i < kRigidIterations;
        if (rigidFirst) {
            const bool last = i >= method.maxIterations - kFullDetailIterations;
            settings.detail = settings.rigidOnly ? Detail::Coarse : last ? Detail::Full : Detail::Medium;
        }
        if (rigidFirst && gated && i >= kSettledShare * method.maxIterations) {
            settings.rule.gatePx = std::min(rule.gatePx, kNarrowGatePx);
        }
        const FitLoop::Outcome outcome = loop.iterate(attempt, settings, kConvergedMm);
        if (outcome == FitLoop::Outcome::Over) {
            return attempt;
        }
        if (outcome == FitLoop::Outcome::Settled && !settings.rigidOnly) {
            attempt.termination = FitTermination::Converged;
            return attempt;
        }
        if (outcome == FitLoop::Outcome::Settled) {
            settings.rigidOnly = false;
        }
    }
    return attempt;
}

} // namespace

std::string_view terminationName(FitTermination termination) {
    switch (termination) {
    case FitTermination::Converged:
        return "converged";
    case FitTermination::MaxIterations:
        return "max_iterations";
    case FitTermination::NoMatches:
        return "no_matches";
    case FitTermination::Stopped:
        return "stopped";
    }
    return "";
}

struct PoseEstimator::Impl {
    FittingHands hands;
    std::vector<Camera> cameras;
};

PoseEstimator::PoseEstimator(std::vector<HandModel> hands, std::vector<Camera> cameras)
    : m_impl(std::make_unique<Impl>(Impl{makeFittingHands(std::move(hands)), std::move(cameras)})) {}
PoseEstimator::~PoseEstimator() = default;
PoseEstimator::PoseEstimator(PoseEstimator&&) noexcept = default;
PoseEstimator& PoseEstimator::operator=(PoseEstimator&&) noexcept = default;

FitResult PoseEstimator::fit(const std::vector<cv::Mat>& masks, const HandPoses& start, const Method& method,
                             std::stop_token stop, const FitProgress& progress, int threads) const {
    checkInput(m_impl->hands.models, m_impl->cameras, masks, start);
    const Stopwatch total;
    FitResult result;
    result.poses = start;
    const MatchRule rule = matchRule(method);
    const std::vector<CameraTarget> targets =
        makeFitTargets(m_impl->cameras, masks, targetOptions(method, rule), threads);
    for (const CameraTarget& target : targets) {
        result.profile.contours += target.secondsContour;
        result.profile.transforms += target.secondsTransform;
    }
    PoseRefiner refiner(m_impl->hands, m_impl->cameras, targets, start, threads, result.profile);
    if (targets.empty()) {
        result.termination = FitTermination::NoMatches;
    } else {
        FitAttempt attempt = method.kind == MethodKind::Best
                                 ? fitBest(refiner, method, start, stop, progress)
                                 : runPaperMethod(refiner, method, rule, start, stop, progress);
        result.poses = std::move(attempt.poses);
        result.history = std::move(attempt.history);
        result.termination = attempt.termination;
    }
    result.seconds = total.seconds();
    return result;
}

} // namespace core
