// SPDX-License-Identifier: MIT
#include "core/detection/hand_doubt.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/numeric/median.h"

namespace core {

namespace {

// Values at which a sign alone makes a doubt of one half.
constexpr double kHalfResidual = 0.03;     ///< median distance of detection and reprojection, share of the square
constexpr double kHalfLengthChange = 0.25; ///< of the most changed bone, share of its usual length
constexpr double kHalfMissing = 3;         ///< landmarks that do not meet
constexpr int kFewestViews = 3;            ///< with fewer a wrong one cannot be told

/// Bones by the landmarks at their ends: the palm's, and each finger's three.
std::vector<std::pair<std::size_t, std::size_t>> bones() {
    std::vector<std::pair<std::size_t, std::size_t>> list;
    for (std::size_t finger = 0; finger < 5; ++finger) {
        const std::size_t base = 1 + 4 * finger;
        list.emplace_back(kWristLandmark, base);
        for (std::size_t k = 0; k < 3; ++k)
            list.emplace_back(base + k, base + k + 1);
    }
    return list;
}

std::optional<double> lengthMm(const SpatialHand& hand, const std::pair<std::size_t, std::size_t>& bone) {
    const auto &from = hand.landmarks[bone.first], &to = hand.landmarks[bone.second];
    if (!from || !to)
        return std::nullopt;
    return (from->triangulated.pointInWorld - to->triangulated.pointInWorld).norm();
}

/// Median length of every bone over all hands, mm; 0 where it is never seen.
std::vector<double> usualLengths(const std::map<int, std::vector<SidedHand>>& frames) {
    std::vector<double> usual;
    for (const auto& bone : bones()) {
        std::vector<double> lengths;
        for (const auto& [frame, hands] : frames)
            for (const SidedHand& hand : hands)
                if (const auto length = lengthMm(hand.hand, bone))
                    lengths.push_back(*length);
        usual.push_back(lengths.empty() ? 0 : medianOf(std::move(lengths)));
    }
    return usual;
}

double mostChanged(const SpatialHand& hand, const std::vector<double>& usual) {
    const auto list = bones();
    double most = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (const auto length = lengthMm(hand, list[i]); length && usual[i] > 0)
            most = std::max(most, std::abs(*length / usual[i] - 1));
    return most;
}

/// Doubt of one sign: 0 at 0, one half at `half`, towards 1 beyond.
double sign(double value, double half) {
    return 1 - std::exp2(-(value / half) * (value / half));
}

} // namespace

std::map<int, std::vector<double>> doubtsOf(const std::map<int, std::vector<SidedHand>>& frames, int pictures) {
    const std::vector<double> usual = usualLengths(frames);
    std::map<int, std::vector<double>> doubts;
    for (const auto& [frame, hands] : frames) {
        std::vector<double>& list = doubts[frame];
        for (const SidedHand& hand : hands) {
            const auto views = static_cast<double>(hand.hand.views.size());
            double trust = (1 - hand.sideDoubt) * (1 - sign(hand.hand.medianResidual(), kHalfResidual)) *
                           (1 - sign(mostChanged(hand.hand, usual), kHalfLengthChange)) *
                           (1 - sign(static_cast<double>(kLandmarkCount) - hand.hand.landmarkCount(), kHalfMissing)) *
                           (1 - sign(std::max(0.0, 0.75 - views / std::max(1, pictures)), 0.25));
            if (hand.hand.views.size() < static_cast<std::size_t>(kFewestViews))
                trust *= 0.8;
            list.push_back(std::clamp(1 - trust, 0.0, 1.0));
        }
    }
    return doubts;
}

} // namespace core
