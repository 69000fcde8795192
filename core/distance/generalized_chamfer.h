// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <numbers>
#include <vector>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include "core/contour/oriented_contour.h"
#include "core/distance/distance_kind.h"

namespace core {

/// A distance kind with its parameters; those of other kinds are not read.
struct DirectionalDistance {
    DistanceKind kind = DistanceKind::Ch;
    double tauRad = std::numbers::pi / 8;
    bool isSigned = true;
    int bins = 16;              ///< DchQuant, DchQuant2 and DchDt3
    double binCentreOffset = 0; ///< see OrientationBins
    double lambdaPxPerRad = 25;
    double gatePx = std::numeric_limits<double>::infinity(); ///< matches with |p - q| above it are rejected
};

/// f, of the distance in pixels.
enum class PenaltyKind {
    Absolute,        ///< d
    Squared,         ///< d^2
    TruncatedSquared ///< min(d^2, K) (Stenger et al. 2006)
};

/// For DchDt3 d is |p - q| + lambda * circ, for the others |p - q|.
struct ChamferPenalty {
    PenaltyKind kind = PenaltyKind::Squared;
    double rejectedPx2 = 3600; ///< K: what a rejected or missing match costs, and the truncation (unit of f)
};

/// One term of the sum: a point of the model's rim and the contour point that it was matched with.
struct ChamferTerm {
    int modelPoint = 0;
    int contourPoint = -1;                                       ///< -1 if nothing qualified
    double distancePx = std::numeric_limits<double>::infinity(); ///< |p - q|
    double penalty = 0;
    bool kept = false;
};

struct ChamferScore {
    double value = 0; ///< mean penalty over the terms; 0 if the model has no point
    int kept = 0;
    int rejected = 0;
    std::vector<ChamferTerm> terms; ///< in the order of the model's points
};

/// The generalized Chamfer distance from the model's rim to an observed contour as a score, Z = number of terms.
/// Exact, by looking at every contour point.
ChamferScore generalizedChamferDistance(const OrientedContour& model, const OrientedContour& observed,
                                        const DirectionalDistance& distance, const ChamferPenalty& penalty = {});

/// The same terms pixel by pixel: what a rim point with the outward normal `angleRad` would cost at every pixel of
/// `region` (DchQuant2: the mean of its two terms). CV_32F, region.height x region.width. From distance
/// transforms, so contour points count at their nearest pixel.
cv::Mat chamferField(const OrientedContour& observed, const DirectionalDistance& distance,
                     const ChamferPenalty& penalty, const cv::Rect& region, double angleRad);

} // namespace core
