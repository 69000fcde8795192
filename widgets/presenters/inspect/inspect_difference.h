// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <vector>

#include <QColor>
#include <QImage>

#include <opencv2/core/mat.hpp>

#include "core/contour/forearm.h"
#include "core/geometry/camera.h"
#include "widgets/views/camera/mesh_layer.h"

namespace widgets {

/// Where the observed silhouette and that of the posed hands differ, and how well they agree.
struct SilhouetteDifference {
    /// Half the image's resolution: missed and extra pixels, and hatched what was left out. Null if the mask does not
    /// fit the camera.
    QImage picture;
    double iou = std::numeric_limits<double>::quiet_NaN(); ///< at full resolution, without what was left out
    int leftOutPx = 0; ///< pixels of either silhouette that lie in a region that was left out
};
/// observed: CV_8U, 0 = background. leftOut: regions that no fit looked at, such as forearms.
SilhouetteDifference silhouetteDifference(const core::Camera& camera, const cv::Mat& observed, const MeshLayer& posed,
                                          const std::vector<core::ConvexRegion>& leftOut);

/// Of missed (seen, but not covered by the hands), extra (covered, but not seen) and left out pixels, for legends.
QColor missedColour();
QColor extraColour();
QColor leftOutColour();

} // namespace widgets
