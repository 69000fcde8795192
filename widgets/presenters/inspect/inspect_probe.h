// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QPointF>

#include "core/fitting/match_rule.h"
#include "widgets/presenters/inspect/inspect_layers.h"

namespace widgets {

/// What one method would match at a point of a view.
struct ProbeRow {
    std::string method;
    core::ContourProbe probe;
    float rimAngleRad = 0;     ///< the direction that is asked for: that of the rim point that lies nearest
    QPointF contourPx;         ///< q, px
    float contourAngleRad = 0; ///< direction of the outline at q
    int bins = 1;              ///< of directions, where the method has some
    bool found() const { return probe.contourPoint >= 0; }
    bool kept() const { return found() && probe.verdict == core::MatchVerdict::Kept; }
};

/// A point of a view as `method` (none for a fixed pose) and, after it, the plain methods with one match per point (CH,
/// DCH-DT3, DCH-Quant, DCH-Thres) would match it, with the direction of the rim point that lies nearest.
struct InspectProbe {
    QPointF px;
    double angleRad = 0;
    std::optional<core::JointId> rim; ///< the bone that moves that rim point most
    std::vector<ProbeRow> rows;
};

/// The targets of a pair, prepared for the methods that a probe compares: once, not for every point that is asked for.
class ProbeTargets {
public:
    /// `target` is one of the trace's.
    const core::CameraTarget& of(const std::shared_ptr<const core::FitTrace>& trace, const core::CameraTarget& target,
                                 const std::string& method, const core::MatchRule& rule);
    /// Another pair.
    void clear() { m_prepared.clear(); }
    std::size_t size() const { return m_prepared.size(); }

private:
    struct Prepared {
        std::shared_ptr<const core::FitTrace> trace; ///< keeps the key's address from being used again
        core::CameraTarget target;
    };
    std::map<std::pair<const core::CameraTarget*, std::string>, Prepared> m_prepared;
};

/// Empty without a trace or rim points there.
std::optional<InspectProbe> inspectProbe(const MethodOutcome& method, const ShownMatches& shown, QPointF px,
                                         const std::vector<core::HandModel>& hands, ProbeTargets& prepared);
/// The method's own row alone; empty for a fixed pose, too.
std::optional<ProbeRow> ownProbeRow(const MethodOutcome& method, const ShownMatches& shown, QPointF px);

/// The bone that moves the rim point of a match most; empty if it is not known.
std::optional<core::JointId> rimBone(const core::MatchRecord& match, const std::vector<core::HandModel>& hands);

} // namespace widgets
