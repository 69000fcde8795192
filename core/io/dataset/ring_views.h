// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/io/dataset/dataset.h"

namespace core {

/// A dataset that is not on the disk yet, for writeDataset.
struct NewDataset {
    Dataset dataset;
    std::vector<Motion> motions; ///< parallel to dataset.sequences
};

/// Points (world, mm) that the hands' skin passes through in all motions, thinned out: what cameras should see.
std::vector<Eigen::Vector3d> recordedVolume(const std::vector<HandModel>& hands, const std::vector<Motion>& motions);

/// Gives every sequence one view per camera, rendered from the motion.
void addRenderedViews(Dataset& dataset);

} // namespace core
