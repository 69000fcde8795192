// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "core/geometry/camera.h"
#include "core/hand/hand_model.h"

namespace core {

/// A surface ready to be drawn: posed vertices in the world (mm) and the triangles that join them.
struct PosedSurface {
    const std::vector<Eigen::Vector3d>* verticesInWorld;
    const std::vector<std::array<int, 3>>* triangles;
};

/// Depth along z (mm, +infinity = background; CV_32F) and the global triangle index (-1 = background; CV_32S), both
/// rows x cols of the camera's size. Triangles of later surfaces follow those of earlier ones.
struct DepthImage {
    cv::Mat depthMm;
    cv::Mat triangle;
};

/// Draws by the pixel-centre rule: a pixel belongs to a triangle if its centre does (centres at integers; shared edges
/// go to exactly one triangle). Vertices are projected with the lens, edges between them are straight. Triangles with a
/// vertex behind the camera are left out. Front and back faces are both drawn, the nearest wins.
DepthImage renderDepth(const Camera& camera, const std::vector<PosedSurface>& surfaces);

/// The part of a depth image in which something is drawn: its pixel (x, y) is the camera's (x + window.x, y +
/// window.y).
struct DepthWindow {
    cv::Rect window; ///< within the camera's image; empty if nothing is drawn
    DepthImage image;
};

/// renderDepth without the background around the surfaces: the same pixels, a fraction of the memory.
DepthWindow renderDepthWindow(const Camera& camera, const std::vector<PosedSurface>& surfaces);

/// The silhouette alone: CV_8U, 255 inside, 0 outside. Same rule, same pixels as renderDepth.
cv::Mat renderMask(const Camera& camera, const std::vector<PosedSurface>& surfaces);

/// The silhouette of the union of all hands in the given poses.
cv::Mat renderHandsMask(const Camera& camera, const std::vector<HandModel>& hands, const HandPoses& poses);

} // namespace core
