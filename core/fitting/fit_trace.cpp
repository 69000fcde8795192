// SPDX-License-Identifier: MIT
#include "core/fitting/fit_trace.h"

#include <limits>

#include "core/hand/skeleton.h"

namespace core {

std::string_view matchVerdictName(MatchVerdict verdict) {
    switch (verdict) {
    case MatchVerdict::Kept:
        return "";
    case MatchVerdict::Orientation:
        return "orientation";
    case MatchVerdict::Gate:
        return "gate";
    case MatchVerdict::Truncated:
        return "truncated";
    case MatchVerdict::EmptyBin:
        return "empty_bin";
    case MatchVerdict::Forearm:
        return "forearm";
    }
    return "";
}

std::vector<ConvexRegion> forearmRegions(const Camera& camera, const std::vector<HandModel>& hands,
                                         const HandPoses& poses, const std::vector<std::optional<ForearmCut>>& cuts) {
    std::vector<ConvexRegion> regions;
    for (std::size_t h = 0; h < cuts.size() && h < hands.size() && h < poses.size(); ++h) {
        if (!cuts[h] || poses[h].size() == 0)
            continue;
        ConvexRegion region = forearmRegion(camera, *cuts[h], worldFromRest(hands[h], poses[h]));
        if (!region.empty())
            regions.push_back(std::move(region));
    }
    return regions;
}

MatchGeometry matchGeometry(const MatchRecord& match, const OrientedContour& contour) {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    if (match.contourPoint < 0)
        return {{kNone, kNone}, kNone, kNone};
    const auto q = static_cast<std::size_t>(match.contourPoint);
    const Eigen::Vector2f px(contour.x[q], contour.y[q]);
    return {px, contour.angleRad[q], (match.rimPx - px).norm()};
}

} // namespace core
