// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core/mat.hpp>

namespace core {

/// How a silhouette is tidied. Areas are shares of the silhouette's own.
struct CleaningOptions {
    int mostParts = 6;           ///< the largest ones are kept: two hands, each in parts where something is before them
    double leastPart = 0.04;     ///< smaller ones are not, however few there are
    double smallestHole = 0.003; ///< smaller ones are filled; larger ones, as between fingers, are real
};

/// The largest parts of a mask (CV_8U, 0 and 255), small holes filled. Parts that hold a pixel of `kept` stay whatever
/// their size; it may be empty.
cv::Mat cleaned(const cv::Mat& mask, const CleaningOptions& options = {}, const cv::Mat& kept = {});

/// Fills what is dark and smaller than that, and clears what is lit and smaller, px^2.
void dropSmallParts(cv::Mat& mask, int areaPx);

/// Clears the parts of a mask that share fewer than `leastPx` pixels with `reached` (of the same size).
void keepReached(cv::Mat& mask, const cv::Mat& reached, double leastPx = 1);

} // namespace core
