// SPDX-License-Identifier: MIT
#include "core/detection/hand_detector.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/error.h"

namespace core {

namespace {

constexpr int kCrop = 224;          ///< the landmark network's input
constexpr double kSameHand = 0.15;  ///< mean distance of landmarks, share of the square's side
constexpr double kLeastSidePx = 16; ///< hands that are smaller cannot be told

void requireShapes(const NetworkGraph& graph, const std::string& file, int inputSide,
                   const std::vector<std::size_t>& outputSizes) {
    const auto sizeOf = [&](int tensor) {
        std::size_t size = 1;
        for (const int length : graph.tensors.at(static_cast<std::size_t>(tensor)).shape)
            size *= static_cast<std::size_t>(length);
        return size;
    };
    const std::vector<int> input{1, inputSide, inputSide, 3};
    if (graph.inputs.size() != 1 || graph.tensors.at(static_cast<std::size_t>(graph.inputs[0])).shape != input)
        throw Error(ErrorCode::BadInput, file, "inputs", "the network must have one input of " + shapeText(input));
    if (graph.outputs.size() != outputSizes.size())
        throw Error(ErrorCode::BadInput, file, "outputs",
                    "the network must have " + std::to_string(outputSizes.size()) + " outputs");
    for (std::size_t i = 0; i < outputSizes.size(); ++i)
        if (sizeOf(graph.outputs[i]) != outputSizes[i])
            throw Error(ErrorCode::BadInput, file, "output " + std::to_string(i),
                        "it must hold " + std::to_string(outputSizes[i]) + " numbers");
}

} // namespace

void checkPalmNetwork(const NetworkGraph& graph, const std::string& file) {
    requireShapes(graph, file, kPalmInput, {kPalmAnchors * kPalmNumbers, kPalmAnchors});
}

void checkLandmarkNetwork(const NetworkGraph& graph, const std::string& file) {
    requireShapes(graph, file, kCrop, {3 * kLandmarkCount, 1, 1, 3 * kLandmarkCount});
}

HandDetector::HandDetector(const DetectorNetworks& networks, DetectorOptions options)
    : m_options(options)
    , m_palms(networks.palms, "palm network")
    , m_landmarks(networks.landmarks, "landmark network") {}

std::vector<Palm> HandDetector::findPalms(const cv::Mat& bgr, bool tiles) {
    std::vector<cv::Rect> windows{cv::Rect({0, 0}, bgr.size())};
    if (tiles)
        for (const cv::Rect& tile : searchTiles(bgr.size(), m_options.tileSidePx))
            windows.push_back(tile);
    return palmsIn(bgr, windows);
}

std::vector<Palm> HandDetector::palmsIn(const cv::Mat& bgr, const std::vector<cv::Rect>& windows) {
    std::vector<Palm> palms;
    for (const cv::Rect& window : windows) {
        const Letterbox input = letterbox(bgr, window);
        const std::vector<std::vector<float>> outputs = m_palms.run(input.image);
        for (const Palm& palm : decodePalms(outputs[0], outputs[1], input, m_options.minPalmScore))
            palms.push_back(palm);
    }
    return withoutOverlaps(std::move(palms));
}

cv::Mat cropOf(const cv::Mat& bgr, const HandPlace& place, int side) {
    const double scale = place.sidePx / side; // picture pixels per crop pixel
    // a pixel's centre lies at its number, half a pixel from its edge
    const Eigen::Vector2d origin = place.pixel(0.5 / side, 0.5 / side);
    const Eigen::Vector2d right = scale * place.right(), down = -scale * place.up;
    cv::Mat source = bgr;
    cv::Matx23d pictureFromCrop(right.x(), down.x(), origin.x(), right.y(), down.y(), origin.y());
    const int shrink = std::clamp(static_cast<int>(scale), 1, 8); // sampling alone would skip pixels
    if (shrink > 1) {
        const double reach = 0.75 * place.sidePx;
        const cv::Rect around =
            cv::Rect(cv::Point(cvFloor(place.centrePx.x() - reach), cvFloor(place.centrePx.y() - reach)),
                     cv::Point(cvCeil(place.centrePx.x() + reach), cvCeil(place.centrePx.y() + reach))) &
            cv::Rect({0, 0}, bgr.size());
        const cv::Size size(around.width / shrink, around.height / shrink);
        if (size.empty())
            return cv::Mat::zeros(side, side, CV_32FC3);
        cv::resize(bgr(around), source, size, 0, 0, cv::INTER_AREA);
        const double sx = size.width / static_cast<double>(around.width),
                     sy = size.height / static_cast<double>(around.height);
        const cv::Matx23d& m = pictureFromCrop;
        pictureFromCrop = {m(0, 0) * sx, m(0, 1) * sx, (m(0, 2) - around.x + 0.5) * sx - 0.5,
                           m(1, 0) * sy, m(1, 1) * sy, (m(1, 2) - around.y + 0.5) * sy - 0.5};
    }
    cv::Mat crop;
    cv::warpAffine(source, crop, pictureFromCrop, {side, side}, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
    cv::cvtColor(crop, crop, cv::COLOR_BGR2RGB);
    crop.convertTo(crop, CV_32F, 1 / 255.0);
    return crop;
}

std::optional<DetectedHand> HandDetector::findLandmarks(const cv::Mat& bgr, HandPlace place, int passes) {
    const double most = 4.0 * std::max(bgr.cols, bgr.rows);
    DetectedHand hand;
    for (int pass = 0; pass < passes; ++pass) {
        if (!place.centrePx.allFinite() || !(place.sidePx >= kLeastSidePx && place.sidePx <= most) ||
            place.centrePx.cwiseAbs().maxCoeff() > most)
            return {};
        const std::vector<std::vector<float>> outputs = m_landmarks.run(cropOf(bgr, place, kCrop));
        hand.presence = outputs[1][0];
        hand.rightness = outputs[2][0];
        hand.sidePx = place.sidePx;
        for (std::size_t i = 0; i < kLandmarkCount; ++i)
            hand.px[i] = place.pixel(outputs[0][3 * i] / kCrop, outputs[0][3 * i + 1] / kCrop);
        if (!(hand.presence >= m_options.minPresence))
            return {};
        place = placeOf(hand.px);
    }
    return hand;
}

std::vector<DetectedHand> withoutDuplicates(std::vector<DetectedHand> hands) {
    std::stable_sort(hands.begin(), hands.end(),
                     [](const DetectedHand& a, const DetectedHand& b) { return a.presence > b.presence; });
    std::vector<DetectedHand> kept;
    for (const DetectedHand& hand : hands)
        if (std::none_of(kept.begin(), kept.end(), [&](const DetectedHand& other) {
                return meanDistancePx(hand.px, other.px) < kSameHand * std::max(hand.sidePx, other.sidePx);
            }))
            kept.push_back(hand);
    return kept;
}

std::vector<DetectedHand> HandDetector::handsOf(const cv::Mat& bgr, const std::vector<Palm>& palms) {
    std::vector<DetectedHand> hands;
    for (std::size_t i = 0; i < std::min(palms.size(), 2 * m_options.mostHands); ++i)
        if (const auto hand = findLandmarks(bgr, placeOf(palms[i]), 2))
            hands.push_back(*hand);
    hands = withoutDuplicates(std::move(hands));
    hands.resize(std::min(hands.size(), m_options.mostHands));
    return hands;
}

std::vector<DetectedHand> HandDetector::search(const cv::Mat& bgr, bool tiles) {
    return handsOf(bgr, findPalms(bgr, tiles));
}

std::vector<DetectedHand> HandDetector::searchIn(const cv::Mat& bgr, const cv::Rect& window) {
    return handsOf(bgr, palmsIn(bgr, {window}));
}

} // namespace core
