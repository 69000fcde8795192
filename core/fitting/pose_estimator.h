// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <string_view>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/fitting/method.h"
#include "core/geometry/camera.h"
#include "core/hand/hand_model.h"

namespace core {

enum class FitTermination { Converged, MaxIterations, NoMatches, Stopped };
std::string_view
terminationName(FitTermination termination); ///< "converged", "max_iterations", "no_matches", "stopped"

/// One iteration of a fit, as the solver saw it.
struct FitIteration {
    int iteration = 0;
    double costMm2 = 0; ///< 1 / (2 N) sum of squared vertex-to-ray distances over the kept matches, before the step
    int matches = 0;    ///< kept
    int rejected = 0;
    double stepMm = 0; ///< mean joint displacement of the step
    HandPoses poses;   ///< after the step
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

struct FitResult {
    HandPoses poses;
    std::vector<FitIteration> history;
    FitTermination termination = FitTermination::Converged;
    double seconds = 0; ///< from masks in memory to the final pose
    FitProfile profile;
};

/// Raised whenever a change makes fits end in other poses: results of different revisions are never mixed in one folder.
inline constexpr int kEstimatorRevision = 1;

/// Called after every iteration with its number and the most there can be.
using FitProgress = std::function<void(int iteration, int maxIterations)>;

/// Estimates the pose of the hands from silhouettes. Prepares coarser levels of the hands once; fit() may then be
/// called from several threads at once. The result does not depend on `threads`.
class PoseEstimator {
public:
    PoseEstimator(std::vector<HandModel> hands, std::vector<Camera> cameras);
    ~PoseEstimator();
    PoseEstimator(PoseEstimator&&) noexcept;
    PoseEstimator& operator=(PoseEstimator&&) noexcept;

    /// masks: one per camera, CV_8U of the camera's size, 0 = background; an empty Mat leaves that camera out.
    /// start: one pose per hand. Throws Error(BadInput) if the sizes do not agree.
    FitResult fit(const std::vector<cv::Mat>& masks, const HandPoses& start, const Method& method,
                  std::stop_token stop = {}, const FitProgress& progress = {}, int threads = 1) const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace core
