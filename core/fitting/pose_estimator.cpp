// SPDX-License-Identifier: MIT
#include "core/fitting/pose_estimator.h"

#include <string>

#include "core/error.h"
#include "core/fitting/best_fit.h"
#include "core/fitting/fit_confidence.h"
#include "core/fitting/fit_loop.h"
#include "core/fitting/fit_target.h"
#include "core/fitting/phases.h"
#include "core/fitting/pose_refiner.h"
#include "core/fitting/stopwatch.h"

namespace core {

namespace {

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
    if (start.size() != hands.size())
        throw Error(ErrorCode::BadInput, "", "start", "must hold one pose per hand");
    for (std::size_t h = 0; h < hands.size(); ++h)
        if (start[h].size() != hands[h].skeleton.poseSize() || !start[h].allFinite())
            throw Error(ErrorCode::BadInput, "", "start", "pose " + std::to_string(h) + " does not fit its hand");
}

FitTargetOptions targetOptions(const Method& method, const MatchRule& rule) {
    FitTargetOptions options;
    options.contour.normals = method.chordTangent ? ContourNormals::Chord : ContourNormals::Polygon;
    options.contour.polygonEpsilonPx = method.polygonEpsilonPx;
    options.bins = rule.bins;
    options.wholePixels = rule.wholePixels;
    options.withoutSpecks = method.noise && !(method.best && method.best->live);
    if (traitsOf(method.distance).isOriented && method.backend == Dt3Backend::Tensor)
        options.tensorLambdaPxPerRad = method.lambdaPxPerRad;
    return options;
}

/// Where the masks are speckled, their outlines are noisy: all distances alike get the prior on the angles and, in the
/// last iterations, the weights of `best`, and end when steps are small for it. Else the method is the paper's.
FitAttempt fitPaperMethod(PoseRefiner& refiner, const Method& method, const MatchRule& rule, const HandPoses& start,
                          std::stop_token stop, const FitProgress& progress) {
    IterationSettings settings;
    settings.rule = rule;
    settings.damping = method.damping;
    settings.motionPrior = refiner.isNoisy() ? kMotionPrior : 0;
    FitLoop loop(refiner, settings, std::move(stop), progress, method.maxIterations);
    FitAttempt attempt;
    attempt.poses = start;
    if (!refiner.isNoisy()) {
        loop.runAndCutSleeves(schedulePhases(method), attempt);
        return attempt;
    }
    const std::vector<Phase> phases = noisyPhases(method);
    const auto last = std::prev(phases.end());
    if (loop.runAndCutSleeves({phases.begin(), last}, attempt)) {
        loop.setBase(settledOn(settings, refiner.contourNoise(attempt.poses).px));
        loop.run({last, phases.end()}, attempt);
    }
    return attempt;
}

} // namespace

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
                             std::stop_token stop, const FitProgress& progress, int threads, const FitExtras& extras,
                             const KnownJoints& known) const {
    checkInput(m_impl->hands.models, m_impl->cameras, masks, start);
    const Stopwatch total;
    FitResult result;
    const MatchRule rule = matchRule(method);
    auto trace = std::make_shared<FitTrace>();
    trace->targets = makeFitTargets(m_impl->cameras, masks, targetOptions(method, rule), threads);
    const std::vector<CameraTarget>& targets = trace->targets;
    for (const CameraTarget& target : targets) {
        result.profile.contours += target.secondsContour;
        result.profile.transforms += target.secondsTransform;
    }
    PoseRefiner refiner(m_impl->hands, m_impl->cameras, targets, start, threads, result.profile);
    refiner.recordMatches(extras.matches);
    refiner.pullTo(known);
    if (method.forearm == Forearm::Cut)
        refiner.cutForearms(start);
    FitAttempt attempt;
    attempt.poses = start;
    attempt.termination = FitTermination::NoMatches;
    if (!targets.empty())
        attempt = method.best ? fitBest(refiner, method, start, std::move(stop), progress)
                              : fitPaperMethod(refiner, method, rule, start, std::move(stop), progress);
    result.seconds = total.seconds();
    const bool isOver =
        attempt.termination == FitTermination::Stopped || attempt.termination == FitTermination::NoMatches;
    if (extras.confidence && !isOver && !(method.best && method.best->live))
        result.confidence = judgeFit(refiner, start, attempt.poses, attempt.rivalMm);
    result.poses = std::move(attempt.poses);
    result.history = std::move(attempt.history);
    result.termination = attempt.termination;
    if (extras.matches) {
        trace->finalMatches = refiner.matchesAt(result.poses);
        trace->forearms = refiner.forearms().cuts();
        result.trace = std::move(trace);
    }
    return result;
}

} // namespace core
