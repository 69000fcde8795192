// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/detection/hand_detector.h"
#include "core/detection/hand_views.h"
#include "core/geometry/camera.h"

namespace core {

/// Hands as they were known at another instant.
struct KnownHands {
    std::vector<SpatialHand> hands;
    bool isRecent = true; ///< they are still about there; else only the part of the pictures is likely to be the same
};

/// Finds the hands of one instant in the pictures of all cameras, several of them side by side.
class FrameDetector {
public:
    /// `cameras` are kept.
    FrameDetector(const DetectorNetworks& networks, std::vector<Camera> cameras, DetectorOptions options = {});

    /// `pictures`: BGR, one per camera; empty where there is none. `known`: recent hands are looked for where they
    /// were; if all are found again near there, nothing else is searched unless `searchAnyway`. Else a few views are
    /// searched (around hands that were known, then in tiles), and what they agree about is looked for in the others,
    /// until two hands are found or no view is left.
    ViewDetections detect(const std::vector<cv::Mat>& pictures, const KnownHands& known, bool searchAnyway = false);

private:
    using Pictures = std::vector<cv::Mat>;
    bool isSettled(const std::vector<SpatialHand>& hands, const Pictures& pictures, std::size_t wanted) const;
    void lookFor(const std::vector<SpatialHand>& hands, const Pictures& pictures, int passes, ViewDetections& found);
    /// Searches view after view, in tiles or only around known hands, until two hands are found. False if they are not.
    bool searchViews(const Pictures& pictures, const std::vector<SpatialHand>& around, ViewDetections& found);
    void search(const std::vector<std::size_t>& views, const Pictures& pictures, const std::vector<SpatialHand>& around,
                ViewDetections& found);

    std::vector<Camera> m_cameras;
    std::vector<HandDetector> m_detectors; ///< one per camera that works at the same time
};

} // namespace core
