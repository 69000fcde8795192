// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/detection/hand_landmarks.h"
#include "core/detection/network.h"
#include "core/detection/palms.h"

namespace core {

/// The networks of a hand detector, as plain data.
struct DetectorNetworks {
    NetworkGraph palms;     ///< 192 x 192 picture -> 2016 boxes with points, and scores
    NetworkGraph landmarks; ///< 224 x 224 picture -> 21 x 3 landmarks, presence, rightness, 21 x 3 landmarks in space
};

/// Checks that inputs and outputs are what HandDetector makes use of. Throws Error(BadInput) naming `file`.
void checkPalmNetwork(const NetworkGraph& graph, const std::string& file);
void checkLandmarkNetwork(const NetworkGraph& graph, const std::string& file);

struct DetectorOptions {
    double minPalmScore = 0.5;
    double minPresence = 0.5;
    int tileSidePx = 540;
    std::size_t mostHands = 4; ///< in one picture
};

/// Finds hands and their landmarks in pictures. Not for two threads at once: each has its own.
class HandDetector {
public:
    HandDetector(const DetectorNetworks& networks, DetectorOptions options = {});

    /// Palms of the whole picture; with `tiles` in overlapping windows of it, too: small hands are found only there.
    std::vector<Palm> findPalms(const cv::Mat& bgr, bool tiles);
    /// The landmarks of the hand in a square; `passes` looks, each where the one before has found it. None if there
    /// seems to be no hand.
    std::optional<DetectedHand> findLandmarks(const cv::Mat& bgr, HandPlace place, int passes);
    /// All hands of a picture, without knowing where they are; the surest first.
    std::vector<DetectedHand> search(const cv::Mat& bgr, bool tiles);
    /// The same of a window of the picture.
    std::vector<DetectedHand> searchIn(const cv::Mat& bgr, const cv::Rect& window);

private:
    std::vector<Palm> palmsIn(const cv::Mat& bgr, const std::vector<cv::Rect>& windows);
    std::vector<DetectedHand> handsOf(const cv::Mat& bgr, const std::vector<Palm>& palms);

    DetectorOptions m_options;
    Network m_palms, m_landmarks;
};

/// The part of a picture that a square shows, scaled to `side` pixels: CV_32FC3 RGB, 0..1; zeros outside the picture.
cv::Mat cropOf(const cv::Mat& bgr, const HandPlace& place, int side);

/// Without hands whose landmarks lie on those of a surer one.
std::vector<DetectedHand> withoutDuplicates(std::vector<DetectedHand> hands);

} // namespace core
