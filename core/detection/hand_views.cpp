// SPDX-License-Identifier: MIT
#include "core/detection/hand_views.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/detection/landmark_spread.h"
#include "core/numeric/median.h"

namespace core {

namespace {

/// Landmarks that tell whether two detections are of the same hand.
constexpr std::array<std::size_t, 7> kTellingLandmarks{0, 4, 5, 8, 12, 17, 20};
constexpr std::size_t kLeastTelling = 5;
/// A detection belongs to a hand if its landmarks lie this near the hand's on average, share of its square.
constexpr double kBelongs = 0.08;
constexpr std::size_t kLeastKnown = 12; ///< a hand with fewer known landmarks is left out
constexpr double kMostLogOdds = 3;

double logOdds(double probability) {
    const double p = std::clamp(probability, 1e-6, 1 - 1e-6);
    return std::clamp(std::log(p / (1 - p)), -kMostLogOdds, kMostLogOdds);
}

Observation observationOf(int camera, const DetectedHand& hand, std::size_t landmark) {
    return {camera, hand.px[landmark], std::max(0.5, landmarkSpread(landmark).share * hand.sidePx)};
}

using Candidate = std::array<std::optional<Eigen::Vector3d>, kLandmarkCount>;

Candidate pointsOf(const SpatialHand& hand) {
    Candidate points;
    for (std::size_t i = 0; i < kLandmarkCount; ++i)
        if (hand.landmarks[i])
            points[i] = hand.landmarks[i]->triangulated.pointInWorld;
    return points;
}

/// Mean distance of a detection's landmarks from the projected ones, share of its square; infinity if hardly any is
/// seen. What is far off counts as 0.3, so that one wrong finger does not decide.
double misfit(const Camera& camera, const Candidate& points, const DetectedHand& hand) {
    double sum = 0;
    std::size_t count = 0, known = 0;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        if (!points[i])
            continue;
        ++known;
        if (const auto px = project(camera, *points[i])) {
            sum += std::min(0.3, (*px - hand.px[i]).norm() / hand.sidePx);
            ++count;
        }
    }
    return count > 0 && 2 * count > known ? sum / static_cast<double>(count) : std::numeric_limits<double>::infinity();
}

/// The telling landmarks of two detections in space; none if they do not meet.
std::optional<Candidate> meeting(const std::vector<Camera>& cameras, int cameraA, const DetectedHand& a, int cameraB,
                                 const DetectedHand& b) {
    Candidate points;
    std::size_t count = 0, tried = 0;
    for (const std::size_t i : kTellingLandmarks) {
        const auto result = triangulate(cameras, {observationOf(cameraA, a, i), observationOf(cameraB, b, i)});
        ++tried;
        if (result.point) {
            points[i] = result.point->pointInWorld;
            ++count;
        }
        if (tried - count > kTellingLandmarks.size() - kLeastTelling)
            return std::nullopt;
    }
    return points;
}

/// Of each camera the detection that fits best, if it fits.
std::map<int, std::size_t> members(const std::vector<Camera>& cameras, const Candidate& points,
                                   const ViewDetections& detections, double& meanMisfit) {
    std::map<int, std::size_t> best;
    meanMisfit = 0;
    for (std::size_t c = 0; c < detections.size(); ++c) {
        double least = kBelongs;
        for (std::size_t d = 0; d < detections[c].size(); ++d) {
            const double value = misfit(cameras[c], points, detections[c][d]);
            if (value < least) {
                least = value;
                best[static_cast<int>(c)] = d;
            }
        }
        if (best.count(static_cast<int>(c)) > 0)
            meanMisfit += least;
    }
    meanMisfit /= std::max<std::size_t>(1, best.size());
    return best;
}

/// The members of the proposal that most views confirm, and among these the one that fits best.
std::map<int, std::size_t> bestProposal(const std::vector<Camera>& cameras, const ViewDetections& detections) {
    std::map<int, std::size_t> best;
    double bestMisfit = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < detections.size(); ++a)
        for (std::size_t b = a + 1; b < detections.size(); ++b)
            for (const DetectedHand& handA : detections[a])
                for (const DetectedHand& handB : detections[b]) {
                    const auto points = meeting(cameras, static_cast<int>(a), handA, static_cast<int>(b), handB);
                    double fit = 0;
                    const auto found = points ? members(cameras, *points, detections, fit) : best;
                    if (points && (found.size() > best.size() || (found.size() == best.size() && fit < bestMisfit))) {
                        best = found;
                        bestMisfit = fit;
                    }
                }
    return best;
}

