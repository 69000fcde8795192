// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/annotation/edit.h"
#include "core/simulation/simulated_world.h"

namespace core {

/// How a simulated annotator clicks.
struct AnnotatorOptions {
    std::string rater = "sim";
    double noisePx = 1;         ///< standard deviation per axis
    double wrongShare = 0;      ///< of the clicks, 20 to 80 px off
    bool seesOcclusion = false; ///< hidden joints are guessed and marked so, or called unplaceable
    double guessedShare = 0.5;  ///< of the hidden joints
    double guessNoisePx = 2.5;  ///< of what is guessed
};

/// What an annotator did to one frame.
struct SimulatedClicks {
    std::vector<Edit> edits;    ///< one per step of the annotator, as the window makes them
    std::vector<MarkKey> wrong; ///< the clicks that are far off
    int placed = 0;
    int occluded = 0;
    int unplaceable = 0;
};

/// The joints that people can click: knuckles and finger joints, no wrist, no carpal joint and no tip; all joints of a
/// hand that has none of them.
std::vector<JointId> annotatableJoints(const std::vector<HandModel>& hands);

/// Clicks every annotatable joint of the world's hands in every camera, edit by edit (edits.h), and applies the edits
/// to `set`. A joint outside the picture is unplaceable there. The same for the same seed of the world.
SimulatedClicks annotateFrame(AnnotationSet& set, const SimulatedWorld& world, const HandPoses& poses, int frame,
                              const std::string& sequence, const AnnotatorOptions& options);

} // namespace core
