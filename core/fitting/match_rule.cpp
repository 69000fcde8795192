// SPDX-License-Identifier: MIT
#include "core/fitting/match_rule.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/distance/circular_distance.h"

namespace core {

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;
constexpr int kQuantBins = 8;       // fewer bins are better for Quant (Tzionas and Gall 2013)
constexpr int kDt3Bins = 16;        // more than 8 are needed, 16 suffice (same)
constexpr double kQuantGatePx = 60; // without a gate a hard bin finds matches at any distance

} // namespace

MatchRule matchRule(const Method& method) {
    MatchRule rule;
    rule.distance = method.distance;
    rule.withinTau = method.best && method.best->withinTau;
    const DistanceTraits& traits = traitsOf(method.distance);
    const bool quant = traits.bins > 0;
    if (traits.isLimited)
        rule.tauRad = static_cast<float>(method.tauDeg * kRadPerDeg);
    if (method.gatePx > 0)
        rule.gatePx = static_cast<float>(method.gatePx);
    else if (quant)
        rule.gatePx = static_cast<float>(kQuantGatePx);
    rule.lambdaPxPerRad = static_cast<float>(method.lambdaPxPerRad);
    rule.truncatePx2 = static_cast<float>(method.truncatePx2);
    rule.binWeights = method.binWeights;
    rule.wholePixels = traits.isOriented;
    const int bins = method.bins > 0 ? method.bins : (quant ? kQuantBins : kDt3Bins);
    rule.bins = OrientationBins(bins, method.signedOrientation, method.binCentre);
    return rule;
}

namespace {

constexpr float kNoGate = std::numeric_limits<float>::infinity();

/// One rim point as it is searched for.
struct Query {
    const CameraTarget& target;
    const MatchRule& rule;
    float x;
    float y;
    float angle; ///< phi_p
};

/// Keeps matches and forgets what is refused, without asking why.
struct KeptOnly {
    std::vector<WeightedMatch>& matches;
    void keep(int index, float weight) { matches.push_back({index, weight}); }
    void refuse(int, MatchVerdict) {}
    template <typename Search>
    void refuseMissing(Search&&, MatchVerdict) {}
};

/// Keeps everything. `unbounded` repeats the search that found nothing, without its gate: what it finds was too far
/// away.
struct Explained {
    std::vector<MatchCandidate>& candidates;
    void keep(int index, float weight) { candidates.push_back({index, weight, MatchVerdict::Kept}); }
    void refuse(int index, MatchVerdict verdict) { candidates.push_back({index, 0, verdict}); }
    template <typename Search>
    void refuseMissing(Search&& unbounded, MatchVerdict otherwise) {
        const int index = unbounded().index;
        refuse(index, index >= 0 ? MatchVerdict::Gate : otherwise);
    }
};

template <typename Sink>
void keepUnlessTruncated(const Query& p, int index, float weight, Sink& sink) {
    const float dx = p.x - p.target.contour.x[index], dy = p.y - p.target.contour.y[index];
    if (p.rule.truncatePx2 > 0 && dx * dx + dy * dy > p.rule.truncatePx2)
        sink.refuse(index, MatchVerdict::Truncated);
    else
        sink.keep(index, weight);
}

/// CH: the nearest point.
template <typename Sink>
void matchNearest(const Query& p, Sink& sink) {
    const ContourIndex& index = p.target.index;
    const ContourMatch match = index.nearest(p.x, p.y, p.rule.gatePx);
    if (match.index >= 0)
        keepUnlessTruncated(p, match.index, 1, sink);
    else
        sink.refuseMissing([&] { return index.nearest(p.x, p.y, kNoGate); }, MatchVerdict::Gate);
}

/// circ(phi_p, phi_q) < tau
bool isWithinTau(const Query& p, int index) {
    return std::isinf(p.rule.tauRad) ||
           circularDistance(static_cast<double>(p.target.contour.angleRad[index]), static_cast<double>(p.angle),
                            p.rule.bins.isSigned()) < static_cast<double>(p.rule.tauRad);
}

/// DCH-Thres: the nearest point, then the threshold; with `withinTau`, the nearest of those that pass it.
template <typename Sink>
void matchByThreshold(const Query& p, Sink& sink) {
    const ContourIndex& index = p.target.index;
    const auto search = [&](float gatePx) {
        return p.rule.withinTau ? index.nearestWithin(p.x, p.y, p.angle, p.rule.tauRad, gatePx)
                                : index.nearest(p.x, p.y, gatePx);
    };
    const ContourMatch match = search(p.rule.gatePx);
    if (match.index < 0)
        sink.refuseMissing([&] { return search(kNoGate); },
                           p.rule.withinTau ? MatchVerdict::Orientation : MatchVerdict::Gate);
    else if (!p.rule.withinTau && !isWithinTau(p, match.index))
        sink.refuse(match.index, MatchVerdict::Orientation);
    else
        keepUnlessTruncated(p, match.index, 1, sink);
}

/// DCH-Quant and DCH-Quant2: the nearest point in the bin of phi_p, or in each of the two bins nearest to it.
template <typename Sink>
void matchInBins(const Query& p, Sink& sink) {
    const OrientationBins& orientations = p.rule.bins;
    const auto angle = static_cast<double>(p.angle);
    const auto bins = orientations.nearestTwo(angle);
    const int count = bins[0] == bins[1] ? 1 : traitsOf(p.rule.distance).bins;
    for (int k = 0; k < count; ++k) {
        const auto search = [&](float gatePx) { return p.target.index.nearestInBin(p.x, p.y, bins[k], gatePx); };
        const ContourMatch match = search(p.rule.gatePx);
        if (match.index < 0) {
            sink.refuseMissing([&] { return search(kNoGate); }, MatchVerdict::EmptyBin);
            continue;
        }
        const double apart = circularDistance(angle, orientations.centreRad(bins[k]), orientations.isSigned());
        const double weight = p.rule.binWeights ? 1 - apart / orientations.widthRad() : 1.0;
        keepUnlessTruncated(p, match.index, static_cast<float>(weight), sink);
    }
}

ContourMatch nearestInTensor(const CameraTarget& target, const Eigen::Vector2f& px, float angle) {
    const auto match = nearestFromTensor(*target.tensor, target.contour, px.cast<double>(), static_cast<double>(angle));
    return match ? ContourMatch{match->index, static_cast<float>(match->distancePx)} : ContourMatch{};
}

/// DCH-DT3. The tensor holds the best of all points, which is not the best within a gate: then the points are searched.
template <typename Sink>
void matchOriented(const Query& p, Sink& sink) {
    const auto search = [&](float gatePx) {
        if (p.target.tensor && std::isinf(gatePx))
            return nearestInTensor(p.target, {p.x, p.y}, p.angle);
        return p.target.index.nearestDirectional(std::round(p.x), std::round(p.y),
                                                 p.rule.bins.binOf(static_cast<double>(p.angle)), p.rule.lambdaPxPerRad,
                                                 gatePx);
    };
    const ContourMatch match = search(p.rule.gatePx);
    if (match.index >= 0)
        keepUnlessTruncated(p, match.index, 1, sink);
    else
        sink.refuseMissing([&] { return search(kNoGate); }, MatchVerdict::Gate);
}

template <typename Sink>
void match(const CameraTarget& target, const MatchRule& rule, const RimPoint& rim, Sink&& sink) {
    const Query p{target, rule, rim.px.x(), rim.px.y(), std::atan2(rim.normalPx.y(), rim.normalPx.x())};
    switch (rule.distance) {
    case DistanceKind::Ch:
        return matchNearest(p, sink);
    case DistanceKind::DchThres:
        return matchByThreshold(p, sink);
    case DistanceKind::DchQuant:
    case DistanceKind::DchQuant2:
        return matchInBins(p, sink);
    case DistanceKind::DchDt3:
        return matchOriented(p, sink);
    }
}

} // namespace