std::map<int, DetectedHand> chosen(const ViewDetections& detections, const std::map<int, std::size_t>& indices) {
    std::map<int, DetectedHand> views;
    for (const auto& [camera, index] : indices)
        views[camera] = detections[static_cast<std::size_t>(camera)][index];
    return views;
}

} // namespace

int SpatialHand::landmarkCount() const {
    return static_cast<int>(std::count_if(
        landmarks.begin(), landmarks.end(), [](const auto& landmark) { return landmark.has_value(); }));
}

double SpatialHand::rightnessLogOdds() const {
    double sum = 0;
    for (const auto& [camera, view] : views)
        sum += logOdds(view.rightness);
    return sum;
}

double SpatialHand::medianResidual() const {
    std::vector<double> shares;
    for (const auto& landmark : landmarks)
        if (landmark)
            for (std::size_t i = 0; i < landmark->cameras.size(); ++i)
                shares.push_back(landmark->triangulated.residualPx[i] / views.at(landmark->cameras[i]).sidePx);
    return shares.empty() ? std::numeric_limits<double>::infinity() : medianOf(std::move(shares));
}

SpatialHand spatialHand(const std::vector<Camera>& cameras, std::map<int, DetectedHand> views) {
    SpatialHand hand;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        std::vector<Observation> observations;
        std::vector<int> seenBy;
        for (const auto& [camera, view] : views) {
            observations.push_back(observationOf(camera, view, i));
            seenBy.push_back(camera);
        }
        auto point = triangulate(cameras, observations).point;
        if (!point)
            continue;
        const double floor = landmarkSpread(i).floorMm;
        point->covariance += floor * floor * Eigen::Matrix3d::Identity();
        hand.landmarks[i] = SpatialLandmark{std::move(*point), std::move(seenBy)};
    }
    hand.views = std::move(views);
    return hand;
}

std::vector<SpatialHand> groupDetections(const std::vector<Camera>& cameras, const ViewDetections& detections,
                                         std::size_t mostHands) {
    std::vector<SpatialHand> hands;
    ViewDetections left = detections;
    while (hands.size() < mostHands) {
        std::map<int, std::size_t> indices = bestProposal(cameras, left);
        if (indices.size() < 2)
            break;
        SpatialHand hand = spatialHand(cameras, chosen(left, indices));
        constexpr int kRounds = 3;
        for (int round = 0; round < kRounds; ++round) { // with all landmarks of all views
            double fit = 0;
            const auto next = members(cameras, pointsOf(hand), left, fit);
            if (next.size() < 2 || next == indices)
                break;
            indices = next;
            hand = spatialHand(cameras, chosen(left, indices));
        }
        for (const auto& [camera, index] : indices) {
            auto& list = left[static_cast<std::size_t>(camera)];
            list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
        }
        if (hand.landmarkCount() >= static_cast<int>(kLeastKnown))
            hands.push_back(std::move(hand));
    }
    return hands;
}

std::optional<LandmarkPixels> projectHand(const Camera& camera, const SpatialHand& hand) {
    LandmarkPixels px;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    int count = 0;
    for (const auto& landmark : hand.landmarks)
        if (landmark) {
            mean += landmark->triangulated.pointInWorld;
            ++count;
        }
    if (count < static_cast<int>(kLeastKnown))
        return std::nullopt;
    mean /= count;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        const auto at = project(camera, hand.landmarks[i] ? hand.landmarks[i]->triangulated.pointInWorld : mean);
        if (!at)
            return std::nullopt;
        px[i] = *at;
    }
    return px;
}

double meanDistanceMm(const SpatialHand& a, const SpatialHand& b) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < kLandmarkCount; ++i)
        if (a.landmarks[i] && b.landmarks[i]) {
            sum += (a.landmarks[i]->triangulated.pointInWorld - b.landmarks[i]->triangulated.pointInWorld).norm();
            ++count;
        }
    return count < 5 ? std::numeric_limits<double>::infinity() : sum / count;
}

} // namespace core
