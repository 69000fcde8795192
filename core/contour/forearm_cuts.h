// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/contour/forearm.h"
#include "core/contour/sleeve.h"
#include "core/contour/visible_rim.h"

namespace core {

/// Whether silhouettes go on beyond the end of a hand's model: by the pixels on the forearm's axis that no hand covers.
class ForearmSearch {
public:
    /// Adds what one camera sees, as SleeveSearch::look does.
    void look(const Camera& camera, const ForearmCut& cut, const RigidMotion& worldFromRest,
              const CoverageMask& coverage, const cv::Mat& mask);
    /// Whether more than this share of the pixels are foreground, and there are enough to judge by.
    bool shows(double share) const;

private:
    int m_seen = 0, m_foreground = 0;
};

/// Where the forearms of a fit's hands are cut off, as far as they show any.
class ForearmCuts {
public:
    /// cuts: per hand, where its model ends.
    explicit ForearmCuts(std::vector<ForearmCut> cuts);

    bool has(std::size_t hand) const { return m_has[hand] != 0; }
    bool any() const;
    bool all() const;
    /// Per hand; no value for hands without a forearm.
    std::vector<std::optional<ForearmCut>> cuts() const;
    /// Where the hand's model ends, with or without a forearm.
    const ForearmCut& atModelsEnd(std::size_t hand) const { return m_atModelsEnd[hand]; }

    /// One search per hand. What was found stays. True if a forearm was found.
    bool add(const std::vector<ForearmSearch>& searches);
    /// One search per hand: moves the cuts to where sleeves begin. True if one was moved.
    bool add(const std::vector<SleeveSearch>& searches);

private:
    std::vector<ForearmCut> m_atModelsEnd, m_cuts;
    std::vector<double> m_sleeveMm; ///< how far a cut was moved
    std::vector<char> m_has;
};

} // namespace core
