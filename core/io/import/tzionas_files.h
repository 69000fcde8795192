// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/hand/hand_model.h"

namespace core {

/// The text files of the method's authors (SKEL, SKIN, LIMITS, MOTION). Every reader throws Error naming file and line.

/// SKEL: bones under their own names (`Lower Arm L`), parents before children, lengths in mm; rest poses are not in
/// this file.
struct SkelFile {
    int motionFrames = 0; ///< including the rigging frame
    std::vector<Bone> bones;
};
SkelFile readSkel(const std::filesystem::path& file);

/// SKIN: weights per vertex, renormalised. A row's sum must be within 0.99 and 1.01.
SkinWeights readSkin(const std::filesystem::path& file, const std::vector<Bone>& bones, std::size_t vertexCount);

/// LIMITS: one-axis rotations of every bone but the root; an axis counts if its flag is 1 and its limits are not both
/// 0. Bones are indices into `bones`, the list is ordered by them; axes X, Y, Z of a bone keep that order.
std::vector<DegreeOfFreedom> readLimits(const std::filesystem::path& file, const std::vector<Bone>& bones);

/// MOTION: worldFromBone of every bone, [frame][bone]; frame 0 is the rigging pose. Rotations are made orthonormal.
std::vector<std::vector<RigidMotion>> readMotionTable(const std::filesystem::path& file, const std::vector<Bone>& bones,
                                                      int frames);

/// `Lower Arm L` -> forearm, `LFing.3_0` -> index_mcp, ...; empty if the name is not one of theirs.
std::optional<std::string> standardJointName(std::string_view boneName);

} // namespace core
