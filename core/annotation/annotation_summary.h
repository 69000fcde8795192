// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/annotation/click_sigmas.h"
#include "core/annotation/quality.h"
#include "core/annotation/raters.h"
#include "core/annotation/reconstruction.h"
#include "core/hand/hand_model.h"

namespace core {

/// How well one joint is annotated, over all frames and raters that have a point of it.
struct JointSummary {
    JointId joint;
    int points = 0;
    double meanRmsPx = 0;   ///< reprojection error over the views used
    double meanSigmaMm = 0; ///< expected distance from the true place
    int outliers = 0;       ///< clicks that disagree with the others
};

/// What one rater has done.
struct RaterSummary {
    std::string rater;
    int frames = 0;                       ///< with marks; proposals are none
    int clicks = 0;                       ///< placed by hand
    int accepted = 0;                     ///< accepted reprojections
    HandCoverage joints;                  ///< over both hands and all frames
    std::map<int, int> doneByFrame;       ///< finished joints of both hands, for frames with marks
    std::optional<RaterSigma> sigma;      ///< what the dataset's sigmas say of the clicks; no value without them
    std::vector<QualityFinding> findings; ///< by frame
};

/// All that a report says of one sequence: plain data.
struct AnnotationSummary {
    std::string sequence;
    int frameCount = 0;
    std::vector<RaterSummary> raters; ///< with settled marks, ascending by name; repeat rounds ("ann (again)") too
    std::vector<JointSummary> joints; ///< the most uncertain one first
    std::vector<double> rmsPx;        ///< of every point
    std::vector<double> sigmaMm;      ///< parallel to it
    std::vector<RaterComparison> agreement; ///< of every pair of raters that share something

    int proposals = 0; ///< marks that have not been checked yet

    bool empty() const { return raters.empty(); }
};

/// Looks at everything that was annotated in a sequence. A joint counts as bad above `badRmsPx`. What is there when
/// `stop` is requested is returned. With `sigmas` each rater's clicks count by them.
AnnotationSummary summariseAnnotations(const std::string& sequence, int frameCount, const AnnotationSet& set,
                                       const std::vector<Camera>& cameras, const std::vector<HandModel>& hands,
                                       double badRmsPx = 2, const QualityOptions& options = {},
                                       std::stop_token stop = {}, const PictureGaps& gaps = {},
                                       const std::optional<ClickSigmas>& sigmas = {});

} // namespace core
