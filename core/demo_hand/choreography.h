// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/hand/motion.h"

namespace core {

/// One hand at one instant of a choreography, on a stage of its own (mm, y down).
struct HandKey {
    double frame = 0;
    Eigen::Vector3d wristInStage = Eigen::Vector3d::Zero();
    Eigen::Quaterniond stageFromWrist = Eigen::Quaterniond::Identity(); ///< of the wrist's bone
    Eigen::VectorXd anglesRad;                                          ///< one per degree of freedom
};

/// Where the stage stands in the world at one instant.
struct StageKey {
    double frame = 0;
    Eigen::Vector3d stageInWorld = Eigen::Vector3d::Zero();
    Eigen::Vector3d turnRad = Eigen::Vector3d::Zero(); ///< rotation vector
};

/// How near the hands come at one instant.
struct GapKey {
    double frame = 0;
    double gapMm = 0;
};

/// Keeps two hands in touch: along `direction` (from the first hand to the second) they are moved until the room
/// between their skins is the gap, or somewhat more where the movement would not be smooth. The second hand does
/// `secondShare` of the movement, the first one the rest.
struct ContactRule {
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX(); ///< on the stage
    double secondShare = 0.5;
    int smoothFrames = 4; ///< a shift that is needed in one frame begins this many frames before and ends as many after
    std::vector<GapKey> gaps;
};

/// Key poses of two hands that play together, and how they are tied. Between keys every value follows a monotone cubic,
/// so nothing overshoots a key and angles that are within their limits at the keys stay there.
struct Choreography {
    std::string name;
    int frameCount = 0;
    std::vector<std::vector<HandKey>> keys; ///< per hand, frames ascending
    std::vector<StageKey> stage;
    std::optional<ContactRule> contact;
};

/// The poses of all hands in every frame.
Motion play(const Choreography& choreography, const std::vector<HandModel>& hands);

} // namespace core
