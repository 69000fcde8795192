// SPDX-License-Identifier: MIT
#include "core/labelling/model_silhouettes.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include "core/contour/forearm.h"
#include "core/contour/rasteriser.h"

namespace core {

namespace {

constexpr int kBins = 16;          ///< per colour channel
constexpr float kMostEvidence = 3; ///< log odds of one pixel's colour
constexpr float kModelPull = 1.5f; ///< log odds at the band's ends, of the distance from the model's outline
constexpr double kSmoothPx = 1.0;
constexpr double kLeastPart = 0.02; ///< specks smaller than this share of the hands are left out

/// The hands of a frame, ready to be drawn in every view.
struct PosedHands {
    std::vector<std::vector<Eigen::Vector3d>> vertices;
    std::vector<PosedSurface> surfaces;
    std::vector<ForearmCut> cuts;
    std::vector<RigidMotion> worldFromRest;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};

PosedHands posedHands(const std::vector<HandModel>& hands, const HandPoses& poses) {
    PosedHands posed;
    posed.vertices.reserve(hands.size());
    for (std::size_t h = 0; h < hands.size(); ++h) {
        if (poses[h].size() == 0)
            continue;
        posed.vertices.push_back(posedVertices(hands[h], poses[h]));
        posed.surfaces.push_back({&posed.vertices.back(), &hands[h].mesh.triangles});
        posed.cuts.push_back(forearmCut(hands[h]));
        const RigidMotion root = boneTransforms(hands[h].skeleton, poses[h]).front();
        posed.worldFromRest.push_back(root * inverse(hands[h].skeleton.bones.front().worldFromBoneAtRest));
        posed.centre += root.translation;
    }
    if (!posed.vertices.empty())
        posed.centre /= static_cast<double>(posed.vertices.size());
    return posed;
}

/// Pixels per mm near the hands.
double pixelsPerMm(const Camera& camera, const Eigen::Vector3d& pointInWorld) {
    const Eigen::Vector3d inCamera = camera.cameraFromWorld * pointInWorld;
    return camera.intrinsics(0, 0) / std::max(1.0, inCamera.z());
}

/// Colours of hand and surroundings, as log odds per colour bin.
class ColourOdds {
public:
    explicit ColourOdds(const cv::Mat& bgr)
        : m_bins(bgr.size(), CV_16U) {
        for (int y = 0; y < bgr.rows; ++y) {
            const auto* from = bgr.ptr<cv::Vec3b>(y);
            auto* to = m_bins.ptr<std::uint16_t>(y);
            for (int x = 0; x < bgr.cols; ++x)
                to[x] = static_cast<std::uint16_t>((from[x][0] / kBinWidth * kBins + from[x][1] / kBinWidth) * kBins +
                                                   from[x][2] / kBinWidth);
        }
    }
    /// CV_8U masks of what is surely hand, and surely not.
    void learn(const cv::Mat& hand, const cv::Mat& other) {
        std::vector<float> in = histogram(hand), out = histogram(other);
        m_odds.resize(in.size());
        for (std::size_t i = 0; i < in.size(); ++i)
            m_odds[i] = std::clamp(std::log((in[i] + kUnseen) / (out[i] + kUnseen)), -kMostEvidence, kMostEvidence);
    }
    cv::Mat evidence() const {
        cv::Mat result(m_bins.size(), CV_32F);
        for (int y = 0; y < m_bins.rows; ++y) {
            const auto* bins = m_bins.ptr<std::uint16_t>(y);
            auto* to = result.ptr<float>(y);
            for (int x = 0; x < m_bins.cols; ++x)
                to[x] = m_odds[bins[x]];
        }
        return result;
    }

private:
    static constexpr int kBinWidth = 256 / kBins;
    static constexpr float kUnseen = 2e-5f; ///< share of pixels that an unseen colour is taken to have

    /// Shares per bin, spread to the neighbouring ones.
    std::vector<float> histogram(const cv::Mat& mask) const {
        std::vector<float> counts(kBins * kBins * kBins, 0.f);
        double total = 0;
        for (int y = 0; y < mask.rows; ++y) {
            const auto* in = mask.ptr<std::uint8_t>(y);
            const auto* bins = m_bins.ptr<std::uint16_t>(y);
            for (int x = 0; x < mask.cols; ++x)
                if (in[x]) {
                    ++counts[bins[x]];
                    ++total;
                }
        }
        for (const int stride : {1, kBins, kBins * kBins})
            counts = spread(counts, stride);
        for (float& count : counts)
            count = static_cast<float>(count / std::max(1.0, total));
        return counts;
    }
    static std::vector<float> spread(const std::vector<float>& counts, int stride) {
        std::vector<float> result(counts.size());
        for (int i = 0; i < static_cast<int>(counts.size()); ++i) {
            const int at = i / stride % kBins;
            const float below = at > 0 ? counts[static_cast<std::size_t>(i - stride)] : 0;
            const float above = at + 1 < kBins ? counts[static_cast<std::size_t>(i + stride)] : 0;
            result[static_cast<std::size_t>(i)] = 0.5f * counts[static_cast<std::size_t>(i)] + 0.25f * (below + above);
        }
        return result;
    }

