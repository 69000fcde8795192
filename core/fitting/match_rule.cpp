// SPDX-License-Identifier: MIT
#include "core/fitting/match_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/distance/circular_distance.h"

namespace core {

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;
constexpr int kQuantBins = 8;       // design: fewer bins are better for Quant
constexpr int kDt3Bins = 16;        // paper: more than 8 are needed, 16 suffice
constexpr double kQuantGatePx = 60; // without a gate a hard bin finds matches at any distance

MatchRule::Search searchOf(MethodKind kind) {
    switch (kind) {
    case MethodKind::DchQuant:
        return MatchRule::Search::InBin;
    case MethodKind::DchQuant2:
        return MatchRule::Search::InTwoBins;
    case MethodKind::DchDt3:
        return MatchRule::Search::Directional;
    default:
        return MatchRule::Search::Nearest;
    }
}

} // namespace

MatchRule matchRule(const Method& method) {
    MatchRule rule;
    rule.search = searchOf(method.kind);
    const bool quant = rule.search == MatchRule::Search::InBin || rule.search == MatchRule::Search::InTwoBins;
    if (method.kind == MethodKind::DchThres) {
        rule.tauRad = static_cast<float>(method.tauDeg * kRadPerDeg);
    }
    if (method.gatePx > 0) {
        rule.gatePx = static_cast<float>(method.gatePx);
    } else if (quant) {
        rule.gatePx = static_cast<float>(kQuantGatePx);
    }
    rule.lambdaPxPerRad = static_cast<float>(method.lambdaPxPerRad);
    rule.truncatePx2 = static_cast<float>(method.truncatePx2);
    rule.binWeights = method.binWeights;
    rule.wholePixels = method.kind == MethodKind::DchDt3;
    const int bins = method.bins > 0 ? method.bins : (quant ? kQuantBins : kDt3Bins);
    rule.bins = OrientationBins(bins, method.signedOrientation, method.binCentre);
    return rule;
}

namespace {

void addInBins(const CameraTarget& target, const MatchRule& rule, const RimPoint& rim, double angle,
               std::vector<WeightedMatch>& matches) {
    const auto bins = rule.bins.nearestTwo(angle);
    const int count = rule.search == MatchRule::Search::InBin || bins[0] == bins[1] ? 1 : 2;
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

bool withinTau(const CameraTarget& target, const MatchRule& rule, int index, double angle) {
    return std::isinf(rule.tauRad) || circularDistance(static_cast<double>(target.contour.angleRad[index]), angle,
                                                       rule.bins.isSigned()) < static_cast<double>(rule.tauRad);
}

} // namespace

void findMatches(const CameraTarget& target, const MatchRule& rule, const RimPoint& rim,
                 std::vector<WeightedMatch>& matches) {
    const float x = rim.px.x(), y = rim.px.y();
    const float angle = std::atan2(rim.normalPx.y(), rim.normalPx.x());
    const std::size_t before = matches.size();
    ContourMatch match;
    switch (rule.search) {
    case MatchRule::Search::InBin:
    case MatchRule::Search::InTwoBins:
        addInBins(target, rule, rim, static_cast<double>(angle), matches);
        break;
    case MatchRule::Search::Nearest:
        match = target.index.nearest(x, y, rule.gatePx);
        if (match.index >= 0 && withinTau(target, rule, match.index, static_cast<double>(angle))) {
            matches.push_back({match.index, 1});
        }
        break;
    case MatchRule::Search::Directional:
        // The tensor holds the best of all points, which is not the best within a gate.
        if (target.tensor && std::isinf(rule.gatePx)) {
            match = nearestInTensor(target, rim.px, angle);
        } else {
            match = target.index.nearestDirectional(std::round(x), std::round(y),
                                                    rule.bins.binOf(static_cast<double>(angle)), rule.lambdaPxPerRad,
                                                    rule.gatePx);
        }
        if (match.index >= 0) {
            matches.push_back({match.index, 1});
        }
        break;
    case MatchRule::Search::WithinTau:
        match = target.index.nearestWithin(x, y, angle, rule.tauRad, rule.gatePx);
        if (match.index >= 0) {
            matches.push_back({match.index, 1});
        }
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
