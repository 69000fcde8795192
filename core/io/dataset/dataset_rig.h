// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/io/dataset/dataset.h"
#include "core/rig/click_sigma_estimate.h"
#include "core/rig/rig_health.h"

namespace core {

/// The clicks of a dataset by which its calibration is judged: of the named sequences (all if none is named) and of one
/// rater (all if empty). Throws Error(NotFound) for an unknown sequence, and for a rater who has marked nothing there.
std::vector<RigJoint> readRigJoints(const Dataset& dataset, const std::vector<std::string>& sequences = {},
                                    const std::string& rater = {});

/// As rigFindings() takes them.
std::vector<std::string> sequenceNames(const Dataset& dataset);

/// What every rater's clicks are worth, from all of the dataset's annotations that can be read.
ClickSigmas datasetClickSigmas(const Dataset& dataset);

/// What the clicks of the whole dataset say of its cameras, a sentence per finding (rigFindings).
std::vector<std::string> datasetRigFindings(const Dataset& dataset);

} // namespace core