void findMatches(const CameraTarget& target, const MatchRule& rule, const RimPoint& rim,
                 std::vector<WeightedMatch>& matches) {
    match(target, rule, rim, KeptOnly{matches});
}

void explainMatches(const CameraTarget& target, const MatchRule& rule, const RimPoint& rim,
                    std::vector<MatchCandidate>& candidates) {
    match(target, rule, rim, Explained{candidates});
}

ContourProbe probeContour(const CameraTarget& target, const MatchRule& rule, const Eigen::Vector2f& px,
                          float angleRad) {
    RimPoint rim;
    rim.px = px;
    rim.normalPx = {std::cos(angleRad), std::sin(angleRad)};
    std::vector<MatchCandidate> candidates;
    explainMatches(target, rule, rim, candidates);
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    ContourProbe best{-1, rule.bins.binOf(static_cast<double>(angleRad)), kNone, kNone, MatchVerdict::EmptyBin};
    for (const MatchCandidate& candidate : candidates) {
        if (candidate.index < 0)
            continue;
        const double distance = static_cast<double>((contourPx(target, candidate.index) - px).norm());
        if (best.contourPoint >= 0 && distance >= best.distancePx)
            continue;
        best.contourPoint = candidate.index;
        best.distancePx = best.cost = distance;
        best.verdict = candidate.verdict;
    }
    if (traitsOf(rule.distance).isOriented && best.contourPoint >= 0) {
        const auto q = static_cast<std::size_t>(best.contourPoint);
        const int bin = rule.bins.binOf(static_cast<double>(target.contour.angleRad[q]));
        best.cost += static_cast<double>(rule.lambdaPxPerRad) * rule.bins.distanceRad(best.bin, bin);
    }
    return best;
}

CameraTarget targetForRule(const CameraTarget& target, const MatchRule& rule) {
    return {target.camera,
            target.mask,
            target.maskBounds,
            target.contour,
            {},
            target.centre,
            contourIndex(target.contour, rule.bins, rule.wholePixels),
            std::nullopt};
}

} // namespace core
