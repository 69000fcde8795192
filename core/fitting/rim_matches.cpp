// SPDX-License-Identifier: MIT
#include "core/fitting/rim_matches.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

std::uint8_t boneOf(const RimPoint& rim, const RimMatches& result) {
    const auto hand = static_cast<std::size_t>(rim.hand);
    const auto vertex = static_cast<std::size_t>(rim.t < 0.5f ? rim.vertexA : rim.vertexB);
    const bool isKnown = hand < result.boneOfVertex.size() && vertex < result.boneOfVertex[hand].size();
    return isKnown ? result.boneOfVertex[hand][vertex] : MatchRecord::kNoBone;
}

void record(const RimPoint& rim, int contourPoint, float weight, MatchVerdict verdict, RimMatches& result) {
    MatchRecord made;
    made.rimPx = rim.px;
    made.rimAngleRad = std::atan2(rim.normalPx.y(), rim.normalPx.x());
    made.contourPoint = contourPoint;
    made.weight = weight;
    made.verdict = verdict;
    made.hand = static_cast<std::uint8_t>(rim.hand);
    made.bone = boneOf(rim, result);
    result.records.push_back(made);
}

RayCorrespondence correspondence(const RimPoint& rim, const CameraTarget& target, const WeightedMatch& match,
                                 const IterationSettings& settings) {
    RayCorrespondence c;
    c.vertexA = rim.vertexA;
    c.vertexB = rim.vertexB;
    c.t = static_cast<double>(rim.t);
    c.point = rim.point.cast<double>();
    c.rayPoint = target.centre;
    c.rayDirection = target.rayDirection[static_cast<std::size_t>(match.index)];
    c.normal = rim.normal.cast<double>();
    c.tangentWeight = settings.tangentWeight;
    c.weight = static_cast<double>(match.weight);
    if (settings.robustMm > 0) {
        const Eigen::Vector3d offset = c.point - c.rayPoint;
        const double squared = (offset - offset.dot(c.rayDirection) * c.rayDirection).squaredNorm();
        c.weight *= 1 / (1 + squared / (settings.robustMm * settings.robustMm));
    }
    if (settings.robustPx > 0) {
        const double ratio = acrossPx(rim, target, match.index) / settings.robustPx;
        c.weight *= 1 / (1 + ratio * ratio);
    }
    return c;
}

/// The rim as a contour, so that contour points can search it.
OrientedContour rimContour(const std::vector<RimPoint>& rim) {
    OrientedContour contour;
    for (const RimPoint& r : rim) {
        contour.x.push_back(r.px.x());
        contour.y.push_back(r.px.y());
        contour.angleRad.push_back(std::atan2(r.normalPx.y(), r.normalPx.x()));
    }
    return contour;
}

void addMatch(const CameraTarget& target, const IterationSettings& settings, const RimPoint& rim,
              const WeightedMatch& match, RimMatches& result) {
    auto& correspondences = result.correspondences[static_cast<std::size_t>(rim.hand)];
    correspondences.push_back(correspondence(rim, target, match, settings));
    if (result.recording) {
        const auto weight = static_cast<float>(correspondences.back().weight);
        record(rim, match.index, weight, MatchVerdict::Kept, result);
    }
}

/// Fills result.matches; what the rule refuses is recorded.
void explainRim(const CameraTarget& target, const MatchRule& rule, const RimPoint& rim, RimMatches& result) {
    result.candidates.clear();
    explainMatches(target, rule, rim, result.candidates);
    for (const MatchCandidate& candidate : result.candidates)
        if (candidate.verdict == MatchVerdict::Kept)
            result.matches.push_back({candidate.index, candidate.weight});
        else
            record(rim, candidate.index, 0, candidate.verdict, result);
}

/// The other direction: contour points that pull the nearest rim point.
void matchContour(const CameraTarget& target, const IterationSettings& settings, const std::vector<RimPoint>& rim,
                  std::span<const ConvexRegion> leftOut, RimMatches& result) {
    if (settings.contourPointsPerCamera <= 0 || rim.empty())
        return;
    const ContourIndex index(rimContour(rim), settings.rule.bins);
    const std::size_t count = target.contour.size();
    const std::size_t wanted = std::min(count, static_cast<std::size_t>(settings.contourPointsPerCamera));
    for (std::size_t k = 0; k < wanted; ++k) {
        const std::size_t q = k * count / wanted;
        if (isInside(leftOut, contourPx(target, static_cast<int>(q))))
            continue;
        const ContourMatch match =
            index.nearestWithin(target.contour.x[q], target.contour.y[q], target.contour.angleRad[q],
                                settings.rule.tauRad, settings.rule.gatePx);
        if (match.index >= 0)
            addMatch(target, settings, rim[static_cast<std::size_t>(match.index)], {static_cast<int>(q), 1}, result);
    }
}

} // namespace

std::vector<std::uint8_t> strongestBones(const SkinnedSurface& surface) {
    std::vector<std::uint8_t> bones(surface.vertexCount(), MatchRecord::kNoBone);
    for (std::size_t v = 0; v < bones.size(); ++v) {
        float most = 0;
        for (int k = surface.firstWeight[v]; k < surface.firstWeight[v + 1]; ++k) {
            const auto entry = static_cast<std::size_t>(k);
            if (surface.weightValue[entry] > most && surface.weightBone[entry] < MatchRecord::kNoBone) {
                most = surface.weightValue[entry];
                bones[v] = static_cast<std::uint8_t>(surface.weightBone[entry]);
            }
        }
    }
    return bones;
}

double acrossPx(const RimPoint& rim, const CameraTarget& target, int contourPoint) {
    return static_cast<double>(rim.normalPx.dot(contourPx(target, contourPoint) - rim.px));
}

bool isInside(std::span<const ConvexRegion> regions, const Eigen::Vector2f& px) {
    return std::any_of(
        regions.begin(), regions.end(), [&](const ConvexRegion& region) { return region.contains(px); });
}

void leaveOut(std::span<const ConvexRegion> regions, std::vector<RimPoint>& rim, RimMatches& result) {
    std::erase_if(
        rim,
        [&](const RimPoint& point) {
            const bool isOut = isInside(regions, point.px);
            if (isOut && result.recording)
                record(point, MatchRecord::kNoContourPoint, 0, MatchVerdict::Forearm, result);
            return isOut;
        });
}

void matchRim(const CameraTarget& target, const IterationSettings& settings, const std::vector<RimPoint>& rim,
              std::span<const ConvexRegion> leftOut, RimMatches& result) {
    result.rejected = 0;
    for (auto& list : result.correspondences)
        list.clear();
    for (const RimPoint& point : rim) {
        result.matches.clear();
        if (result.recording)
            explainRim(target, settings.rule, point, result);
        else
            findMatches(target, settings.rule, point, result.matches);
        std::erase_if(result.matches, [&](const WeightedMatch& match) {
            const bool isOut = isInside(leftOut, contourPx(target, match.index));
            if (isOut && result.recording)
                record(point, match.index, 0, MatchVerdict::Forearm, result);
            return isOut;
        });
        if (result.matches.empty())
            ++result.rejected;
        for (const WeightedMatch& match : result.matches)
            addMatch(target, settings, point, match, result);
    }
    matchContour(target, settings, rim, leftOut, result);
}

} // namespace core
