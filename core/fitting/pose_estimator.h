// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/fitting/fit_result.h"
#include "core/fitting/joint_problem.h"
#include "core/fitting/method.h"
#include "core/geometry/camera.h"
#include "core/hand/hand_model.h"

namespace core {

/// Estimates the pose of the hands from silhouettes. Prepares coarser levels of the hands once; fit() may then be
/// called from several threads at once. The result does not depend on `threads`.
class PoseEstimator {
public:
    PoseEstimator(std::vector<HandModel> hands, std::vector<Camera> cameras);
    ~PoseEstimator();
    PoseEstimator(PoseEstimator&&) noexcept;
    PoseEstimator& operator=(PoseEstimator&&) noexcept;

    /// masks: one per camera, CV_8U of the camera's size, 0 = background; an empty Mat leaves that camera out.
    /// start: one pose per hand. known: joints that are known beside the masks, mm; the covariances and the doubt of
    /// the result count them, too. Throws Error(BadInput) if the sizes do not agree.
    FitResult fit(const std::vector<cv::Mat>& masks, const HandPoses& start, const Method& method,
                  std::stop_token stop = {}, const FitProgress& progress = {}, int threads = 1,
                  const FitExtras& extras = {}, const KnownJoints& known = {}) const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace core
