// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace core {

/// Points of a silhouette's outline with the outward normal of the outline at each.
/// x, y in recorded pixels (centres at integers, y down); angleRad = atan2(n_y, n_x) in (-pi, pi].
struct OrientedContour {
    std::vector<float> x;
    std::vector<float> y;
    std::vector<float> angleRad;

    std::size_t size() const { return x.size(); }
    bool empty() const { return x.empty(); }
};

/// How phi(q) is found along the outline.
enum class ContourNormals {
    Polygon, ///< normal of the segment of cv::approxPolyDP that the pixel belongs to (the paper's line representation)
    Chord    ///< normal of the chord between the neighbours 7 px along the outline on both sides
};

struct ContourOptions {
    ContourNormals normals = ContourNormals::Polygon;
    double polygonEpsilonPx = 1.25; ///< epsilon of approxPolyDP, Polygon only
    int minLengthPx = 10;           ///< shorter outlines are dropped
    double offsetPx = 0.5;          ///< boundary pixel centres lie half a pixel inside: moved outward by this much
};

/// One closed outline of a mask: neighbouring pixels of the foreground, one after another.
using PixelChain = std::vector<cv::Point>;
/// The outlines of a mask, outer ones and holes (cv::findContours with RETR_CCOMP; the region lies on the same side of
/// both), pixels on the border of the image among them. mask: CV_8U, bounds: maskBounds(mask).
std::vector<PixelChain> maskOutlines(const cv::Mat& mask, const cv::Rect& bounds);

/// The outlines of a mask, outer ones and holes (cv::findContours with RETR_CCOMP; the region lies on the same side of
/// both). mask: CV_8U, 0 = background. Pixels on the border of the image do not belong to the outline and are left out.
/// Empty if the mask is. Throws Error(BadInput) if the mask has another type.
OrientedContour orientedContour(const cv::Mat& mask, const ContourOptions& options = {});
/// The same where the outlines of the mask, which has that size, are known already.
OrientedContour orientedContour(const std::vector<PixelChain>& outlines, const cv::Size& size,
                                const ContourOptions& options);

/// The smallest rectangle that holds every pixel that is not 0; empty if there is none. mask: CV_8U.
cv::Rect maskBounds(const cv::Mat& mask);

} // namespace core
