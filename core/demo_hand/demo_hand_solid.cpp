// SPDX-License-Identifier: MIT
#include "core/demo_hand/demo_hand_solid.h"

#include <algorithm>
#include <cmath>

#include "core/demo_hand/implicit_surface.h"
#include "core/hand/rig.h"

namespace core {

DemoHandSolid::DemoHandSolid(const DemoHandShape& shape)
    : m_shape(shape)
    , m_forearm(shape.forearmPath, Eigen::Vector3d::UnitZ(), shape.forearm) {
    for (const RayShape& ray : shape.rays) {
        m_metacarpals.emplace_back(ray.joints, ray.dorsal, ray.metacarpal);
        m_digits.emplace_back(ray.joints, ray.dorsal, ray.digit);
        SweptSolidShape whole = ray.metacarpal;
        whole.sections.front().at = 0;
        whole.sections.back().at = static_cast<double>(ray.joints.size()) - 1;
        m_wholeRays.emplace_back(ray.joints, ray.dorsal, whole);
    }
}

double DemoHandSolid::padDistance(const PadShape& pad, const Eigen::Vector3d& point) const {
    const RigidMotion frame = anatomicalFrame(pad.centre, pad.along, pad.dorsal);
    const Eigen::Vector3d local = frame.rotation.transpose() * (point - pad.centre);
    const double relative = local.cwiseQuotient(pad.radiiMm).norm();
    return relative < 0.2 ? (relative - 1) * pad.radiiMm.minCoeff() : local.norm() * (1 - 1 / relative);
}

/// What is farther away than the blend is wide does not show: its distance is not asked for in full.
double DemoHandSolid::distance(const Eigen::Vector3d& point) const {
    const auto blended = [&point](double distance, const SweptSolid& limb, double blendMm) {
        return smoothMin(distance, limb.distanceMm(point, distance + blendMm), blendMm);
    };
    double palm = m_forearm.locate(point).distanceMm;
    for (std::size_t r = 1; r < m_metacarpals.size(); ++r)
        palm = blended(palm, m_metacarpals[r], m_shape.palmBlendMm);
    palm = blended(palm, m_metacarpals[0], m_shape.thumbBlendMm);
    for (const PadShape& pad : m_shape.pads)
        palm = smoothMin(palm, padDistance(pad, point), m_shape.padBlendMm);
    double fingers = m_digits[0].locate(point).distanceMm;
    for (std::size_t r = 1; r < m_digits.size(); ++r)
        fingers = blended(fingers, m_digits[r], m_shape.webBlendMm);
    return smoothMin(palm, fingers, m_shape.fingerBlendMm);
}

std::vector<SweepPosition> DemoHandSolid::alongRays(const Eigen::Vector3d& point) const {
    std::vector<SweepPosition> positions;
    for (std::size_t r = 0; r < m_wholeRays.size(); ++r) {
        positions.push_back({std::min(m_metacarpals[r].locate(point).distanceMm, m_digits[r].locate(point).distanceMm),
                             m_wholeRays[r].locate(point).at});
    }
    return positions;
}

double DemoHandSolid::edgeLengthMm(const Eigen::Vector3d& point) const {
    constexpr double kTransitionMm = 15;
    double toFinger = kTransitionMm;
    for (const SweptSolid& digit : m_digits)
        toFinger = std::min(toFinger, digit.distanceMm(point, toFinger));
    const double t = std::clamp(toFinger / kTransitionMm, 0.0, 1.0);
    return m_shape.fingerEdgeMm + t * (m_shape.palmEdgeMm - m_shape.fingerEdgeMm);
}

Eigen::AlignedBox3d DemoHandSolid::bounds() const {
    constexpr double kMarginMm = 26;
    Eigen::AlignedBox3d box;
    for (const RayShape& ray : m_shape.rays)
        for (const Eigen::Vector3d& joint : ray.joints)
            box.extend(joint);
    for (const Eigen::Vector3d& point : m_shape.forearmPath)
        box.extend(point);
    // The forearm is wider than the margin.
    box.extend(Eigen::Vector3d(0, 20, 0)).extend(Eigen::Vector3d(0, -20, 0));
    return {box.min() - Eigen::Vector3d::Constant(kMarginMm), box.max() + Eigen::Vector3d::Constant(kMarginMm)};
}

} // namespace core
