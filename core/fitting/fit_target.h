// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "core/contour/oriented_contour.h"
#include "core/distance/contour_index.h"
#include "core/distance/dt3_tensor.h"
#include "core/geometry/camera.h"

namespace core {

/// What one camera observed, prepared for matching.
struct CameraTarget {
    int camera = 0; ///< index into the cameras
    cv::Mat mask;   ///< the observed silhouette, shared, not copied
    cv::Rect maskBounds;
    OrientedContour contour;
    std::vector<Eigen::Vector3d> rayDirection; ///< unit, in the world, parallel to the contour
    Eigen::Vector3d centre;                    ///< the camera's centre in the world
    ContourIndex index;
    std::optional<Dt3Tensor> tensor; ///< only if the options ask for it
    bool isSpeckled = false;         ///< all cameras' masks together; only if the options ask
    double secondsContour = 0;       ///< that its outline took
    double secondsTransform = 0;     ///< that the index and the tensor took
};

inline Eigen::Vector2f contourPx(const CameraTarget& target, int point) {
    const auto q = static_cast<std::size_t>(point);
    return {target.contour.x[q], target.contour.y[q]};
}

/// Prepares a contour for searching. wholePixels: at pixel centres, as a distance transform does.
ContourIndex contourIndex(const OrientedContour& contour, const OrientationBins& bins, bool wholePixels);

struct FitTargetOptions {
    ContourOptions contour;
    OrientationBins bins{16, true};
    double tensorLambdaPxPerRad = -1; ///< not negative: also build the DT3 tensor around the outline
    bool wholePixels = false;         ///< match at pixel centres, as a distance transform does
    bool withoutSpecks = false;       ///< where the masks are speckled, their small outlines are left out
};

/// Whether the outlines hold more specks and holes than hands have: small ones, more than 8 per mask on average. Holes
/// between fingers make at most 5 (measured on exact silhouettes, 180 to 1080 px wide), a threshold in a noisy picture
/// makes 11 and more.
bool isSpeckled(const std::vector<std::vector<PixelChain>>& outlinesPerMask);

/// Prepares every camera whose mask is not empty and shows an outline, in the cameras' order.
std::vector<CameraTarget> makeFitTargets(const std::vector<Camera>& cameras, const std::vector<cv::Mat>& masks,
                                         const FitTargetOptions& options, int threads);

} // namespace core
