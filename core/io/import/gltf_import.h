// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/hand/rig.h"
#include "core/io/dataset/ring_views.h"

namespace core {

/// A hand out of a skinned glTF file: the rig's joints are found by their names, their frames are turned into
/// anatomical ones, their hierarchy is the rig's (the file's may be flat). Weights of other joints go to the nearest
/// joint of the rig above them; parts of the surface that hang on no joint of the rig are left out. Split vertices are
/// joined and simple holes closed. Throws Error naming the file and the joint or field: a joint that is missing, joint
/// axes that do not point along the bones, a file of the other hand.
HandModel readGltfHand(const std::filesystem::path& file, const Rig& rig, Side side);

/// Two hands from glTF files as a dataset: a sequence "rest" of one frame, hands side by side, and, if the rig has the
/// demo's degrees of freedom, the demo's choreographies played by these hands (angles kept within the rig's limits). 8
/// cameras on a ring.
NewDataset importGltf(const std::filesystem::path& left, const std::filesystem::path& right, const Rig& rig);

} // namespace core
