// SPDX-License-Identifier: MIT
#include "core/demo_hand/swept_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "core/numeric/monotone_cubic.h"

namespace core {

namespace {

constexpr int kSamplesPerSpan = 10;
constexpr double kNearMm = 25;    ///< from the bounding sphere; farther away the distance to that sphere will do
constexpr double kExponent = 2.3; ///< of the super-ellipse: 2 is an ellipse, more is boxier

/// Catmull-Rom curve through the points, clamped at both ends.
Eigen::Vector3d curvePoint(const std::vector<Eigen::Vector3d>& points, double at) {
    const int last = static_cast<int>(points.size()) - 1;
    const int i = std::clamp(static_cast<int>(std::floor(at)), 0, last - 1);
    const double t = at - i;
    const Eigen::Vector3d& p1 = points[i];
    const Eigen::Vector3d& p2 = points[i + 1];
    const Eigen::Vector3d slope1 = i > 0 ? Eigen::Vector3d(0.5 * (p2 - points[i - 1])) : Eigen::Vector3d(p2 - p1);
    const Eigen::Vector3d slope2 =
        i + 2 <= last ? Eigen::Vector3d(0.5 * (points[i + 2] - p1)) : Eigen::Vector3d(p2 - p1);
    const double s = 1 - t;
    return s * s * (1 + 2 * t) * p1 + t * t * (3 - 2 * t) * p2 + t * s * (s * slope1 - t * slope2);
}

MonotoneCubic profile(const std::vector<CrossSection>& sections, double CrossSection::*size) {
    std::vector<double> at, value;
    for (const CrossSection& section : sections) {
        at.push_back(section.at);
        value.push_back(section.*size);
    }
    return {at, value};
}

} // namespace

SweptSolid::SweptSolid(const std::vector<Eigen::Vector3d>& path, const Eigen::Vector3d& dorsal,
                       const SweptSolidShape& shape)
    : m_capStartMm(shape.capStartMm)
    , m_capEndMm(shape.capEndMm) {
    const MonotoneCubic side = profile(shape.sections, &CrossSection::sideMm);
    const MonotoneCubic back = profile(shape.sections, &CrossSection::dorsalMm);
    const MonotoneCubic front = profile(shape.sections, &CrossSection::palmarMm);
    const double from = shape.sections.front().at;
    const double to = shape.sections.back().at;
    const int count = std::max(2, static_cast<int>(std::ceil((to - from) * kSamplesPerSpan)));
    for (int i = 0; i <= count; ++i) {
        const double at = from + (to - from) * i / count;
        constexpr double kDelta = 0.01;
        Sample sample;
        sample.at = at;
        sample.centre = curvePoint(path, at);
        sample.forward = (curvePoint(path, at + kDelta) - curvePoint(path, at - kDelta)).normalized();
        sample.side = dorsal.cross(sample.forward).normalized();
        sample.dorsal = sample.forward.cross(sample.side);
        sample.sideMm = side(at);
        sample.dorsalMm = back(at);
        sample.palmarMm = front(at);
        m_samples.push_back(sample);
    }
    m_boundCentre = 0.5 * (m_samples.front().centre + m_samples.back().centre);
    for (const Sample& s : m_samples) {
        const double reach = std::max({s.sideMm, s.dorsalMm, s.palmarMm, m_capStartMm, m_capEndMm});
        m_boundRadiusMm = std::max(m_boundRadiusMm, (s.centre - m_boundCentre).norm() + 1.2 * reach);
        m_reachMm = std::max(m_reachMm, 1.2 * reach);
    }
    for (std::size_t i = 0; i + 1 < m_samples.size(); ++i) {
        const Eigen::Vector3d span = m_samples[i + 1].centre - m_samples[i].centre;
        m_spans.push_back({m_samples[i].centre, span, span.squaredNorm()});
        m_longestSpanMm = std::max(m_longestSpanMm, span.norm());
    }
}

/// Along the line from the path's point through `offset`, how far the surface is from its end.
double SweptSolid::crossSectionDistance(const Sample& s, const Eigen::Vector3d& offset) const {
    const double forward = offset.dot(s.forward);
    const double side = offset.dot(s.side);
    const double dorsal = offset.dot(s.dorsal);
    const double cap = forward < 0 ? m_capStartMm : m_capEndMm;
    const bool isEnd = s.at <= m_samples.front().at || s.at >= m_samples.back().at;
    const double x = isEnd ? forward / cap : 0;
    const double y = side / s.sideMm;
    const double z = dorsal / (dorsal > 0 ? s.dorsalMm : s.palmarMm);
    const double section = std::pow(std::pow(std::abs(y), kExponent) + std::pow(std::abs(z), kExponent), 2 / kExponent);
    const double relative = std::sqrt(section + x * x);
    const double smallest = std::min({s.sideMm, s.dorsalMm, s.palmarMm});
    if (relative < 0.2)
        return (relative - 1) * smallest;
    return offset.norm() * (1 - 1 / relative);
}

SweptSolid::NearestOfPath SweptSolid::nearestOfPath(const Eigen::Vector3d& point) const {
    NearestOfPath nearest{0, 0, std::numeric_limits<double>::infinity()};
    double hopeless = std::numeric_limits<double>::infinity(); // squared distance from where a span starts
    for (std::size_t i = 0; i < m_spans.size(); ++i) {
        const Span& s = m_spans[i];
        const Eigen::Vector3d offset = point - s.start;
        if (offset.squaredNorm() > hopeless)
            continue;
        const double t = std::clamp(offset.dot(s.span) / s.squaredLength, 0.0, 1.0);
        const double squared = (offset - t * s.span).squaredNorm();
        if (squared < nearest.squaredDistance) {
            nearest = {i, t, squared};
            const double reach = 1.001 * (std::sqrt(squared) + m_longestSpanMm);
            hopeless = reach * reach;
        }
    }
    return nearest;
}

SweepPosition SweptSolid::locateAt(const NearestOfPath& nearest, const Eigen::Vector3d& point) const {
    const Sample& a = m_samples[nearest.span];
    const Sample& b = m_samples[nearest.span + 1];
    const auto mix = [t = nearest.t](const auto& from, const auto& to) { return ((1 - t) * from + t * to); };
    Sample here;
    here.at = mix(a.at, b.at);
    here.centre = mix(a.centre, b.centre);
    here.forward = mix(a.forward, b.forward).normalized();
    here.dorsal = mix(a.dorsal, b.dorsal).normalized();
    here.side = here.dorsal.cross(here.forward);
    here.sideMm = mix(a.sideMm, b.sideMm);
    here.dorsalMm = mix(a.dorsalMm, b.dorsalMm);
    here.palmarMm = mix(a.palmarMm, b.palmarMm);
    return {crossSectionDistance(here, point - here.centre), here.at};
}

SweepPosition SweptSolid::locate(const Eigen::Vector3d& point) const {
    const double outside = boundDistance(point);
    if (outside > kNearMm)
        return {outside, m_samples.front().at};
    return locateAt(nearestOfPath(point), point);
}

double SweptSolid::distanceMm(const Eigen::Vector3d& point, double farMm) const {
    const double outside = boundDistance(point);
    if (outside > kNearMm || outside >= farMm)
        return outside;
    const NearestOfPath nearest = nearestOfPath(point);
    const double least = std::sqrt(nearest.squaredDistance) - m_reachMm;
    return least >= farMm ? least : locateAt(nearest, point).distanceMm;
}

} // namespace core
