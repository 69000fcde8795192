// SPDX-License-Identifier: MIT
#include "core/labelling/hand_assignment.h"

#include <algorithm>

#include "core/detection/hand_sides.h"
#include "core/labelling/landmark_fit.h"

namespace core {

namespace {

constexpr double kSureSide = 0.02;   ///< side doubts below it are not asked again
constexpr double kClearlyLess = 0.6; ///< of the misfit of the other side
constexpr double kLeastGain = 0.05;  ///< per hand: less is noise

/// How badly a model of that side explains a hand; large where there is no such model.
double misfitOf(const std::vector<HandModel>& models, const SpatialHand& hand, Side side) {
    constexpr double kNoModel = 1e6;
    double least = kNoModel;
    for (const HandModel& model : models)
        if (model.side == side)
            if (const auto fit = fitToLandmarks(model, hand, usualStarts(model.skeleton)))
                least = std::min(least, fit->misfit);
    return least;
}

Side otherSide(Side side) {
    return side == Side::Left ? Side::Right : Side::Left;
}

/// True if the models say that all hands of the frame are of the other side.
bool areSwapped(const std::vector<HandModel>& models, const std::vector<SidedHand>& hands) {
    double as = 0, swapped = 0, mostDoubt = 0;
    for (const SidedHand& hand : hands)
        mostDoubt = std::max(mostDoubt, hand.sideDoubt);
    if (mostDoubt < kSureSide || models.size() < 2)
        return false;
    for (const SidedHand& hand : hands) {
        as += misfitOf(models, hand.hand, hand.side);
        swapped += misfitOf(models, hand.hand, otherSide(hand.side));
    }
    return swapped < kClearlyLess * as && as - swapped > kLeastGain * static_cast<double>(hands.size());
}

} // namespace

std::map<int, HandDetections> assignHands(const std::vector<HandModel>& models,
                                          const std::map<int, std::vector<SpatialHand>>& frames) {
    std::map<int, HandDetections> assigned;
    for (auto& [frame, hands] : giveSides(frames)) {
        HandDetections& list = assigned[frame];
        list.resize(models.size());
        const bool swap = areSwapped(models, hands);
        for (const SidedHand& hand : hands)
            for (std::size_t m = 0; m < models.size(); ++m)
                if (models[m].side == (swap ? otherSide(hand.side) : hand.side))
                    list[m] = hand.hand;
    }
    return assigned;
}

} // namespace core
