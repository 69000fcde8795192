// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <opencv2/core/mat.hpp>

#include "core/contour/forearm.h"
#include "core/contour/visible_rim.h"
#include "core/geometry/camera.h"

namespace core {

/// Whether silhouettes are wider than the hand before its cut, as those of a sleeve or a bracelet are: per slice of the
/// wrist, how many places just beside the model were looked at, over all cameras and both sides, and how many of them
/// are foreground.
class SleeveSearch {
public:
    /// Adds what one camera sees. coverage: the posed hands as this camera sees them. mask: CV_8U, 0 = background.
    void look(const Camera& camera, const ForearmCut& cut, const RigidMotion& worldFromRest,
              const CoverageMask& coverage, const cv::Mat& mask);
    /// How far before the cut such a part begins, mm; 0 if there is none at the cut.
    double beginsMm() const;

private:
    static constexpr int kSlices = 11;
    std::array<int, kSlices> m_places{}, m_foreground{};
};

} // namespace core