    cv::Mat m_bins;
    std::vector<float> m_odds;
};

/// Where arms may be seen beyond the models, 255 inside.
cv::Mat armsOf(const Camera& camera, const PosedHands& hands, const cv::Rect& window) {
    cv::Mat arms = cv::Mat::zeros(window.size(), CV_8U);
    for (std::size_t h = 0; h < hands.cuts.size(); ++h) {
        const ConvexRegion region = forearmRegion(camera, hands.cuts[h], hands.worldFromRest[h]);
        for (int y = 0; y < window.height && !region.empty(); ++y)
            if (const auto span = region.span(static_cast<float>(y + window.y))) {
                const int first = std::max(0, cvCeil(span->first) - window.x);
                const int last = std::min(window.width - 1, cvFloor(span->second) - window.x);
                if (first <= last)
                    arms.row(y).colRange(first, last + 1).setTo(255);
            }
    }
    return arms;
}

/// Distance from the model's outline, px: positive inside.
cv::Mat signedDistance(const cv::Mat& model) {
    cv::Mat inside, outside;
    cv::distanceTransform(model, inside, cv::DIST_L2, 3);
    cv::distanceTransform(255 - model, outside, cv::DIST_L2, 3);
    return inside - outside;
}

/// Only the parts that the model reaches, without specks.
void keepHands(cv::Mat& mask, const cv::Mat& model) {
    cv::Mat labels, stats, centroids;
    const int count = cv::connectedComponentsWithStats(mask, labels, stats, centroids, 8, CV_32S);
    std::vector<int> shared(static_cast<std::size_t>(count), 0);
    for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x)
            shared[static_cast<std::size_t>(labels.at<int>(y, x))] += model.at<std::uint8_t>(y, x) ? 1 : 0;
    const double least = kLeastPart * cv::countNonZero(model);
    for (int y = 0; y < mask.rows; ++y) {
        const auto* label = labels.ptr<int>(y);
        auto* to = mask.ptr<std::uint8_t>(y);
        for (int x = 0; x < mask.cols; ++x)
            if (label[x] > 0 && shared[static_cast<std::size_t>(label[x])] < least)
                to[x] = 0;
    }
}

/// The part of the picture that has the hands, surroundings to learn from, and as much of the arms as tells that they
/// are there.
cv::Rect windowAround(const Camera& camera, const cv::Mat& model, const PosedHands& hands, double reachPx) {
    cv::Rect box = cv::boundingRect(model);
    if (box.empty())
        return {};
    for (std::size_t h = 0; h < hands.cuts.size(); ++h)
        for (const Eigen::Vector3d& point : forearmAxis(hands.cuts[h], hands.worldFromRest[h]))
            if (const auto px = project(camera, point); px && isInside(camera.size, *px))
                box |= cv::Rect(cvRound(px->x()), cvRound(px->y()), 1, 1);
    const int border = cvCeil(3 * reachPx);
    return cv::Rect(box.x - border, box.y - border, box.width + 2 * border, box.height + 2 * border) &
           cv::Rect({0, 0}, model.size());
}

/// The silhouette in a window of the picture.
cv::Mat silhouetteIn(const cv::Mat& bgr, const cv::Mat& model, const cv::Mat& arms, double reachPx, int rounds) {
    const cv::Mat distance = signedDistance(model);
    const cv::Mat reachable = (distance > -reachPx) | arms;
    cv::Mat hand = distance > std::min(0.35 * reachPx, 6.0);
    cv::Mat other = (distance < -reachPx) & ~arms;
    ColourOdds odds(bgr);
    const cv::Mat pull = cv::min(cv::max(distance * (kModelPull / reachPx), -kModelPull), kModelPull);
    cv::Mat mask;
    for (int round = 0; round < rounds; ++round) {
        odds.learn(hand, other);
        cv::Mat score = odds.evidence();
        cv::GaussianBlur(score, score, {0, 0}, kSmoothPx);
        mask = (score + pull > 0) & reachable;
        if (round + 1 == rounds)
            break;
        cv::erode(mask, hand, cv::Mat());
        cv::dilate(mask, other, cv::Mat());
        other = ~other;
    }
    keepHands(mask, model);
    return mask;
}

} // namespace

std::vector<cv::Mat> silhouettesByModel(const std::vector<Camera>& cameras, const std::vector<cv::Mat>& pictures,
                                        const std::vector<HandModel>& hands, const HandPoses& poses,
                                        const ModelSilhouetteOptions& options) {
    const PosedHands posed = posedHands(hands, poses);
    std::vector<cv::Mat> masks(cameras.size());
    const int count = static_cast<int>(cameras.size());
    const auto work = [&](const cv::Range& range) {
        for (int c = range.start; c < range.end; ++c) {
            const auto view = static_cast<std::size_t>(c);
            if (pictures[view].empty() || posed.surfaces.empty())
                continue;
            const cv::Mat model = renderMask(cameras[view], posed.surfaces);
            const double reachPx = std::max(4.0, options.reachMm * pixelsPerMm(cameras[view], posed.centre));
            const cv::Rect window = windowAround(cameras[view], model, posed, reachPx);
            if (window.empty())
                continue;
            masks[view] = cv::Mat::zeros(model.size(), CV_8U);
            silhouetteIn(pictures[view](window), model(window), armsOf(cameras[view], posed, window), reachPx,
                         options.rounds)
                .copyTo(masks[view](window));
        }
    };
    cv::parallel_for_(cv::Range(0, count), work, count);
    return masks;
}

} // namespace core
