// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

namespace core {

/// Half sizes of a limb's cross-section, mm: to either side, towards the back of the hand and towards the palm.
/// `at` counts along the path's points: 1.5 is halfway between the second and the third one.
struct CrossSection {
    double at = 0;
    double sideMm = 0;
    double dorsalMm = 0;
    double palmarMm = 0;
};

/// A limb: cross-sections along a path. It reaches from the first to the last section and ends in rounded caps.
struct SweptSolidShape {
    std::vector<CrossSection> sections; ///< `at` ascending
    double capStartMm = 0;
    double capEndMm = 0;
};

/// Where a point lies along a swept path.
struct SweepPosition {
    double distanceMm = 0; ///< to the limb's surface; negative inside
    double at = 0;         ///< of the nearest point of the path, in the path's points
};

/// A limb prepared for distance queries: a smooth curve through the path's points, with cross-sections of rounded-box
/// shape.
class SweptSolid {
public:
    /// At least two points; `dorsal` points towards the back of the hand and is not parallel to the path.
    SweptSolid(const std::vector<Eigen::Vector3d>& path, const Eigen::Vector3d& dorsal, const SweptSolidShape& shape);

    /// Exact on the surface; elsewhere about the distance, and never more than it far away.
    SweepPosition locate(const Eigen::Vector3d& point) const;

    /// locate().distanceMm if that is below `farMm`, otherwise any number from `farMm` up, which costs less.
    double distanceMm(const Eigen::Vector3d& point, double farMm) const;

private:
    struct Sample {
        double at;
        Eigen::Vector3d centre, forward, side, dorsal;
        double sideMm, dorsalMm, palmarMm;
    };

    /// The part of the path between two samples.
    struct Span {
        Eigen::Vector3d start, span;
        double squaredLength;
    };
    struct NearestOfPath {
        std::size_t span;
        double t; ///< 0 at the span's start, 1 at its end
        double squaredDistance;
    };

    double boundDistance(const Eigen::Vector3d& point) const {
        return (point - m_boundCentre).norm() - m_boundRadiusMm;
    }
    NearestOfPath nearestOfPath(const Eigen::Vector3d& point) const;
    SweepPosition locateAt(const NearestOfPath& nearest, const Eigen::Vector3d& point) const;
    double crossSectionDistance(const Sample& sample, const Eigen::Vector3d& offset) const;

    std::vector<Sample> m_samples;
    std::vector<Span> m_spans;
    double m_longestSpanMm = 0;
    double m_reachMm = 0; ///< the surface is nowhere farther from the path
    Eigen::Vector3d m_boundCentre;
    double m_boundRadiusMm = 0;
    double m_capStartMm;
    double m_capEndMm;
};

} // namespace core
