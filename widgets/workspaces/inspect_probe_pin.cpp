// SPDX-License-Identifier: MIT
#include "widgets/workspaces/inspect_probe_pin.h"

#include <algorithm>
#include <cmath>

namespace widgets {

namespace {

constexpr double kSamePointScreenPx = 6;
const QColor kKept(0xFF, 0xE0, 0x66), kRefused(0xFF, 0x5A, 0x5A);

} // namespace

InspectProbePin::InspectProbePin(InspectColumns& columns, InspectGrid& views, ProbeTargets& targets, QObject* parent)
    : QObject(parent)
    , m_columns(columns)
    , m_views(views)
    , m_targets(targets)
    , m_card(new InspectProbeCard(&views)) {
    connect(m_card, &InspectProbeCard::closed, this, &InspectProbePin::unpin);
    connect(&views, &InspectGrid::pointClicked, this, &InspectProbePin::pin);
    connect(views.overlays(), &InspectOverlays::drawn, this, &InspectProbePin::refresh);
}

void InspectProbePin::pin(int view, QPointF px) {
    const int camera = m_views.cameraOf(view);
    if (camera < 0 || m_columns.count() == 0)
        return;
    const InspectColumn& column = m_columns.columns()[m_views.columnOf(view)];
    const QPointF moved = m_pin ? px - m_pin->px : QPointF();
    const bool isSame = m_pin && m_pin->column == column && m_pin->camera == camera &&
                        std::hypot(moved.x(), moved.y()) * m_views.grid()->view(view)->scale() < kSamePointScreenPx;
    if (isSame) {
        unpin();
        return;
    }
    m_pin = Pin{column, camera, px};
    refresh();
}

void InspectProbePin::unpin() {
    m_pin.reset();
    refresh();
}

void InspectProbePin::refresh() {
    const InspectOverlays::Scene& scene = m_views.overlays()->scene();
    const auto& columns = m_columns.columns();
    std::size_t pinned = columns.size();
    if (m_pin && scene.outcome && scene.outcome->methods.size() == columns.size())
        pinned = static_cast<std::size_t>(std::find(columns.begin(), columns.end(), m_pin->column) - columns.begin());
    const bool isShown =
        pinned < columns.size() && std::count(scene.rowCameras.begin(), scene.rowCameras.end(), m_pin->camera) > 0;
    for (int view = 0; view < m_views.grid()->count(); ++view) {
        std::vector<ResidualArrow> arrows;
        if (isShown && m_views.cameraOf(view) == m_pin->camera) {
            const MethodOutcome& method = scene.outcome->methods[m_views.columnOf(view)];
            const auto row = ownProbeRow(method, shownMatches(method, m_pin->camera, scene.iteration), m_pin->px);
            if (row && row->found())
                arrows.push_back({m_pin->px, row->contourPx, row->kept() ? kKept : kRefused});
        }
        m_views.grid()->view(view)->setResidualArrows(arrows);
    }
    showCard(isShown ? std::optional(pinned) : std::nullopt);
    emit changed();
}

/// Without a column: nothing.
void InspectProbePin::showCard(std::optional<std::size_t> pinned) {
    if (!pinned) {
        m_card->hide();
        return;
    }
    const InspectOverlays::Scene& scene = m_views.overlays()->scene();
    const MethodOutcome& method = scene.outcome->methods[*pinned];
    const auto& cameras = scene.dataset->cameras;
    if (const auto probe = inspectProbe(method, shownMatches(method, m_pin->camera, scene.iteration), m_pin->px,
                                        scene.dataset->hands, m_targets))
        m_card->showProbe(QString::fromStdString(cameras[static_cast<std::size_t>(m_pin->camera)].name), *probe);
    else
        m_card->hide();
}

} // namespace widgets
