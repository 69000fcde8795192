// SPDX-License-Identifier: MIT
#include "core/contour/oriented_contour.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <opencv2/imgproc.hpp>

#include "core/error.h"

namespace core {

namespace {

/// True if any byte of [begin, end) is not 0. Reads eight bytes at a time.
bool anyNonZero(const unsigned char* begin, const unsigned char* end) {
    for (; end - begin >= 8; begin += 8) {
        std::uint64_t word;
        std::memcpy(&word, begin, sizeof word);
        if (word != 0)
            return true;
    }
    return std::any_of(begin, end, [](unsigned char value) { return value != 0; });
}

/// Outward normals (not normalised) of the chain's pixels from the polygon's segments. The region lies on the same side
/// of outer outlines and holes, so the outward normal of a tangent (t_x, t_y) is (-t_y, t_x) for both.
std::vector<cv::Point2f> polygonNormals(const PixelChain& chain, double epsilonPx) {
    PixelChain polygon;
    cv::approxPolyDP(chain, polygon, epsilonPx, true);
    std::vector<cv::Point2f> normals(chain.size());
    if (polygon.size() < 2)
        return normals;
    // The polygon's corners are pixels of the chain, in its order, but may begin anywhere.
    const auto first = std::find(chain.begin(), chain.end(), polygon.front()) - chain.begin();
    std::size_t at = static_cast<std::size_t>(first);
    for (std::size_t corner = 0; corner < polygon.size(); ++corner) {
        const cv::Point& next = polygon[(corner + 1) % polygon.size()];
        const cv::Point tangent = next - polygon[corner];
        const cv::Point2f normal(static_cast<float>(-tangent.y), static_cast<float>(tangent.x));
        std::size_t steps = 0;
        do {
            normals[at] = normal;
            at = (at + 1) % chain.size();
        } while (chain[at] != next && ++steps < chain.size());
    }
    return normals;
}

std::vector<cv::Point2f> chordNormals(const PixelChain& chain) {
    constexpr std::size_t kReach = 7;
    const std::size_t n = chain.size();
    std::vector<cv::Point2f> normals(n);
    for (std::size_t i = 0; i < n; ++i) {
        const cv::Point tangent = chain[(i + kReach) % n] - chain[(i + n - kReach % n) % n];
        normals[i] = cv::Point2f(static_cast<float>(-tangent.y), static_cast<float>(tangent.x));
    }
    return normals;
}

void appendChain(OrientedContour& contour, const PixelChain& chain, const cv::Size& size,
                 const ContourOptions& options) {
    const std::vector<cv::Point2f> normals = options.normals == ContourNormals::Polygon
                                                 ? polygonNormals(chain, options.polygonEpsilonPx)
                                                 : chordNormals(chain);
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const cv::Point& q = chain[i];
        const float length = std::hypot(normals[i].x, normals[i].y);
        const bool border = q.x <= 0 || q.y <= 0 || q.x >= size.width - 1 || q.y >= size.height - 1;
        if (border || length == 0)
            continue;
        const float offset = static_cast<float>(options.offsetPx) / length;
        contour.x.push_back(static_cast<float>(q.x) + offset * normals[i].x);
        contour.y.push_back(static_cast<float>(q.y) + offset * normals[i].y);
        contour.angleRad.push_back(std::atan2(normals[i].y, normals[i].x));
    }
}

} // namespace

cv::Rect maskBounds(const cv::Mat& mask) {
    int top = 0, bottom = mask.rows - 1;
    const auto rowIsEmpty = [&](int y) {
        return !anyNonZero(mask.ptr<unsigned char>(y), mask.ptr<unsigned char>(y) + mask.cols);
    };
    while (top <= bottom && rowIsEmpty(top))
        ++top;
    while (bottom > top && rowIsEmpty(bottom))
        --bottom;
    if (top > bottom)
        return {};
    int left = mask.cols, right = 0;
    for (int y = top; y <= bottom; ++y) {
        const unsigned char* row = mask.ptr<unsigned char>(y);
        if (left > 0 && anyNonZero(row, row + left))
            left = static_cast<int>(std::find_if(row, row + left, [](unsigned char v) { return v != 0; }) - row);
        while (right < mask.cols && anyNonZero(row + right, row + mask.cols)) {
            const unsigned char* found =
                std::find_if(row + right, row + mask.cols, [](unsigned char v) { return v != 0; });
            right = static_cast<int>(found - row) + 1;
        }
    }
    return {left, top, right - left, bottom - top + 1};
}

OrientedContour orientedContour(const cv::Mat& mask, const ContourOptions& options) {
    if (!mask.empty() && mask.type() != CV_8U)
        throw Error(ErrorCode::BadInput, "", "mask", "must be an 8-bit image of one channel");
    return orientedContour(maskOutlines(mask, maskBounds(mask)), mask.size(), options);
}

std::vector<PixelChain> maskOutlines(const cv::Mat& mask, const cv::Rect& bounds) {
    std::vector<PixelChain> chains;
    if (bounds.empty())
        return chains;
    // findContours never sees the outermost pixels of what it is given: hand it a frame of background.
    cv::Mat window;
    cv::copyMakeBorder(mask(bounds), window, 1, 1, 1, 1, cv::BORDER_CONSTANT | cv::BORDER_ISOLATED, cv::Scalar(0));
    cv::findContours(window, chains, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE, bounds.tl() - cv::Point(1, 1));
    return chains;
}

OrientedContour orientedContour(const std::vector<PixelChain>& outlines, const cv::Size& size,
                                const ContourOptions& options) {
    OrientedContour contour;
    for (const PixelChain& chain : outlines)
        if (static_cast<int>(chain.size()) >= options.minLengthPx)
            appendChain(contour, chain, size, options);
    return contour;
}

} // namespace core
