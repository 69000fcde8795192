// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/annotation/annotation_set.h"
#include "core/geometry/camera.h"
#include "core/io/dataset/dataset.h"
#include "widgets/jobs/fit_runner.h"
#include "widgets/views/camera/view_mark.h"

namespace widgets {

/// Where a joint of a fit's result lies, and how sure that is.
struct JointUncertainty {
    core::JointId joint;
    Eigen::Vector3d pointInWorld;      ///< mm
    Eigen::Matrix3d covarianceInWorld; ///< mm^2, as the fit judged it
};

/// Of every joint of a method's result; none if the fit says nothing of it (no matches, or a method without).
std::vector<JointUncertainty> jointUncertainties(const core::Dataset& dataset, const MethodOutcome& method);

/// Adds the projected 95 % regions of the joints to a view's shapes, in the colours of their fingers.
void addUncertainty(const std::vector<JointUncertainty>& joints, const core::Camera& camera, OverlayShapes& shapes);

} // namespace widgets
