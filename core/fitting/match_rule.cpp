// SPDX-License-Identifier: MIT
#include "core/fitting/match_rule.h"

#include <algorithm>
#include <cmath>
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
    const bool quant = method.distance == DistanceKind::DchQuant || method.distance == DistanceKind::DchQuant2;
    if (method.distance == DistanceKind::DchThres)
        rule.tauRad = static_cast<float>(method.tauDeg * kRadPerDeg);
    if (method.gatePx > 0)
        rule.gatePx = static_cast<float>(method.gatePx);
    else if (quant)
        rule.gatePx = static_cast<float>(kQuantGatePx);
    rule.lambdaPxPerRad = static_cast<float>(method.lambdaPxPerRad);
    rule.truncatePx2 = static_cast<float>(method.truncatePx2);
    rule.binWeights = method.binWeights;
    rule.wholePixels = method.distance == DistanceKind::DchDt3;
    const int bins = method.bins > 0 ? method.bins : (quant ? kQuantBins : kDt3Bins);
    rule.bins = OrientationBins(bins, method.signedOrientation, method.binCentre);
    return rule;
}

namespace {

/// DCH-Quant and DCH-Quant2: the nearest point in the bin of phi_p, or in each of the two bins nearest to it.
void addInBins(const CameraTarget& target, const MatchRule& rule, const RimPoint& rim, double angle,
               std::vector<WeightedMatch>& matches) {
    const auto bins = rule.bins.nearestTwo(angle);
    const int count = rule.distance == DistanceKind::DchQuant || bins[0] == bins[1] ? 1 : 2;
    for (int k = 0; k < count; ++k) {
        const ContourMatch match = target.index.nearestInBin(rim.px.x(), rim.px.y(), bins[k], rule.gatePx);
        if (match.index >= 0) {
            const double apart = circularDistance(angle, rule.bins.centreRad(bins[k]), rule.bins.isSigned());
            const double weight = rule.binWeights ? 1 - apart / rule.bins.widthRad() : 1.0;
            matches.push_back({match.index, static_cast<float>(weight)});
        }
    }
}

ContourMatch nearestInTensor(const CameraTarget& target, const Eigen::Vector2f& px, float angle) {
    const auto match = nearestFromTensor(*target.tensor, target.contour, px.cast<double>(), static_cast<double>(angle));
    return match ? ContourMatch{match->index, static_cast<float>(match->distancePx)} : ContourMatch{};
}

/// circ(phi_p, phi_q) < tau
bool isWithinTau(const CameraTarget& target, const MatchRule& rule, int index, double angle) {
    return std::isinf(rule.tauRad) || circularDistance(static_cast<double>(target.contour.angleRad[index]), angle,
                                                       rule.bins.isSigned()) < static_cast<double>(rule.tauRad);
}

/// DCH-Thres: the nearest point, then the threshold; with `withinTau`, the nearest of those that pass it.
ContourMatch nearestByThreshold(const CameraTarget& target, const MatchRule& rule, const Eigen::Vector2f& px,
                                float angle) {
    if (rule.withinTau)
        return target.index.nearestWithin(px.x(), px.y(), angle, rule.tauRad, rule.gatePx);
    const ContourMatch match = target.index.nearest(px.x(), px.y(), rule.gatePx);
    return match.index >= 0 && isWithinTau(target, rule, match.index, static_cast<double>(angle)) ? match
                                                                                                  : ContourMatch{};
}

/// DCH-DT3. The tensor holds the best of all points, which is not the best within a gate: then the points are searched.
ContourMatch nearestOriented(const CameraTarget& target, const MatchRule& rule, const Eigen::Vector2f& px,
                             float angle) {
    if (target.tensor && std::isinf(rule.gatePx))
        return nearestInTensor(target, px, angle);
    return target.index.nearestDirectional(std::round(px.x()), std::round(px.y()),
                                           rule.bins.binOf(static_cast<double>(angle)), rule.lambdaPxPerRad,
                                           rule.gatePx);
}

void addIfFound(const ContourMatch& match, std::vector<WeightedMatch>& matches) {
    if (match.index >= 0)
        matches.push_back({match.index, 1});
}

} // namespace

void findMatches(const CameraTarget& target, const MatchRule& rule, const RimPoint& rim,
                 std::vector<WeightedMatch>& matches) {
    const float x = rim.px.x(), y = rim.px.y();
    const float angle = std::atan2(rim.normalPx.y(), rim.normalPx.x());
    const std::size_t before = matches.size();
    switch (rule.distance) {
    case DistanceKind::Ch:
        addIfFound(target.index.nearest(x, y, rule.gatePx), matches);
        break;
    case DistanceKind::DchThres:
        addIfFound(nearestByThreshold(target, rule, rim.px, angle), matches);
        break;
    case DistanceKind::DchQuant:
    case DistanceKind::DchQuant2:
        addInBins(target, rule, rim, static_cast<double>(angle), matches);
        break;
    case DistanceKind::DchDt3:
        addIfFound(nearestOriented(target, rule, rim.px, angle), matches);
        break;
    }
    const auto tooFar = [&](const WeightedMatch& m) {
        const float dx = x - target.contour.x[m.index], dy = y - target.contour.y[m.index];
        return dx * dx + dy * dy > rule.truncatePx2;
    };
    if (rule.truncatePx2 > 0) {
        const auto added = matches.begin() + static_cast<std::ptrdiff_t>(before);
        matches.erase(std::remove_if(added, matches.end(), tooFar), matches.end());
    }
}

} // namespace core
