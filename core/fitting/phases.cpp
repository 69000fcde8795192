// SPDX-License-Identifier: MIT
#include "core/fitting/phases.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core {

namespace {

// Schedule::RigidFirst
constexpr int kRigidIterations = 14;
constexpr int kFullDetailIterations = 5;
constexpr double kNarrowGateShare = 0.6; ///< of the iterations, after which the gate of Quant and Quant2 is narrowed
constexpr double kNarrowGatePx = 12;

/// Cuts every phase in two at that iteration of the attempt; the second part has a narrower gate.
std::vector<Phase> withNarrowGateFrom(int iteration, const std::vector<Phase>& phases) {
    std::vector<Phase> cut;
    for (const Phase& phase : phases) {
        Phase wide = phase, narrow = phase;
        wide.until = std::min(phase.until, iteration);
        narrow.gatePx = kNarrowGatePx;
        cut.insert(cut.end(), {wide, narrow});
    }
    return cut;
}

constexpr double kNoisySettledMm = 0.1;

/// The prior's weight for a standard deviation of 1 px, and the least that counts.
constexpr double kMotionPriorPerNoise = 0.003;
constexpr double kLeastMotionNoisePx = 0.5;
/// Cauchy scale of the last iterations in standard deviations of the contour's noise, which is taken to be at least so
/// much.
constexpr double kRobustPerNoise = 2;
constexpr double kLeastNoisePx = 0.75;

// `best`. The palm first, then the fingers, on the coarse level; the last iterations on the full mesh.
constexpr Phase kPalm{
    .iterations = 8, .settledMm = 0.1, .rigidOnly = true, .detail = Detail::Coarse, .points = 120, .tauDeg = 45};
constexpr Phase kFingers{
    .stage = 1, .iterations = 17, .settledMm = 0.05, .detail = Detail::Coarse, .points = 120, .tauDeg = 45};
constexpr Phase kPolish{
    .stage = 2, .iterations = 4, .settledMm = 0.02, .detail = Detail::Full, .points = 300, .tauDeg = 22.5};

// Further attempts where the outlines are left unexplained. Fingers keep apart there: two in one outline is what lost
// fits have in common.
constexpr double kApart = 0.3; ///< mm^2 per mm^2 of squared depth and correspondence
constexpr Phase kLongPalm{
    .iterations = 16, .settledMm = 0.1, .rigidOnly = true, .detail = Detail::Coarse, .points = 120, .tauDeg = 90};
constexpr Phase kWideFingers{
    .iterations = 25, .settledMm = 0.05, .detail = Detail::Coarse, .points = 200, .tauDeg = 90};
constexpr Phase kNarrowFingers{
    .stage = 1, .iterations = 25, .settledMm = 0.05, .detail = Detail::Coarse, .points = 200, .tauDeg = 22.5};

constexpr Phase kLivePalm{
    .iterations = 4, .settledMm = 0.2, .rigidOnly = true, .detail = Detail::Coarse, .points = 100, .tauDeg = 45};
constexpr Phase kLiveFingers{
    .stage = 1, .iterations = 7, .settledMm = 0.1, .detail = Detail::Coarse, .points = 100, .tauDeg = 45};
constexpr Phase kLivePolish{
    .stage = 2, .iterations = 1, .settledMm = 0, .detail = Detail::Medium, .points = 150, .tauDeg = 22.5};

constexpr double kNarrowTauDeg = 22.5;

std::vector<Phase> withOptions(const BestOptions& options, bool isNoisy, std::vector<Phase> phases) {
    for (Phase& phase : phases) {
        phase.settledMm = isNoisy ? std::max(phase.settledMm, kNoisySettledMm) : phase.settledMm;
        phase.tauDeg = options.wide ? phase.tauDeg : kNarrowTauDeg;
        phase.detail = options.coarse ? phase.detail : Detail::Full;
        phase.contourPoints = options.bothWays ? phase.points : 0;
        phase.rigidOnly = phase.rigidOnly && options.palm;
    }
    return phases;
}

} // namespace

IterationSettings settingsOf(const Phase& phase, const IterationSettings& base) {
    IterationSettings settings = base;
    settings.rigidOnly = phase.rigidOnly;
    settings.detail = phase.detail;
    settings.pointsPerCamera = phase.points;
    settings.contourPointsPerCamera = phase.contourPoints;
    settings.overlapWeight = phase.overlapWeight;
    if (phase.tauDeg >= 0)
        settings.rule.tauRad = static_cast<float>(phase.tauDeg * std::numbers::pi / 180);
    settings.rule.gatePx = std::min(base.rule.gatePx, static_cast<float>(phase.gatePx));
    return settings;
}

std::vector<Phase> schedulePhases(const Method& method) {
    const int last = method.maxIterations;
    if (method.schedule == Schedule::Paper)
        return {Phase{.until = last}};
    const std::vector<Phase> phases{
        Phase{.until = std::min(kRigidIterations, last), .rigidOnly = true, .detail = Detail::Coarse},
        Phase{.stage = 1, .until = last - kFullDetailIterations, .detail = Detail::Medium},
        Phase{.stage = 1, .until = last, .detail = Detail::Full}};
    const bool isGated = traitsOf(method.distance).bins > 0;
    return isGated ? withNarrowGateFrom(static_cast<int>(std::ceil(kNarrowGateShare * last)), phases) : phases;
}

std::vector<Phase> noisyPhases(const Method& method) {
    std::vector<Phase> phases = schedulePhases(method);
    if (method.schedule == Schedule::Paper) {
        phases.front().until -= kFullDetailIterations;
        phases.push_back({.until = method.maxIterations});
    }
    for (Phase& phase : phases)
        phase.settledMm = kNoisySettledMm;
    phases.back().stage = 2;
    phases.back().iterations = kFullDetailIterations;
    return phases;
}

IterationSettings settledOn(IterationSettings settings, double noisePx) {
    settings.robustPx = kRobustPerNoise * std::max(kLeastNoisePx, noisePx);
    if (settings.motionPrior > 0)
        settings.motionPrior = kMotionPriorPerNoise * std::pow(std::max(kLeastMotionNoisePx, noisePx), 2);
    return settings;
}

BestPhases bestPhases(const BestOptions& options, bool isNoisy) {
    const auto made = [&](std::vector<Phase> phases) { return withOptions(options, isNoisy, std::move(phases)); };
    BestPhases phases;
    phases.main = made(options.live ? std::vector{kLivePalm, kLiveFingers} : std::vector{kPalm, kFingers});
    phases.again = made({kLongPalm, kNarrowFingers});
    phases.fromOtherFingers = made({kWideFingers, kNarrowFingers});
    // Where silhouettes are exact they alone tell starts apart, and hands that touch lie a little inside each other.
    if (options.apart && isNoisy && !options.live) {
        for (std::vector<Phase>* attempt : {&phases.again, &phases.fromOtherFingers})
            for (Phase& phase : *attempt)
                phase.overlapWeight = kApart;
    }
    if (options.polish)
        phases.polish = made({options.live ? kLivePolish : kPolish});
    return phases;
}

int mostIterations(const std::vector<Phase>& phases) {
    int most = 0;
    for (const Phase& phase : phases)
        most = phase.iterations == Phase::kNoLimit ? std::max(most, phase.until) : most + phase.iterations;
    return most;
}

} // namespace core
