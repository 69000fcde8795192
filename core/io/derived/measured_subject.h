// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/io/dataset/dataset.h"
#include "core/rig/rig_health.h"
#include "core/subject/subject_estimate.h"

namespace core {

/// From which annotations of a dataset a person's hands are to be measured.
struct SubjectRequest {
    std::vector<std::string> sequences;
    std::string rater;         ///< whose marks; empty: in every sequence those of the one with most joints
    bool withoutMasks = false; ///< joints only: scale and lengths, the model's girth
    /// More frames bring little and cost much: the unknowns of all poses are solved together. Evenly drawn.
    int mostFrames = 15;
};

/// A frame whose annotated joints took part.
struct SubjectFrameName {
    std::string sequence;
    int frame = 0;
};

struct MeasuredSubject {
    SubjectResult result;
    Dataset dataset;                      ///< the original with the person's hands, its cameras in mm
    std::vector<SubjectFrameName> frames; ///< that were used
    int annotatedFrames = 0;              ///< that could have been used
    double unitMm = 1;                    ///< of the original's calibration, as the hands tell it
    bool isUnitKnown = true;              ///< false: it follows from the model's size, so that scale says nothing
    RigHealth rigHealth;                  ///< of the original's calibration, by all of its clicks
};

/// What is being done, for progress.
enum class SubjectStage { ReadingAnnotations, ReadingMasks, Measuring };
/// `fraction` is that of the stage, in [0, 1]; below 0 where it is unknown.
using SubjectProgress = std::function<void(SubjectStage stage, double fraction)>;

/// Measures a person's hands from a dataset's annotated frames and, where there are any, the masks of these frames.
/// Brings the cameras to mm first if the hands say that they are not. Throws Error naming the dataset if it has no
/// hands or too few frames are annotated; after a stop, result.stopped is true.
MeasuredSubject measureSubject(const Dataset& original, const SubjectRequest& request,
                               const SubjectProgress& progress = {}, std::stop_token stop = {});

/// How many annotated frames of a sequence a measurement could use. Throws Error.
int countSubjectFrames(const Dataset& dataset, const Sequence& sequence, const std::string& rater = {});

} // namespace core
