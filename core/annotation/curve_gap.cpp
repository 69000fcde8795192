// SPDX-License-Identifier: MIT
#include "core/annotation/curve_gap.h"

#include <algorithm>
#include <optional>

#include "core/geometry/epipolar_curve.h"

namespace core {

namespace {

std::optional<CurveGap> gapBetween(const std::vector<Camera>& cameras, const Observation& click,
                                   const Observation& other) {
    const Camera& camera = cameras.at(static_cast<std::size_t>(click.camera));
    const Camera& from = cameras.at(static_cast<std::size_t>(other.camera));
    const auto nearest = nearestOnPolyline(epipolarCurve(from, other.px, camera), click.px);
    if (!nearest)
        return std::nullopt;
    return CurveGap{camera.name, from.name, (*nearest - click.px).norm(), click.px, *nearest};
}

} // namespace

std::vector<CurveGap> worstCurveGaps(const std::vector<Camera>& cameras, const std::vector<Observation>& clicks) {
    std::vector<CurveGap> worst;
    for (std::size_t i = 0; i < clicks.size(); ++i) {
        for (std::size_t j = i + 1; j < clicks.size(); ++j) {
            std::vector<CurveGap> gaps;
            for (const auto& gap :
                 {gapBetween(cameras, clicks[i], clicks[j]), gapBetween(cameras, clicks[j], clicks[i])})
                if (gap)
                    gaps.push_back(*gap);
            std::stable_sort(gaps.begin(), gaps.end(),
                             [](const CurveGap& a, const CurveGap& b) { return a.px > b.px; });
            if (!gaps.empty() && (worst.empty() || gaps.front().px > worst.front().px))
                worst = gaps;
        }
    }
    return worst;
}

} // namespace core
