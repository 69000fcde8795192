// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <vector>

#include "core/fitting/method.h"
#include "core/fitting/pose_refiner.h"

namespace core {

/// A run of iterations with the same settings. It ends with the first of: `iterations` of its own, `until` iterations
/// of the whole attempt, or a step that moves the joints by less than `settledMm` on average.
struct Phase {
    static constexpr int kNoLimit = std::numeric_limits<int>::max();
    static constexpr double kTauOfMethod = -1;

    /// Consecutive phases of one stage end together when a step settles: what follows moves the same degrees of
    /// freedom.
    int stage = 0;
    int iterations = kNoLimit;
    int until = kNoLimit;
    double settledMm = 0.01;
    bool rigidOnly = false; ///< only the six rigid degrees of freedom of each hand move
    Detail detail = Detail::Full;
    int points = 300;                                        ///< rim points per camera
    int contourPoints = 0;                                   ///< contour points per camera that pull the rim; 0 = none
    double tauDeg = kTauOfMethod;                            ///< not negative: instead of the method's
    double gatePx = std::numeric_limits<double>::infinity(); ///< a gate above it is narrowed to it
    double overlapWeight = 0;                                ///< IterationSettings::overlapWeight
};

/// How one iteration of a phase is done, given what the method's phases share.
IterationSettings settingsOf(const Phase& phase, const IterationSettings& base);

/// The paper's methods. Schedule::Paper is one phase. Schedule::RigidFirst has three: up to 14 iterations of the rigid
/// degrees of freedom on the coarse level of the mesh, then all of them on the medium level, the last 5 on the full
/// mesh; the last two fifths narrow the gate of Quant and Quant2 to 12 px.
std::vector<Phase> schedulePhases(const Method& method);

/// The same where the outlines are noisy: a phase is settled at steps of 0.1 mm, and the last 5 iterations, on the full
/// mesh, are a stage of their own, to be done with the settings of settledOn.
std::vector<Phase> noisyPhases(const Method& method);

/// How strongly angles are held by what the start's fingers probably do (IterationSettings::motionPrior) while the
/// outlines may still lead astray.
inline constexpr double kMotionPrior = 0.02;
/// Settings of iterations near the end, where the rim lies on contours with that noise: matches that are far off for it
/// count less, and the prior on the angles, if there is one, is what the noise's variance makes of it.
IterationSettings settledOn(IterationSettings settings, double noisePx);

/// The phases of `best`.
struct BestPhases {
    std::vector<Phase> main;             ///< from the start: the palm, then all
    std::vector<Phase> again;            ///< another attempt from the start
    std::vector<Phase> fromOtherFingers; ///< another attempt, from other finger angles
    std::vector<Phase> polish;           ///< on the full mesh; none if the option is off
};
/// isNoisy: steps that noise makes end a phase, as in noisyPhases.
BestPhases bestPhases(const BestOptions& options, bool isNoisy = false);

/// The most iterations that the phases can take.
int mostIterations(const std::vector<Phase>& phases);

} // namespace core
