// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect/inspect_probe.h"

#include "core/fitting/method_name.h"

namespace widgets {

namespace {

/// The methods with their defaults that take one contour point per rim point: those that a probe can show side by side.
const std::vector<std::string>& comparedMethods() {
    static const std::vector<std::string> methods = [] {
        std::vector<std::string> compared;
        for (const std::string& name : core::plainMethodNames())
            if (const core::Method method = core::parseMethod(name);
                !method.best && core::traitsOf(method.distance).bins < 2)
                compared.push_back(name);
        return compared;
    }();
    return methods;
}

bool usesBins(const core::MatchRule& rule) {
    const core::DistanceTraits& traits = core::traitsOf(rule.distance);
    return traits.bins > 0 || traits.isOriented;
}

ProbeRow probeRow(const std::string& method, const core::CameraTarget& target, const core::MatchRule& rule, QPointF px,
                  float angleRad) {
    const Eigen::Vector2f p(static_cast<float>(px.x()), static_cast<float>(px.y()));
    ProbeRow row{method, core::probeContour(target, rule, p, angleRad), angleRad, {},
                 0,      usesBins(rule) ? rule.bins.count() : 1};
    if (row.found()) {
        const Eigen::Vector2f q = core::contourPx(target, row.probe.contourPoint);
        row.contourPx = QPointF(static_cast<double>(q.x()), static_cast<double>(q.y()));
        row.contourAngleRad = target.contour.angleRad[static_cast<std::size_t>(row.probe.contourPoint)];
    }
    return row;
}

std::optional<ProbeRow> ownRow(const MethodOutcome& method, const ShownMatches& shown, const core::MatchRecord& rim,
                               QPointF px) {
    if (method.isFixed)
        return std::nullopt;
    return probeRow(method.method, *shown.target, core::matchRule(core::parseMethod(method.method)), px,
                    rim.rimAngleRad);
}

} // namespace

const core::CameraTarget& ProbeTargets::of(const std::shared_ptr<const core::FitTrace>& trace,
                                           const core::CameraTarget& target, const std::string& method,
                                           const core::MatchRule& rule) {
    const std::pair key(&target, method);
    const auto found = m_prepared.find(key);
    if (found != m_prepared.end())
        return found->second.target;
    constexpr std::size_t kMost = 64; // settings that are dragged make targets anew
    if (m_prepared.size() >= kMost)
        m_prepared.clear();
    return m_prepared.emplace(key, Prepared{trace, core::targetForRule(target, rule)}).first->second.target;
}

std::optional<core::JointId> rimBone(const core::MatchRecord& match, const std::vector<core::HandModel>& hands) {
    if (match.hand >= hands.size() || match.bone >= hands[match.hand].skeleton.bones.size())
        return std::nullopt;
    return core::JointId{hands[match.hand].side, hands[match.hand].skeleton.bones[match.bone].name};
}

std::optional<ProbeRow> ownProbeRow(const MethodOutcome& method, const ShownMatches& shown, QPointF px) {
    const core::MatchRecord* rim = nearestRimPoint(shown, px);
    return shown.target && rim ? ownRow(method, shown, *rim, px) : std::nullopt;
}

std::optional<InspectProbe> inspectProbe(const MethodOutcome& method, const ShownMatches& shown, QPointF px,
                                         const std::vector<core::HandModel>& hands, ProbeTargets& prepared) {
    const core::MatchRecord* rim = nearestRimPoint(shown, px);
    if (!shown.target || !rim)
        return std::nullopt;
    InspectProbe probe{px, static_cast<double>(rim->rimAngleRad), rimBone(*rim, hands), {}};
    if (auto own = ownRow(method, shown, *rim, px))
        probe.rows.push_back(std::move(*own));
    for (const std::string& name : comparedMethods()) {
        if (name == method.method)
            continue;
        const core::MatchRule rule = core::matchRule(core::parseMethod(name));
        const core::CameraTarget& target = prepared.of(method.result.trace, *shown.target, name, rule);
        probe.rows.push_back(probeRow(name, target, rule, px, rim->rimAngleRad));
    }
    return probe;
}

} // namespace widgets
