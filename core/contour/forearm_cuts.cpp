// SPDX-License-Identifier: MIT
#include "core/contour/forearm_cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core {

void ForearmSearch::look(const Camera& camera, const ForearmCut& cut, const RigidMotion& worldFromRest,
                         const CoverageMask& coverage, const cv::Mat& mask) {
    for (const Eigen::Vector3d& point : forearmAxis(cut, worldFromRest)) {
        const auto px = project(camera, point);
        if (!px || (px->array() < 0).any() || px->x() > mask.cols - 1 || px->y() > mask.rows - 1 ||
            coverage.covers(px->cast<float>()))
            continue;
        ++m_seen;
        m_foreground +=
            mask.at<unsigned char>(static_cast<int>(std::lround(px->y())), static_cast<int>(std::lround(px->x()))) != 0;
    }
}

bool ForearmSearch::shows(double share) const {
    constexpr int kFewest = 8; // pixels to judge by
    return m_seen >= kFewest && m_foreground > share * m_seen;
}

ForearmCuts::ForearmCuts(std::vector<ForearmCut> cuts)
    : m_atModelsEnd(std::move(cuts))
    , m_cuts(m_atModelsEnd)
    , m_sleeveMm(m_cuts.size(), 0)
    , m_has(m_cuts.size(), 0) {}

bool ForearmCuts::any() const {
    return std::any_of(
        m_has.begin(), m_has.end(), [](char has) { return has != 0; });
}

bool ForearmCuts::all() const {
    return std::all_of(
        m_has.begin(), m_has.end(), [](char has) { return has != 0; });
}

std::vector<std::optional<ForearmCut>> ForearmCuts::cuts() const {
    std::vector<std::optional<ForearmCut>> cuts(m_cuts.size());
    for (std::size_t h = 0; h < m_cuts.size(); ++h)
        if (has(h))
            cuts[h] = m_cuts[h];
    return cuts;
}

bool ForearmCuts::add(const std::vector<ForearmSearch>& searches) {
    constexpr double kSureShare = 0.5, kLikelyShare = 0.25;
    // People show both arms or none: where one is sure, the other may have moved away from where the pose has it.
    const bool anyIsSure = any() || std::any_of(searches.begin(), searches.end(),
                                                [](const ForearmSearch& search) { return search.shows(kSureShare); });
    bool found = false;
    for (std::size_t h = 0; h < m_has.size(); ++h) {
        if (has(h) || !anyIsSure || !searches[h].shows(kLikelyShare))
            continue;
        m_has[h] = 1;
        found = true;
    }
    return found;
}

bool ForearmCuts::add(const std::vector<SleeveSearch>& searches) {
    bool moved = false;
    for (std::size_t h = 0; h < m_has.size(); ++h) {
        const double mm = searches[h].beginsMm();
        if (!has(h) || mm <= m_sleeveMm[h])
            continue;
        m_sleeveMm[h] = mm;
        m_cuts[h] = movedTowardsHand(m_atModelsEnd[h], mm);
        moved = true;
    }
    return moved;
}

} // namespace core
