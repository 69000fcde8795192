// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "core/detection/hand_landmarks.h"

namespace core {

/// A palm that was found in a picture: its box and how the hand lies.
struct Palm {
    double score = 0; ///< 0..1
    Eigen::Vector2d centrePx = Eigen::Vector2d::Zero(), sizePx = Eigen::Vector2d::Zero();
    Eigen::Vector2d wristPx = Eigen::Vector2d::Zero(), middleBasePx = Eigen::Vector2d::Zero();
};

/// The square that shows the whole hand of a palm.
HandPlace placeOf(const Palm& palm);

/// The palm network's input: a square of this many pixels.
constexpr int kPalmInput = 192;
/// Its outputs: per anchor a box with seven points (18 numbers), and a score (logit).
constexpr std::size_t kPalmAnchors = 2016, kPalmNumbers = 18;

/// Centres of the anchors in the input (0..1), in the order of the network's outputs: two at each of 24 x 24 cells,
/// then six at each of 12 x 12 cells.
std::vector<Eigen::Vector2d> palmAnchors();

/// A window of a picture, scaled to fit the input and centred in it, with zeros around.
struct Letterbox {
    cv::Mat image;                                      ///< CV_32FC3 RGB, 0..1
    double scale = 1;                                   ///< input pixels per picture pixel
    Eigen::Vector2d offsetPx = Eigen::Vector2d::Zero(); ///< picture = input / scale + offset
};
Letterbox letterbox(const cv::Mat& bgr, const cv::Rect& window);

/// The palms that the network's outputs speak of, at least `minScore` sure.
std::vector<Palm> decodePalms(const std::vector<float>& boxes, const std::vector<float>& logits, const Letterbox& input,
                              double minScore);

/// Of palms whose boxes overlap (intersection over union above `maxOverlap`) only the surest; surest first.
std::vector<Palm> withoutOverlaps(std::vector<Palm> palms, double maxOverlap = 0.3);

/// Overlapping windows that cover a picture: `side` pixels wide and high, a quarter of it shared at least. None if the
/// picture is not much larger than one.
std::vector<cv::Rect> searchTiles(cv::Size picture, int side);

} // namespace core
