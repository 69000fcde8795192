// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <QLineF>
#include <QRectF>
#include <QString>

#include <opencv2/core/mat.hpp>

#include "core/annotation/annotation_set.h"
#include "core/annotation/click_sigmas.h"
#include "core/benchmark/joint_errors.h"
#include "core/io/dataset/dataset.h"

namespace widgets {

/// What the silhouettes of a fit are taken from.
enum class FitTarget {
    Recorded, ///< drawn from the recorded pose of the test frame
    Masks     ///< the sequence's mask files
};

/// Which frame pair to fit with which methods.
struct FitRequest {
    int start = 0;                    ///< frame whose pose the fit starts from
    int test = 0;                     ///< frame whose silhouettes are to be met
    std::vector<std::string> methods; ///< as core::parseMethod reads them
    FitTarget target = FitTarget::Recorded;
};

/// A pair ready to be fitted: where the fit starts, what it is to meet, and what it is measured against.
struct FitPair {
    core::HandPoses startPoses;
    core::HandPoses truePoses;  ///< recorded poses of the test frame; empty if there are none
    std::vector<cv::Mat> masks; ///< target silhouettes, one per camera; empty for cameras without one
    std::vector<QRectF>
        handsPx; ///< where they lie in each camera's image, with some room around; empty where there are none
    std::vector<std::vector<QLineF>> outlinesPx; ///< their outlines, if the target is mask files
    core::JointPositions
        reference;             ///< what errors are measured against: recorded joints, or those marked in the test frame
    double initialErrorMm = 0; ///< mean joint distance of the start pose; NaN without a reference
    double trueErrorMm = 0;    ///< of the recorded pose; NaN without one, or without a reference
};

/// What pairs of one sequence are prepared from. Copied to the worker.
struct FitSource {
    std::shared_ptr<const core::Dataset> dataset;
    core::Sequence sequence;
    std::shared_ptr<const core::Motion> motion; ///< recorded; may be empty
    core::AnnotationSet annotations;            ///< where there is no recorded motion, or targets are mask files
    std::string rater;
    core::ClickSigmas sigmas; ///< what the marks are worth
};

/// Why a pair cannot be prepared.
enum class FitRefusal {
    NoStartPose, ///< no recorded motion, and too few joints are marked in the start frame
    NoTestMasks  ///< no mask file of the test frame
};
/// The reason in the person's language.
QString fitRefusalText(FitRefusal refusal);

/// Starts from the recorded pose or, in a sequence without, from the hand models fitted to the marks of the start
/// frame. Throws core::Error if a mask file cannot be read.
std::variant<FitPair, FitRefusal> prepareFitPair(const FitSource& source, const FitRequest& request);

/// The outlines of a silhouette (CV_8U, 0 = background), in its pixels; none of an empty one.
std::vector<QLineF> outlinesOf(const cv::Mat& mask);

/// Mean distance of the poses' joints to the pair's reference, mm; NaN without one.
double errorAgainst(const FitPair& pair, const core::Dataset& dataset, const core::HandPoses& poses);

} // namespace widgets
