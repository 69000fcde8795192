// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/hand/hand_model.h"
#include "core/segmentation/cleaning.h"
#include "core/segmentation/hand_in_view.h"
#include "core/segmentation/seeds.h"
#include "core/segmentation/segmentation_method.h"

namespace core {

struct SilhouetteOptions {
    SegmentationMethod method = SegmentationMethod::Model;
    double bandMm = 6;                   ///< model: by which the pose may be wrong
    double forearmPalms = kForearmPalms; ///< all but model: how much of a forearm is kept, palms from the wrist, 0..1.2
    std::optional<cv::Scalar> backdrop;  ///< chroma: its colour, BGR; without one that of the picture's border
    CleaningOptions cleaning;
};

/// What is known of an instant before its pictures are looked at. Landmarks and Model need their own part of it.
struct HandEvidence {
    std::vector<LandmarkPoints> landmarks; ///< per hand; for all methods but Model
    HandPoses poses;                       ///< per hand of the dataset, empty where it is not known; for Model
};

struct Silhouette {
    cv::Mat mask;                  ///< CV_8U of the picture's size, 0 and 255
    std::vector<ForearmLine> cuts; ///< where a forearm ends that goes on in the picture
};

/// The silhouette of the hands in a camera's picture (CV_8UC3 BGR of its size). `background`: the picture without
/// hands, for Background alone. No value if the evidence that the method needs is missing; an empty mask if the hands
/// are outside the picture. Background, Chroma and Skin need no evidence: they find arms and whatever else is there;
/// where landmarks are known, forearms end as with Landmarks, and parts that no hand is in are left out.
std::optional<Silhouette> findSilhouette(const cv::Mat& picture, const Camera& camera,
                                         const std::vector<HandModel>& hands, const HandEvidence& evidence,
                                         const cv::Mat& background, const SilhouetteOptions& options);

/// Silhouettes in the pictures of one instant, per camera (empty where there is none), by posed models that may be
/// wrong by `bandMm`: by OddsCut, a third of the time that Model takes; whether arms are seen is asked of all views
/// together. Views side by side, which changes nothing.
/// Empty poses: hands that are not there. A mask without pixels where no hand is seen.
std::vector<cv::Mat> silhouettesByModel(const std::vector<Camera>& cameras, const std::vector<cv::Mat>& pictures,
                                        const std::vector<HandModel>& hands, const HandPoses& poses,
                                        double bandMm = 18);

/// Intersection over union of two masks of the same size; 1 if both are empty.
double maskOverlap(const cv::Mat& a, const cv::Mat& b);

} // namespace core
