// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/fitting/fit_target.h"
#include "core/subject/subject_measures.h"
#include "core/subject/subject_problem.h"

namespace core {

/// What is known of one frame: per hand the annotated joints (none if the hand is not annotated), and the outlines that
/// cameras saw (none without masks).
struct SubjectFrame {
    std::vector<std::vector<JointTarget>> targets;
    std::vector<CameraTarget> outlines;
};

struct SubjectOptions {
    SubjectPriors priors;
    int framesForLengths = 5;   ///< with fewer frames bones keep the model's proportions
    int framesForGirth = 3;     ///< with fewer frames the girth stays the model's, too
    int pointsPerCamera = 150;  ///< of the rim
    int maxRounds = 15;         ///< of outlines matched again
    double outlineShare = 0.25; ///< how many of the neighbouring points on an outline count as independent
    double fixedShare = 1e-5;   ///< prior of the proportions, and of the girth, where they are kept
    double outlineBiasMm = 0.1; ///< by which all outlines may lie outside or inside: added to the girth's deviation
};

struct SubjectResult {
    std::vector<SubjectHand> hands;
    int frames = 0;            ///< with at least one hand
    int outlineFrames = 0;     ///< of which outlines took part
    double outlineSigmaMm = 0; ///< robust scale of the outlines' residuals
    double modelSigmaMm = 0;   ///< per axis: how far joints are clicked from the model's, as the data say it
    bool lengthsKept = false;  ///< too few frames: only scale and girth
    bool girthKept = false;    ///< still fewer frames: only scale
    bool stopped = false;
};

/// A hand takes part in a frame with at least so many joints that are not on a line.
inline constexpr int kFewestSubjectJoints = 4;
inline constexpr int kFewestSubjectFrames = 1;

/// Median of annotated over model length of all pairs of joints that are ends of one bone; 0 if there are none.
/// Near 1 where the calibration is in mm.
double annotatedOverModelLength(const std::vector<HandModel>& hands, const std::vector<SubjectFrame>& frames);

/// The hands of the person that was annotated: shapes and poses of all frames found together by Levenberg-Marquardt,
/// first from the joints, then, where there are outlines, with the rim of the posed hands matched to them (DCH-Thres)
/// again and again; what lies beyond the wrist takes no part. A hand that is annotated in no frame follows the other
/// one; outlines are used of frames in which every other hand is annotated. How far joints are clicked from where the
/// model has them is estimated: chi^2 of the joints' residuals equals their degrees of freedom.
/// Deterministic. Throws Error(BadInput) in plain words if there are fewer than kFewestSubjectFrames frames.
SubjectResult estimateSubject(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                              const std::vector<SubjectFrame>& frames, const SubjectOptions& options = {},
                              std::stop_token stop = {});

} // namespace core
