// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/detection/hand_detector.h"
#include "core/detection/hand_views.h"
#include "core/geometry/camera.h"

namespace core {

/// Finds the hands of one instant in the pictures of all cameras, several of them side by side.
class FrameDetector {
public:
    /// `cameras` are kept.
    FrameDetector(const DetectorNetworks& networks, std::vector<Camera> cameras, DetectorOptions options = {});

    /// `pictures`: BGR, one per camera; empty where there is none. `near`: hands where they were a moment ago; if all
    /// are found again near there, nothing else is searched unless `searchAnyway`. Else tiles of a few views are
    /// searched, and what they agree about is looked for in the others, until two hands are found or no view is left.
    ViewDetections detect(const std::vector<cv::Mat>& pictures, const std::vector<SpatialHand>& near,
                          bool searchAnyway = false);

private:
    using Pictures = std::vector<cv::Mat>;
    bool isSettled(const std::vector<SpatialHand>& hands, const Pictures& pictures, std::size_t wanted) const;
    void lookFor(const std::vector<SpatialHand>& hands, const Pictures& pictures, int passes, ViewDetections& found);
    void search(const std::vector<std::size_t>& views, const Pictures& pictures, ViewDetections& found);

    std::vector<Camera> m_cameras;
    std::vector<HandDetector> m_detectors; ///< one per camera that works at the same time
};

} // namespace core
