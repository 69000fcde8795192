// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect/inspect_overlays.h"

#include <algorithm>

#include <opencv2/core/utility.hpp>

#include "widgets/presenters/inspect/inspect_uncertainty.h"

namespace widgets {

namespace {

constexpr double kFieldOpacity = 0.6, kDifferenceOpacity = 1;

std::vector<InspectOverlay> makeOverlays(const InspectOverlays::Scene& scene, const OverlayChoice& choice,
                                         const std::stop_token& stop) {
    const std::size_t columns = scene.outcome->methods.size();
    std::vector<InspectOverlay> overlays(scene.rowCameras.size() * columns);
    const auto makeOne = [&](std::size_t view) {
        const std::size_t m = view % columns;
        const int camera = scene.rowCameras[view / columns];
        const MeshLayer posed = scene.poses && m < scene.poses->methods.size() ? scene.poses->methods[m] : MeshLayer();
        const MethodOutcome& method = scene.outcome->methods[m];
        overlays[view] = inspectOverlay(method, *scene.dataset, camera, scene.iteration, choice, posed);
        if (choice.isShown(InspectLayer::Uncertainty) && isAtResult(method, scene.iteration))
            addUncertainty(jointUncertainties(*scene.dataset, method),
                           scene.dataset->cameras[static_cast<std::size_t>(camera)], overlays[view].shapes);
    };
    cv::parallel_for_(cv::Range(0, static_cast<int>(overlays.size())), [&](const cv::Range& views) {
        for (int view = views.start; view < views.end && !stop.stop_requested(); ++view)
            makeOne(static_cast<std::size_t>(view));
    });
    return overlays;
}

} // namespace

InspectOverlays::InspectOverlays(CameraGrid& grid, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_grid(grid)
    , m_job(pool) {}

void InspectOverlays::setShown(InspectLayer layer, bool shown) {
    if (shown == isShown(layer))
        return;
    if (shown && layer == InspectLayer::Field)
        m_choice.shown.erase(InspectLayer::Difference); // both are pictures of the whole view
    if (shown && layer == InspectLayer::Difference)
        m_choice.shown.erase(InspectLayer::Field);
    if (shown)
        m_choice.shown.insert(layer);
    else
        m_choice.shown.erase(layer);
    emit shownChanged();
    rebuild();
}

void InspectOverlays::setFieldAngleRad(double angleRad) {
    if (angleRad == m_choice.fieldAngleRad)
        return;
    m_choice.fieldAngleRad = angleRad;
    emit shownChanged();
    if (isShown(InspectLayer::Field))
        rebuild();
}

void InspectOverlays::setMatchChoice(MatchChoice choice) {
    if (choice == m_choice.matches)
        return;
    m_choice.matches = choice;
    emit shownChanged();
    if (isShown(InspectLayer::Matches) || isShown(InspectLayer::Rim))
        rebuild();
}

void InspectOverlays::show(Scene scene) {
    m_scene = std::move(scene);
    rebuild();
}

double InspectOverlays::iou(int view) const {
    const auto v = static_cast<std::size_t>(view);
    return v < m_ious.size() ? m_ious[v] : std::numeric_limits<double>::quiet_NaN();
}

bool InspectOverlays::isWithoutForearm(int view) const {
    const auto v = static_cast<std::size_t>(view);
    return v < m_withoutForearms.size() && m_withoutForearms[v] != 0;
}

bool InspectOverlays::isWithoutForearm() const {
    return std::any_of(
        m_withoutForearms.begin(), m_withoutForearms.end(), [](char is) { return is != 0; });
}

void InspectOverlays::rebuild() {
    if (!m_scene.outcome || !m_scene.dataset || m_choice.shown.empty()) {
        m_job.stop();
        hand({});
        return;
    }
    m_job.start([this, scene = m_scene, choice = m_choice](const JobContext& context) -> Job::Delivery {
        auto overlays = std::make_shared<std::vector<InspectOverlay>>(makeOverlays(scene, choice, context.stop));
        return [this, overlays] { hand(std::move(*overlays)); };
    });
}

void InspectOverlays::hand(std::vector<InspectOverlay> overlays) {
    overlays.resize(static_cast<std::size_t>(m_grid.count()));
    m_ious.clear();
    m_withoutForearms.clear();
    m_refusals.clear();
    for (int index = 0; index < m_grid.count(); ++index) {
        const InspectOverlay& overlay = overlays[static_cast<std::size_t>(index)];
        m_grid.view(index)->setShapes(overlay.shapes);
        const bool isDifference = isShown(InspectLayer::Difference);
        m_grid.view(index)->setFieldImage(overlay.field, isDifference ? kDifferenceOpacity : kFieldOpacity,
                                          isDifference);
        m_ious.push_back(overlay.iou);
        m_withoutForearms.push_back(overlay.isWithoutForearm ? 1 : 0);
        m_refusals.insert(overlay.refusals.begin(), overlay.refusals.end());
    }
    emit drawn();
}

} // namespace widgets
