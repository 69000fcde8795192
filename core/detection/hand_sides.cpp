// SPDX-License-Identifier: MIT
#include "core/detection/hand_sides.h"

#include <cmath>

namespace core {

namespace {

constexpr int kMostGapFrames = 5;  ///< after which hands are not known again by where they are
constexpr double kMostMoveMm = 60; ///< per such step
constexpr double kClearlyNearer = 0.5;

/// A hand through frames that follow each other: what they say of its side.
struct Chain {
    double evidence = 0; ///< log odds that it is a right hand
};

/// What two hands of a frame, or one, say of their sides: log odds for the first one; the second one says the opposite.
double frameEvidence(const std::vector<SpatialHand>& hands) {
    return hands.size() == 2 ? hands[0].rightnessLogOdds() - hands[1].rightnessLogOdds() : hands[0].rightnessLogOdds();
}

/// For each hand of a frame which one of the frame before it is, or -1.
std::vector<int> known(const std::vector<SpatialHand>& before, const std::vector<SpatialHand>& now) {
    std::vector<int> same(now.size(), -1);
    for (std::size_t i = 0; i < now.size(); ++i) {
        double nearest = kMostMoveMm, second = 1e9;
        for (std::size_t k = 0; k < before.size(); ++k) {
            const double distance = meanDistanceMm(before[k], now[i]);
            if (distance < nearest) {
                second = same[i] >= 0 ? nearest : second;
                nearest = distance;
                same[i] = static_cast<int>(k);
            } else {
                second = std::min(second, distance);
            }
        }
        if (same[i] >= 0 && nearest > kClearlyNearer * second)
            same[i] = -1;
    }
    if (same.size() == 2 && same[0] == same[1])
        same = {-1, -1};
    return same;
}

/// Of every frame, which chains its hands belong to.
std::map<int, std::vector<std::size_t>> chainsOf(const std::map<int, std::vector<SpatialHand>>& frames,
                                                 std::vector<Chain>& chains) {
    std::map<int, std::vector<std::size_t>> chainOf;
    int lastFrame = -1000;
    const std::vector<SpatialHand>* last = nullptr;
    for (const auto& [frame, hands] : frames) {
        std::vector<int> same(hands.size(), -1);
        if (last && frame - lastFrame <= kMostGapFrames)
            same = known(*last, hands);
        std::vector<std::size_t>& list = chainOf[frame];
        for (std::size_t i = 0; i < hands.size(); ++i) {
            if (same[i] >= 0) {
                list.push_back(chainOf[lastFrame][static_cast<std::size_t>(same[i])]);
            } else {
                list.push_back(chains.size());
                chains.push_back({});
            }
            chains[list.back()].evidence += i == 0 ? frameEvidence(hands) : -frameEvidence(hands);
        }
        if (!hands.empty()) {
            last = &hands;
            lastFrame = frame;
        }
    }
    return chainOf;
}

} // namespace

std::map<int, std::vector<SidedHand>> giveSides(const std::map<int, std::vector<SpatialHand>>& frames) {
    std::vector<Chain> chains;
    const auto chainOf = chainsOf(frames, chains);
    std::map<int, std::vector<SidedHand>> sided;
    for (const auto& [frame, hands] : frames) {
        const std::vector<std::size_t>& list = chainOf.at(frame);
        std::vector<double> evidence;
        for (const std::size_t chain : list)
            evidence.push_back(chains[chain].evidence);
        if (evidence.size() == 2 && (evidence[0] > 0) == (evidence[1] > 0)) // the surer one decides
            evidence = std::abs(evidence[0]) > std::abs(evidence[1]) ? std::vector{evidence[0], -1e-9 * evidence[0]}
                                                                     : std::vector{-1e-9 * evidence[1], evidence[1]};
        std::vector<SidedHand>& result = sided[frame];
        for (std::size_t i = 0; i < hands.size(); ++i)
            result.push_back(
                {hands[i], evidence[i] > 0 ? Side::Right : Side::Left, 2 / (1 + std::exp(std::abs(evidence[i])))});
    }
    return sided;
}

} // namespace core
