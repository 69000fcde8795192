// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QPointF>
#include <QString>

#include "core/fitting/match_rule.h"
#include "widgets/presenters/inspect_layers.h"

namespace widgets {

/// What one method would match at a point of a view.
struct ProbeRow {
    std::string method;
    core::ContourProbe probe;
    QPointF contourPx;          ///< q, px
    double contourAngleRad = 0; ///< direction of the outline at q
    int bins = 1;               ///< of directions, where the method has some
    bool found() const { return probe.contourPoint >= 0; }
    bool kept() const { return found() && probe.verdict == core::MatchVerdict::Kept; }
};

/// A point of a view as `method` (none for a fixed pose) and, after it, CH, DCH-Thres, DCH-Quant and DCH-DT3 would
/// match it, with the direction of the rim point that lies nearest.
struct InspectProbe {
    QPointF px;
    double angleRad = 0;
    std::vector<ProbeRow> rows;
};

/// Empty without a trace or rim points there.
std::optional<InspectProbe> inspectProbe(const MethodOutcome& method, const ShownMatches& shown, QPointF px);
/// The method's own row alone; empty for a fixed pose, too.
std::optional<ProbeRow> ownProbeRow(const MethodOutcome& method, const ShownMatches& shown, QPointF px);

/// Why a match is refused, in the person's language; empty for one that is kept.
QString verdictInWords(core::MatchVerdict verdict);

} // namespace widgets
