// SPDX-License-Identifier: MIT
#include "core/distance/generalized_chamfer.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/distance/circular_distance.h"
#include "core/distance/direct_matching.h"
#include "core/distance/distance_transform.h"

namespace core {

namespace {

/// A match with what decides about it.
struct Candidate {
    int contourPoint = -1;
    double distancePx = std::numeric_limits<double>::infinity(); ///< |p - q|
    double costPx = std::numeric_limits<double>::infinity();     ///< the argument of f
};

double penaltyOf(const ChamferPenalty& penalty, double costPx) {
    switch (penalty.kind) {
    case PenaltyKind::Absolute:
        return costPx;
    case PenaltyKind::Squared:
        return costPx * costPx;
    case PenaltyKind::TruncatedSquared:
        return std::min(costPx * costPx, penalty.rejectedPx2);
    }
    return 0;
}

ChamferTerm termOf(const Candidate& candidate, double angleRad, const OrientedContour& observed,
                   const DirectionalDistance& distance, const ChamferPenalty& penalty) {
    ChamferTerm term{0, candidate.contourPoint, candidate.distancePx, penalty.rejectedPx2, false};
    if (candidate.contourPoint < 0 || candidate.distancePx > distance.gatePx)
        return term;
    const double contourAngleRad = observed.angleRad[static_cast<std::size_t>(candidate.contourPoint)];
    if (traitsOf(distance.kind).isLimited &&
        !(circularDistance(angleRad, contourAngleRad, distance.isSigned) < distance.tauRad))
        return term;
    term.kept = true;
    term.penalty = penaltyOf(penalty, candidate.costPx);
    return term;
}

Candidate positional(const std::optional<DirectMatch>& match) {
    return match ? Candidate{match->index, match->distancePx, match->distancePx} : Candidate{};
}

/// The candidates of one point, exactly: one, or one per bin that is searched.
std::vector<Candidate> directCandidates(const OrientedContour& observed, const DirectionalDistance& distance,
                                        const Eigen::Vector2d& px, double angleRad) {
    const DistanceTraits& traits = traitsOf(distance.kind);
    if (!traits.isOriented && traits.bins == 0)
        return {positional(nearestPoint(observed, px))};
    const OrientationBins bins(distance.bins, distance.isSigned, distance.binCentreOffset);
    const std::array<int, 2> nearestBins = bins.nearestTwo(angleRad);
    if (traits.isOriented) {
        const auto match = nearestQuantisedPoint(observed, bins, px, nearestBins[0], distance.lambdaPxPerRad);
        return {match ? Candidate{match->index, distancePx(observed, match->index, px), match->distancePx}
                      : Candidate{}};
    }
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < static_cast<std::size_t>(traits.bins); ++i)
        candidates.push_back(positional(nearestPointInBin(observed, bins, nearestBins[i], px)));
    return candidates;
}

/// The candidates of every pixel, from transforms.
class CandidateField {
public:
    CandidateField(const OrientedContour& observed, const DirectionalDistance& distance, const cv::Rect& region,
                   double angleRad)
        : m_observed(observed) {
        const OrientationBins bins(distance.bins, distance.isSigned, distance.binCentreOffset);
        const std::array<int, 2> nearestBins = bins.nearestTwo(angleRad);
        const DistanceTraits& traits = traitsOf(distance.kind);
        if (traits.isOriented)
            makeSlice(bins, nearestBins[0], distance.lambdaPxPerRad, region);
        else if (traits.bins == 0)
            m_transforms.push_back(computeDistanceTransform(observed, region));
        for (std::size_t i = 0; i < static_cast<std::size_t>(traits.bins); ++i)
            m_transforms.push_back(computeDistanceTransform(inBin(bins, nearestBins[i]), region));
    }

