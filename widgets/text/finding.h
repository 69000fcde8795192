// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include <QString>

#include "core/annotation/quality.h"
#include "core/annotation/reconstruction.h"

namespace widgets {

/// Something about the annotations that deserves a look, and where it is.
struct Finding {
    int frame = 0;
    core::JointId joint;
    std::string camera;  ///< empty if no single view is meant
    QString text;        ///< in the person's language
    double severity = 0; ///< larger is worse; 1 is the limit
};

/// What the reconstructions of one frame say: large errors, views that disagree, joints without a point. Worst first.
std::vector<Finding> findingsOf(const std::map<core::JointId, core::JointReconstruction>& joints, int frame,
                                double badRmsPx);

/// A doubt of the checks, in the person's language.
Finding findingOf(const core::QualityFinding& found, double badRmsPx);

} // namespace widgets
