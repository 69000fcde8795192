// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QColor>
#include <QImage>

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "core/geometry/camera.h"
#include "widgets/views/camera/mesh_layer.h"
#include "widgets/views/scene/scene_joint.h"

namespace widgets {

using ActorPtr = vtkSmartPointer<vtkActor>;

/// A smoothly shaded, opaque surface (or its wires) in the layer's colour.
ActorPtr makeMeshActor(const ViewSurface& surface, const MeshLayer& layer);

/// The edges of a camera's field of view down to `depthMm`, with the lens's bend along the image's border.
ActorPtr makeFrustumActor(const core::Camera& camera, double depthMm, const QColor& colour, double lineWidth);

/// The camera's image spread over its field of view at `depthMm`, undistorted: every pixel lies on its own viewing ray.
ActorPtr makeImageActor(const core::Camera& camera, const QImage& image, double depthMm);

/// A ball of `radiusMm`, or the 95 % ellipsoid of the joint's covariance.
ActorPtr makeJointActor(const SceneJoint& joint, double radiusMm);
ActorPtr makeEllipsoidActor(const SceneJoint& joint);
/// A thin white shell around a ball, for the selected joint.
ActorPtr makeHaloActor(const Eigen::Vector3d& centre, double radiusMm);

ActorPtr makeBonesActor(const std::vector<SceneBone>& bones);

/// A square grid of lines through `centre`, perpendicular to `normal`.
ActorPtr makeGridActor(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double spacingMm, int cells,
                       const QColor& colour);

} // namespace widgets
