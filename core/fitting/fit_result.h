// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/fitting/fit_trace.h"
#include "core/hand/hand_model.h"

namespace core {

/// Raised whenever a change makes fits end in other poses: results of different revisions are never mixed in one
/// folder.
inline constexpr int kEstimatorRevision = 6;

enum class FitTermination {
    Converged,     ///< the last step was below the phase's limit
    MaxIterations, ///< the iterations of the last phase were used up
    NoMatches,     ///< no rim point has a match: nothing to minimise
    Stopped        ///< the caller asked for it
};
/// "converged", "max_iterations", "no_matches", "stopped"
std::string_view terminationName(FitTermination termination);

/// One iteration of a fit, as the solver saw it.
struct FitIteration {
    int iteration = 0;
    double costMm2 = 0; ///< 1 / (2 N) sum of squared vertex-to-ray distances over the kept matches, before the step
    int matches = 0;    ///< kept
    int rejected = 0;
    double stepMm = 0;      ///< mean joint displacement of the step
    bool rigidOnly = false; ///< only the six rigid degrees of freedom of each hand moved
    int level = 0;          ///< of detail of the hands' surfaces, 0 is the coarsest
    HandPoses poses;        ///< after the step
    /// What the step was solved from, at the pose before it; null unless the fit records its matches.
    std::shared_ptr<const IterationMatches> matchRecords;
};

/// Seconds per stage of one fit, over all its threads.
struct FitProfile {
    double contours = 0;   ///< from masks to oriented contours
    double transforms = 0; ///< rays, search structures and distance transforms of the contours
    double skinning = 0;
    double rims = 0;
    double matching = 0;
    double solving = 0;
    double scoring = 0;
};

/// What hands of another size and cameras whose pictures are shifted would change, if both were free: estimated from
/// the residuals of a fit. Large where the models are not the person's hands, or the calibration not the cameras'.
struct SystematicPart {
    double scale = 1;   ///< of the hands
    double girthMm = 0; ///< along the normals
    double shiftPx = 0; ///< root mean square over the cameras
    double jointMm = 0; ///< mean movement of the fingers' joints
};

/// How far a fit can be trusted, from what its pose leaves unexplained (core/fitting/fit_confidence.h).
struct FitConfidence {
    std::vector<std::vector<Eigen::Matrix3d>> jointCovarianceMm2; ///< per hand and bone, of the joint in the world
    double sigmaPx = 0;         ///< robust scale of the distances between rim and contour, across the outline
    double overlap = 0;         ///< intersection over union of drawn and observed silhouettes, over all cameras
    double deepPx = 0;          ///< silhouettes' difference beyond the noise, per length of the outlines
    double unmatchedShare = 0;  ///< of the rim points
    double rivalMm = 0;         ///< how far another attempt lies that explains the silhouettes nearly as well
    double pointsPerSample = 1; ///< rim points that count as one independent measurement
    SystematicPart systematic;
    double doubt = 1; ///< 0 sure .. 1 lost; below kTrustedDoubt the fit may be trusted
};
/// Fits with less doubt may be trusted; what that was measured on stands in docs/method.md, "Doubt".
inline constexpr double kTrustedDoubt = 0.5;

struct FitResult {
    HandPoses poses;
    std::vector<FitIteration> history;
    FitTermination termination = FitTermination::Converged;
    double seconds = 0; ///< from masks in memory to the final pose
    FitProfile profile;
    std::shared_ptr<const FitTrace> trace;   ///< null unless the fit records its matches
    std::optional<FitConfidence> confidence; ///< if asked for; not there without matches, nor in the real-time variant
};

/// What a fit returns beyond its poses; poses, counts and seconds are the same with and without.
struct FitExtras {
    bool matches = false;    ///< FitResult::trace and the iterations' matches: 32 bytes per rim point and camera
    bool confidence = false; ///< FitResult::confidence
};

/// Called after every iteration with its number and the most there can be.
using FitProgress = std::function<void(int iteration, int maxIterations)>;

} // namespace core
