// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/rig/rig_health.h"

namespace core {

/// What the clicks say of a calibration that a person should know.
enum class RigFindingKind {
    WholeRigOff,         ///< half of the cameras or more are off; value: how many; `judged`, `leastPx`, `mostPx`
    CameraOff,           ///< in every frame; value: px
    CameraOffInSequence, ///< in `sequences` only; value: px there (the mean)
    CameraMoved,         ///< at `frame` of `sequence`; value: px by which its picture moved
    CameraDrifts,        ///< slowly, in `sequence`; value: px in 100 frames
    CameraLate,          ///< value: frames that its picture lies behind the others' (ahead if negative)
    CameraUnknown        ///< too few clicks that others confirm; value: clicks
};

/// One of them: kind and data; the words are made where they are shown.
struct RigFinding {
    RigFindingKind kind = RigFindingKind::CameraOff;
    int camera = -1; ///< index into RigHealth::cameras; -1: the rig as a whole
    double value = 0;
    int sequence = -1; ///< as the clicks number it; -1: all
    int frame = -1;    ///< the first annotated frame after a camera moved
    std::vector<int> sequences{};
    int judged = 0;                 ///< cameras that could be judged
    double leastPx = 0, mostPx = 0; ///< of the cameras that are off
    bool operator==(const RigFinding&) const = default;
};

/// All findings, the rig as a whole first, then the cameras in order, what cannot be known last. Empty if all is well.
std::vector<RigFinding> findRigFaults(const RigHealth& health);

/// True for findings of cameras that are off by some pixels, always or in some sequences.
bool isOffFinding(RigFindingKind kind);

/// A sentence per finding, in English: "cam5 is 9.1 px off in every frame: its calibration moved". A rig that is off as
/// a whole is one sentence, without one for each of its cameras, and so is what cannot be known. `sequences` holds the
/// sequences' names.
std::vector<std::string> rigFindings(const RigHealth& health, const std::vector<std::string>& sequences = {});

} // namespace core
