// SPDX-License-Identifier: MIT
#include "core/detection/palms.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace core {

namespace {

constexpr double kPalmScale = 2.6; ///< side of a hand's square by the palm's box
constexpr double kPalmShift = 0.5; ///< towards the fingers, share of the box
constexpr double kTileOverlap = 0.25;
constexpr double kWorthTiling = 1.35; ///< a picture this much larger than a tile

double intersectionOverUnion(const Palm& a, const Palm& b) {
    const Eigen::Array2d least = (a.centrePx - a.sizePx / 2).cwiseMax(b.centrePx - b.sizePx / 2);
    const Eigen::Array2d most = (a.centrePx + a.sizePx / 2).cwiseMin(b.centrePx + b.sizePx / 2);
    const double shared = (most - least).max(0).prod();
    return shared / (a.sizePx.prod() + b.sizePx.prod() - shared);
}

/// Where windows of `side` begin that cover `length`.
std::vector<int> tileStarts(int length, int side) {
    if (length <= side)
        return {0};
    const double step = side * (1 - kTileOverlap);
    const int count = 1 + static_cast<int>(std::ceil((length - side) / step));
    std::vector<int> starts;
    for (int i = 0; i < count; ++i)
        starts.push_back(i * (length - side) / (count - 1));
    return starts;
}

} // namespace

HandPlace placeOf(const Palm& palm) {
    HandPlace place;
    const Eigen::Vector2d axis = palm.middleBasePx - palm.wristPx;
    if (axis.norm() > 1e-6)
        place.up = axis.normalized();
    place.centrePx = palm.centrePx + kPalmShift * palm.sizePx.maxCoeff() * place.up;
    place.sidePx = kPalmScale * palm.sizePx.maxCoeff();
    return place;
}

std::vector<Eigen::Vector2d> palmAnchors() {
    std::vector<Eigen::Vector2d> anchors;
    const auto addGrid = [&](int cells, int perCell) {
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x)
                anchors.insert(anchors.end(), static_cast<std::size_t>(perCell),
                               {(x + 0.5) / cells, (y + 0.5) / cells});
    };
    addGrid(24, 2);
    addGrid(12, 6);
    return anchors;
}

Letterbox letterbox(const cv::Mat& bgr, const cv::Rect& window) {
    Letterbox box;
    box.scale = kPalmInput / static_cast<double>(std::max(window.width, window.height));
    const cv::Size size(std::max(1, cvRound(window.width * box.scale)),
                        std::max(1, cvRound(window.height * box.scale)));
    const cv::Point corner((kPalmInput - size.width) / 2, (kPalmInput - size.height) / 2);
    cv::Mat scaled;
    cv::resize(bgr(window), scaled, size, 0, 0, box.scale < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
    cv::Mat square = cv::Mat::zeros(kPalmInput, kPalmInput, CV_8UC3);
    scaled.copyTo(square(cv::Rect(corner, size)));
    cv::cvtColor(square, square, cv::COLOR_BGR2RGB);
    square.convertTo(box.image, CV_32F, 1 / 255.0);
    // edges of pixels are mapped to edges: half a pixel of each picture
    box.offsetPx = Eigen::Vector2d(window.x - 0.5, window.y - 0.5) - Eigen::Vector2d(corner.x, corner.y) / box.scale;
    return box;
}

std::vector<Palm> decodePalms(const std::vector<float>& boxes, const std::vector<float>& logits, const Letterbox& input,
                              double minScore) {
    static const std::vector<Eigen::Vector2d> anchors = palmAnchors();
    std::vector<Palm> palms;
    for (std::size_t i = 0; i < std::min({anchors.size(), logits.size(), boxes.size() / kPalmNumbers}); ++i) {
        const double score = 1 / (1 + std::exp(-static_cast<double>(logits[i])));
        if (!(score >= minScore))
            continue;
        const float* numbers = &boxes[i * kPalmNumbers];
        const auto pixel = [&](std::size_t k) {
            const Eigen::Vector2d inInput = Eigen::Vector2d(numbers[k], numbers[k + 1]) + kPalmInput * anchors[i];
            return Eigen::Vector2d(inInput / input.scale + input.offsetPx);
        };
        Palm palm;
        palm.score = score;
        palm.centrePx = pixel(0);
        palm.sizePx = Eigen::Vector2d(numbers[2], numbers[3]) / input.scale;
        palm.wristPx = pixel(4);
        palm.middleBasePx = pixel(8);
        if (palm.sizePx.minCoeff() > 1 && palm.centrePx.allFinite() && palm.wristPx.allFinite() &&
            palm.middleBasePx.allFinite())
            palms.push_back(palm);
    }
    return palms;
}

std::vector<Palm> withoutOverlaps(std::vector<Palm> palms, double maxOverlap) {
    std::stable_sort(palms.begin(), palms.end(), [](const Palm& a, const Palm& b) { return a.score > b.score; });
    std::vector<Palm> kept;
    for (const Palm& palm : palms)
        if (std::none_of(kept.begin(), kept.end(),
                         [&](const Palm& other) { return intersectionOverUnion(palm, other) > maxOverlap; }))
            kept.push_back(palm);
    return kept;
}

std::vector<cv::Rect> searchTiles(cv::Size picture, int side) {
    if (std::max(picture.width, picture.height) < kWorthTiling * side)
        return {};
    std::vector<cv::Rect> tiles;
    for (const int y : tileStarts(picture.height, side))
        for (const int x : tileStarts(picture.width, side))
            tiles.push_back(cv::Rect(x, y, side, side) & cv::Rect({0, 0}, picture));
    return tiles;
}

} // namespace core
