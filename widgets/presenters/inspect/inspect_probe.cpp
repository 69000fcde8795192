// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect/inspect_probe.h"

#include <array>

#include "core/fitting/method_name.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr std::array kCompared{"ch", "dch-thres", "dch-quant", "dch-dt3"};
constexpr LocalText probeWords{"widgets::InspectProbe"};

bool usesBins(const core::MatchRule& rule) {
    return rule.distance != core::DistanceKind::Ch && rule.distance != core::DistanceKind::DchThres;
}

ProbeRow probeRow(const std::string& method, const core::CameraTarget& target, const core::MatchRule& rule, QPointF px,
                  float angleRad) {
    const Eigen::Vector2f p(static_cast<float>(px.x()), static_cast<float>(px.y()));
    ProbeRow row{method, core::probeContour(target, rule, p, angleRad), {}, 0, usesBins(rule) ? rule.bins.count() : 1};
    if (row.found()) {
        const Eigen::Vector2f q = core::contourPx(target, row.probe.contourPoint);
        row.contourPx = QPointF(static_cast<double>(q.x()), static_cast<double>(q.y()));
        row.contourAngleRad =
            static_cast<double>(target.contour.angleRad[static_cast<std::size_t>(row.probe.contourPoint)]);
    }
    return row;
}

} // namespace

std::optional<ProbeRow> ownProbeRow(const MethodOutcome& method, const ShownMatches& shown, QPointF px) {
    const std::optional<float> angle = rimAngleAt(shown, px);
    if (!shown.target || !angle || method.isFixed)
        return std::nullopt;
    return probeRow(method.method, *shown.target, core::matchRule(core::parseMethod(method.method)), px, *angle);
}

std::optional<InspectProbe> inspectProbe(const MethodOutcome& method, const ShownMatches& shown, QPointF px) {
    const std::optional<float> angle = rimAngleAt(shown, px);
    if (!shown.target || !angle)
        return std::nullopt;
    InspectProbe probe{px, static_cast<double>(*angle), {}};
    if (auto own = ownProbeRow(method, shown, px))
        probe.rows.push_back(std::move(*own));
    for (const char* const name : kCompared) {
        if (name == method.method)
            continue;
        const core::MatchRule rule = core::matchRule(core::parseMethod(name));
        probe.rows.push_back(probeRow(name, core::targetForRule(*shown.target, rule), rule, px, *angle));
    }
    return probe;
}

QString verdictInWords(core::MatchVerdict verdict) {
    switch (verdict) {
    case core::MatchVerdict::Orientation:
        return probeWords(QT_TRANSLATE_NOOP("widgets::InspectProbe", "the directions differ"));
    case core::MatchVerdict::Gate:
        return probeWords(QT_TRANSLATE_NOOP("widgets::InspectProbe", "beyond the gate"));
    case core::MatchVerdict::Truncated:
        return probeWords(QT_TRANSLATE_NOOP("widgets::InspectProbe", "too far to count"));
    case core::MatchVerdict::EmptyBin:
        return probeWords(QT_TRANSLATE_NOOP("widgets::InspectProbe", "no outline in this bin"));
    case core::MatchVerdict::Forearm:
        return probeWords(QT_TRANSLATE_NOOP("widgets::InspectProbe", "beyond the end of the hand"));
    case core::MatchVerdict::Kept:
        break;
    }
    return {};
}

} // namespace widgets
