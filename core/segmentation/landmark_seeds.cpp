// SPDX-License-Identifier: MIT
#include "core/segmentation/landmark_seeds.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace core {

namespace {

constexpr int kShift = 4; ///< fractional bits of what is drawn
using Bone = std::pair<std::size_t, std::size_t>;

/// What is seen between landmarks: the fingers' bones, and the palm's.
const std::vector<Bone>& bones() {
    static const std::vector<Bone> list{{0, 1},  {1, 2},   {2, 3},   {3, 4},   {0, 5},  {5, 6},   {6, 7},   {7, 8},
                                        {0, 9},  {9, 10},  {10, 11}, {11, 12}, {0, 13}, {13, 14}, {14, 15}, {15, 16},
                                        {0, 17}, {17, 18}, {18, 19}, {19, 20}, {5, 9},  {9, 13},  {13, 17}, {1, 5}};
    return list;
}

/// Draws on the labels of a window, in the picture's pixels.
class SeedPen {
public:
    explicit SeedPen(Seeds& seeds)
        : m_seeds(seeds) {}

    void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double thicknessPx, Seed seed) {
        const double width = std::max(1.0, std::round(thicknessPx));
        cv::line(m_seeds.labels, at(from), at(to), cv::Scalar(seedValue(seed)), static_cast<int>(width), cv::LINE_8,
                 kShift);
    }
    void fill(const std::vector<Eigen::Vector2d>& polygon, Seed seed) {
        std::vector<cv::Point> points;
        for (const Eigen::Vector2d& corner : polygon)
            points.push_back(at(corner));
        if (points.size() < 3)
            return;
        std::vector<cv::Point> hull;
        cv::convexHull(points, hull);
        cv::fillConvexPoly(m_seeds.labels, hull, cv::Scalar(seedValue(seed)), cv::LINE_8, kShift);
    }

private:
    cv::Point at(const Eigen::Vector2d& px) const {
        const double scale = 1 << kShift;
        return {static_cast<int>(std::lround((px.x() - m_seeds.window.x) * scale)),
                static_cast<int>(std::lround((px.y() - m_seeds.window.y) * scale))};
    }
    Seeds& m_seeds;
};

std::vector<Eigen::Vector2d> knownPoints(const HandInView& hand) {
    std::vector<Eigen::Vector2d> points;
    for (const auto& px : hand.px)
        if (px)
            points.push_back(*px);
    return points;
}

cv::Rect boundsOf(const std::vector<HandInView>& hands, const LandmarkSeedOptions& options, const cv::Size& picture) {
    cv::Rect bounds;
    for (const HandInView& hand : hands) {
        if (!hand.isKnown())
            continue;
        std::vector<cv::Point2f> points;
        for (const Eigen::Vector2d& px : knownPoints(hand))
            points.emplace_back(static_cast<float>(px.x()), static_cast<float>(px.y()));
        if (hand.forearmEnd)
            points.emplace_back(static_cast<float>(hand.forearmEnd->x()), static_cast<float>(hand.forearmEnd->y()));
        const double widest = std::max(options.reachPalms, hand.forearmEnd ? options.forearmHullPalms / 2 : 0.0);
        const int margin = static_cast<int>(std::ceil((widest + options.marginPalms) * hand.palmPx));
        const cv::Rect one = grownWindow(cv::boundingRect(points), margin, picture);
        bounds = bounds.empty() ? one : (one.empty() ? bounds : bounds | one);
    }
    return bounds;
}

std::vector<Eigen::Vector2d> palmOf(const HandInView& hand) {
    std::vector<Eigen::Vector2d> palm;
    for (const std::size_t i : {0, 1, 5, 9, 13, 17})
        if (hand.px[i])
            palm.push_back(*hand.px[i]);
    return palm;
}

/// From the least sure to the surest, so that no hand takes from another what that is sure of.
void drawUnknown(SeedPen& pen, const HandInView& hand, const LandmarkSeedOptions& options) {
    pen.fill(palmOf(hand), Seed::ProbableBackground);
    for (const Bone& bone : bones())
        if (hand.px[bone.first] && hand.px[bone.second])
            pen.line(*hand.px[bone.first], *hand.px[bone.second], 2 * options.reachPalms * hand.palmPx,
                     Seed::ProbableBackground);
    if (hand.forearmEnd)
        pen.line(*hand.px[kWristLandmark], *hand.forearmEnd, options.forearmHullPalms * hand.palmPx,
                 Seed::ProbableBackground);
}

void drawProbable(SeedPen& pen, const HandInView& hand, const LandmarkSeedOptions& options) {
    pen.fill(palmOf(hand), Seed::ProbableForeground);
    for (const Bone& bone : bones())
        if (hand.px[bone.first] && hand.px[bone.second])
            pen.line(*hand.px[bone.first], *hand.px[bone.second], options.probablePalms * hand.palmPx,
                     Seed::ProbableForeground);
    if (hand.forearmEnd)
        pen.line(*hand.px[kWristLandmark], *hand.forearmEnd, options.forearmPalms * hand.palmPx,
                 Seed::ProbableForeground);
}

void drawSure(SeedPen& pen, const HandInView& hand, const LandmarkSeedOptions& options) {
    for (const Bone& bone : bones())
        if (hand.px[bone.first] && hand.px[bone.second])
            pen.line(*hand.px[bone.first], *hand.px[bone.second], options.surePalms * hand.palmPx,
                     Seed::SureForeground);
}

} // namespace

Seeds landmarkSeeds(const cv::Size& picture, const std::vector<HandInView>& hands, const LandmarkSeedOptions& options) {
    Seeds seeds;
    seeds.window = boundsOf(hands, options, picture);
    if (seeds.window.empty())
        return seeds;
    seeds.labels = cv::Mat::zeros(seeds.window.size(), CV_8U);
    SeedPen pen(seeds);
    for (const auto draw : {drawUnknown, drawProbable, drawSure})
        for (const HandInView& hand : hands)
            if (hand.isKnown())
                draw(pen, hand, options);
    return seeds;
}

} // namespace core