    void collect(int x, int y, std::vector<Candidate>& candidates) const {
        candidates.clear();
        if (m_slice) {
            const int nearest = m_slice->nearest[m_slice->at(x, y)];
            const double distance = nearest < 0 ? 0 : distancePx(m_observed, nearest, {x, y});
            candidates.push_back(
                nearest < 0 ? Candidate{}
                            : Candidate{nearest, distance, distance + m_turnPx[static_cast<std::size_t>(nearest)]});
        }
        for (std::size_t i = 0; i < m_transforms.size(); ++i) {
            const std::size_t at = m_transforms[i].at(x, y);
            const double distance = m_transforms[i].distancePx[at];
            const int nearest = m_transforms[i].nearest[at];
            const bool subset = !m_members.empty() && nearest >= 0;
            candidates.push_back(
                {subset ? m_members[i][static_cast<std::size_t>(nearest)] : nearest, distance, distance});
        }
    }

private:
    /// One bin's slice of the DT3 tensor, from the definition: of the bins' transforms the least, each farther by what
    /// its orientation costs. The tensor itself would be all slices, relaxed three laps around the circle.
    void makeSlice(const OrientationBins& bins, int bin, double lambdaPxPerRad, const cv::Rect& region) {
        const auto pixels = static_cast<std::size_t>(region.area());
        m_slice.emplace(DistanceTransform{region, std::vector<float>(pixels, std::numeric_limits<float>::infinity()),
                                          std::vector<int>(pixels, -1)});
        m_turnPx.resize(m_observed.size());
        for (int other = 0; other < bins.count(); ++other) {
            const OrientedContour part = inBin(bins, other);
            if (part.size() == 0)
                continue;
            const std::vector<int>& members = m_members.back();
            const double turnPx = lambdaPxPerRad * bins.distanceRad(bin, other);
            for (const int member : members)
                m_turnPx[static_cast<std::size_t>(member)] = turnPx;
            takeLesser(computeDistanceTransform(part, region), static_cast<float>(turnPx), members);
        }
        m_members.clear();
    }

    void takeLesser(const DistanceTransform& part, float fartherPx, const std::vector<int>& members) {
        for (std::size_t i = 0; i < part.nearest.size(); ++i) {
            const float cost = part.distancePx[i] + fartherPx;
            if (part.nearest[i] < 0 || cost >= m_slice->distancePx[i])
                continue;
            m_slice->distancePx[i] = cost;
            m_slice->nearest[i] = members[static_cast<std::size_t>(part.nearest[i])];
        }
    }

    /// The observed points of one bin; remembers which ones they are.
    OrientedContour inBin(const OrientationBins& bins, int bin) {
        OrientedContour part;
        std::vector<int> members;
        for (std::size_t i = 0; i < m_observed.size(); ++i) {
            if (bins.binOf(m_observed.angleRad[i]) == bin) {
                part.x.push_back(m_observed.x[i]);
                part.y.push_back(m_observed.y[i]);
                part.angleRad.push_back(m_observed.angleRad[i]);
                members.push_back(static_cast<int>(i));
            }
        }
        m_members.push_back(std::move(members));
        return part;
    }

    const OrientedContour& m_observed;
    std::optional<DistanceTransform> m_slice; ///< of costs
    std::vector<double> m_turnPx;             ///< what each point's orientation costs there
    std::vector<DistanceTransform> m_transforms;
    std::vector<std::vector<int>> m_members;
};

} // namespace

ChamferScore generalizedChamferDistance(const OrientedContour& model, const OrientedContour& observed,
                                        const DirectionalDistance& distance, const ChamferPenalty& penalty) {
    ChamferScore score;
    double sum = 0;
    for (std::size_t p = 0; p < model.size(); ++p) {
        const Eigen::Vector2d px(model.x[p], model.y[p]);
        for (const Candidate& candidate : directCandidates(observed, distance, px, model.angleRad[p])) {
            ChamferTerm term = termOf(candidate, model.angleRad[p], observed, distance, penalty);
            term.modelPoint = static_cast<int>(p);
            sum += term.penalty;
            ++(term.kept ? score.kept : score.rejected);
            score.terms.push_back(term);
        }
    }
    score.value = score.terms.empty() ? 0 : sum / static_cast<double>(score.terms.size());
    return score;
}

cv::Mat chamferField(const OrientedContour& observed, const DirectionalDistance& distance,
                     const ChamferPenalty& penalty, const cv::Rect& region, double angleRad) {
    const CandidateField candidates(observed, distance, region, angleRad);
    cv::Mat field(region.height, region.width, CV_32F);
    std::vector<Candidate> found;
    for (int row = 0; row < region.height; ++row) {
        float* out = field.ptr<float>(row);
        for (int col = 0; col < region.width; ++col) {
            candidates.collect(region.x + col, region.y + row, found);
            double sum = 0;
            for (const Candidate& candidate : found)
                sum += termOf(candidate, angleRad, observed, distance, penalty).penalty;
            out[col] = static_cast<float>(sum / static_cast<double>(found.size()));
        }
    }
    return field;
}

} // namespace core
