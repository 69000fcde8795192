// SPDX-License-Identifier: MIT
#include "widgets/presenters/view_options.h"

#include <locale>
#include <sstream>

namespace widgets {

namespace {
constexpr double kLongErrorFactor = 3;
constexpr double kJointZoom = 2; ///< screen pixels per image pixel
} // namespace

ViewOptions::ViewOptions(CameraGrid& grid, const Selection& selection, const Reconstructions& reconstructions,
                         QObject* parent)
    : QObject(parent)
    , m_grid(grid)
    , m_selection(selection)
    , m_reconstructions(reconstructions) {
    connect(&grid, &CameraGrid::viewAdded, this, [this](int, CameraView* view) { apply(*view); });
    connect(&selection, &Selection::jointChanged, this, &ViewOptions::follow);
    connect(&selection, &Selection::frameChanged, this, &ViewOptions::follow);
}

void ViewOptions::setOverlaysHidden(bool hidden) {
    m_overlaysHidden = hidden;
    applyToAll();
}

void ViewOptions::setLongErrors(bool on) {
    m_longErrors = on;
    applyToAll();
}

void ViewOptions::setLoupeShown(bool shown) {
    m_loupeShown = shown;
    applyToAll();
}

void ViewOptions::setLabelsShown(bool shown) {
    m_labelsShown = shown;
    applyToAll();
}

void ViewOptions::setFollowingJoint(bool on) {
    m_following = on;
    follow();
}

ImageAdjustment ViewOptions::adjustment(const std::string& camera) const {
    const auto at = m_adjustments.find(camera);
    return at == m_adjustments.end() ? ImageAdjustment{} : at->second;
}

void ViewOptions::setAdjustment(const std::string& camera, const ImageAdjustment& adjustment) {
    for (const CameraView* view : m_grid.views())
        if (camera.empty() || view->camera().name == camera)
            m_adjustments[view->camera().name] = adjustment;
    applyToAll();
    emit adjustmentsChanged();
}

std::string ViewOptions::adjustmentsText() const {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    for (const auto& [camera, adjustment] : m_adjustments)
        text << adjustment.brightness << ' ' << adjustment.contrast << ' ' << adjustment.gamma << ' ' << camera << '\n';
    return text.str();
}

void ViewOptions::setAdjustmentsFromText(const std::string& text) {
    m_adjustments.clear();
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        fields.imbue(std::locale::classic());
        ImageAdjustment adjustment;
        std::string camera;
        if (fields >> adjustment.brightness >> adjustment.contrast >> adjustment.gamma &&
            std::getline(fields >> std::ws, camera))
            m_adjustments[camera] = adjustment;
    }
    applyToAll();
    emit adjustmentsLoaded();
}

void ViewOptions::apply(CameraView& view) const {
    view.setOverlaysHidden(m_overlaysHidden);
    view.setReprojectionScale(m_longErrors ? kLongErrorFactor : 1);
    view.setLoupeShown(m_loupeShown);
    view.setLabelsShown(m_labelsShown);
    view.setAdjustment(adjustment(view.camera().name));
}

void ViewOptions::applyToAll() const {
    for (CameraView* view : m_grid.views())
        apply(*view);
}

std::optional<QPointF> ViewOptions::jointIn(int camera) const {
    const auto& views = m_reconstructions.selected().views;
    if (camera >= static_cast<int>(views.size()))
        return std::nullopt;
    const core::ViewReconstruction& view = views[static_cast<std::size_t>(camera)];
    if (view.mark && view.mark->state != core::MarkState::Unplaceable)
        return QPointF(view.mark->px.x(), view.mark->px.y());
    if (view.reprojectionPx && view.reprojectionInside)
        return QPointF(view.reprojectionPx->x(), view.reprojectionPx->y());
    return std::nullopt;
}

void ViewOptions::follow() {
    if (!m_following)
        return;
    for (int camera = 0; camera < m_grid.count(); ++camera) {
        const auto joint = jointIn(camera);
        const CameraView& view = *m_grid.view(camera);
        const bool isZoomed = !view.isFitted() || !view.home().isEmpty();
        if (joint && isZoomed)
            m_grid.view(camera)->lookAt(*joint);
    }
}

void ViewOptions::zoomToJoint() {
    for (int camera = 0; camera < m_grid.count(); ++camera)
        if (const auto joint = jointIn(camera))
            m_grid.view(camera)->lookAt(*joint, kJointZoom);
}

void ViewOptions::showWholeImages() {
    for (CameraView* view : m_grid.views()) {
        view->setHome({});
        view->fitImage();
    }
}

} // namespace widgets
