// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QColor>

#include <Eigen/Core>

#include "core/annotation/annotation_set.h"

namespace widgets {

/// A 3D joint in the scene.
struct SceneJoint {
    core::JointId joint;
    Eigen::Vector3d pointInWorld;              ///< mm
    std::optional<Eigen::Matrix3d> covariance; ///< mm^2; drawn as the 95 % ellipsoid
    QColor colour;
    bool selected = false;
};

/// A bone between two joints in the world, mm.
struct SceneBone {
    Eigen::Vector3d from;
    Eigen::Vector3d to;
    QColor colour;
};

} // namespace widgets
