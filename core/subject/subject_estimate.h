// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/fitting/fit_target.h"
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
    int pointsPerCamera = 150;  ///< of the rim
    int maxRounds = 15;         ///< of outlines matched again
    double outlineShare = 0.25; ///< how many of the neighbouring points on an outline count as independent
    double fixedShare = 1e-5;   ///< prior of the proportions where they are kept
};

/// A length of the hand and what became of it.
struct SubjectBone {
    std::string from, to; ///< joints; `to` is "tip" behind the last joint
    double modelMm = 0;
    double lengthMm = 0;
    double sigmaMm = 0; ///< standard deviation of lengthMm
};

/// A number and its standard deviation.
struct Measured {
    double value = 0;
    double sigma = 0;
};

struct SubjectHand {
    HandModel hand;
    HandShape shape;
    Measured scale;   ///< mean length of the bones over the model's
    Measured girthMm; ///< mean offset of the surface along its normals; before the scale
    std::vector<SubjectBone> bones;
    int frames = 0;        ///< in which it is annotated
    double jointRmsMm = 0; ///< of the annotated joints to those of the hand
};

struct SubjectResult {
    std::vector<SubjectHand> hands;
    int frames = 0;            ///< with at least one hand
    int outlineFrames = 0;     ///< of which outlines took part
    double outlineSigmaMm = 0; ///< robust scale of the outlines' residuals
    bool lengthsKept = false;  ///< too few frames: only scale and girth
    bool stopped = false;
};

/// A hand takes part in a frame with at least so many joints that are not on a line.
inline constexpr int kFewestSubjectJoints = 4;
inline constexpr int kFewestSubjectFrames = 3;

/// Median of annotated over model length of all pairs of joints that are ends of one bone; 0 if there are none.
/// Near 1 where the calibration is in mm.
double annotatedOverModelLength(const std::vector<HandModel>& hands, const std::vector<SubjectFrame>& frames);

/// The hands of the person that was annotated: shapes and poses of all frames found together by Levenberg-Marquardt,
/// first from the joints, then, where there are outlines of frames in which all hands are annotated, with the rim of
/// the posed hands matched to them (DCH-Thres) again and again; what lies beyond the wrist takes no part.
/// Deterministic. Throws Error(BadInput) in plain words if there are fewer than kFewestSubjectFrames frames.
SubjectResult estimateSubject(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                              const std::vector<SubjectFrame>& frames, const SubjectOptions& options = {},
                              std::stop_token stop = {});

} // namespace core
