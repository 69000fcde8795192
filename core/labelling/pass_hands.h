// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <stop_token>
#include <vector>

#include "core/labelling/frame_fitter.h"
#include "core/labelling/hand_assignment.h"
#include "core/subject/subject_measures.h"

namespace core {

/// Median over all bones of how much longer the landmarks have them than the models; 0 if nothing was detected.
double landmarksOverModelLength(const std::vector<HandModel>& hands, const std::map<int, HandDetections>& detected);

/// The models scaled about their centres, weights and degrees of freedom as they are.
std::vector<HandModel> scaledHands(const std::vector<HandModel>& hands, double scale);

/// A frame that a person's hands are measured from.
struct MeasuredFrame {
    HandPoses poses;            ///< that explain the silhouettes; empty poses: hands that are not there
    std::vector<cv::Mat> masks; ///< per camera
};

/// This person's hands from silhouettes and roughly known poses (estimateSubject): the models' joints hold the hands in
/// place only weakly, their outlines decide.
std::vector<SubjectHand> measureHands(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                                      const std::vector<MeasuredFrame>& frames, std::stop_token stop);

/// This person's hands from landmarks alone, which are taken for the joints: scale, bone lengths and where
/// the palm has its joints (withPalmOf), of at most `mostFrames` frames, evenly drawn. Empty if nothing was detected.
std::vector<SubjectHand> measureLandmarks(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                                          const std::map<int, HandDetections>& detected, std::size_t mostFrames,
                                          const LandmarkFitOptions& landmarks, std::stop_token stop);

} // namespace core
