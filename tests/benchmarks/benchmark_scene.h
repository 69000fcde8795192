// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/contour/oriented_contour.h"
#include "core/io/dataset/dataset.h"

namespace test {

/// What the comparisons run on: two hands that interact closely, seen by 8 cameras of 1080 x 1920. The recorded hands
/// of the shared data (sequence 02, fingers crossing) where they are, else the demo's.
struct BenchmarkScene {
    core::Dataset dataset;
    core::Motion motion;
    core::HandPoses start; ///< 5 frames before the others
    core::HandPoses poses;
    std::vector<cv::Mat> masks;                  ///< of `poses`, per camera
    std::vector<core::OrientedContour> contours; ///< of the masks, on the pixel grid
    cv::Rect region;                             ///< of the first mask with a margin of 60 px
};

/// Made once.
const BenchmarkScene& benchmarkScene();

} // namespace test
