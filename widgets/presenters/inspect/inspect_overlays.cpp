// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect/inspect_overlays.h"

#include <algorithm>

#include "core/contour/side_by_side.h"
#include "widgets/presenters/inspect/inspect_uncertainty.h"

namespace widgets {

/// What half of a view's overlay is made from: the same makes the same.
struct OverlaySource {
    std::shared_ptr<const core::FitTrace> trace; ///< of one fit, and of no other
    std::string method;
    int camera = -1;
    int iteration = 0;
    std::vector<ViewSurfacePtr> surfaces;
    OverlayChoice choice;
    bool operator==(const OverlaySource&) const = default;
};

namespace {

constexpr double kFieldOpacity = 0.6, kDifferenceOpacity = 1;

std::set<InspectLayer> shownOf(const OverlayChoice& choice, std::initializer_list<InspectLayer> layers) {
    std::set<InspectLayer> shown;
    for (const InspectLayer layer : layers)
        if (choice.isShown(layer))
            shown.insert(layer);
    return shown;
}

OverlaySource shapesSource(const MethodOutcome& method, int camera, int iteration, const OverlayChoice& choice) {
    const int last = static_cast<int>(method.result.history.size());
    return {
        method.result.trace,
        method.method,
        camera,
        std::min(iteration, last),
        {},
        {shownOf(choice, {InspectLayer::Contour, InspectLayer::Rim, InspectLayer::Matches, InspectLayer::Uncertainty}),
         0, choice.matches}};
}

OverlayShapes joined(const OverlayShapes& below, OverlayShapes above) {
    above.lines.insert(above.lines.begin(), below.lines.begin(), below.lines.end());
    above.dots.insert(above.dots.begin(), below.dots.begin(), below.dots.end());
    return above;
}

/// The field is the same at every pose.
OverlaySource pictureSource(const MethodOutcome& method, int camera, int iteration, const OverlayChoice& choice,
                            const MeshLayer& posed) {
    OverlaySource source = shapesSource(method, camera, iteration, choice);
    source.choice = {shownOf(choice, {InspectLayer::Difference, InspectLayer::Field}), 0, {}};
    if (choice.isShown(InspectLayer::Field))
        source.choice.fieldAngleRad = choice.fieldAngleRad;
    if (choice.isShown(InspectLayer::Difference))
        source.surfaces = posed.surfaces;
    else
        source.iteration = 0;
    return source;
}

} // namespace

struct InspectOverlays::Part {
    OverlaySource source;
    InspectOverlay overlay;
};

InspectOverlays::InspectOverlays(CameraGrid& grid, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_grid(grid)
    , m_job(pool) {
    connect(
        &grid, &CameraGrid::viewAdded, this,
        [this](int view) {
            for (const auto part : {2 * static_cast<std::size_t>(view), 2 * static_cast<std::size_t>(view) + 1})
                if (part < m_drawn.size())
                    m_drawn[part].reset(); // a new view is empty
        });
}

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
    if (layer == InspectLayer::Error)
        emit drawn(); // the colour of the meshes, and no overlay
    else
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

QImage InspectOverlays::picture(int view) const {
    const std::size_t part = 2 * static_cast<std::size_t>(view) + 1;
    return part < m_drawn.size() && m_drawn[part] ? m_drawn[part]->overlay.field : QImage();
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

void InspectOverlays::drawAgain() {
    std::fill(m_drawn.begin(), m_drawn.end(), nullptr);
    rebuild();
}

InspectOverlays::Parts InspectOverlays::makeParts(const Scene& scene, const OverlayChoice& choice, const Parts& before,
                                                  const std::stop_token& stop) {
    const std::size_t columns = scene.outcome->methods.size();
    Parts parts(2 * scene.rowCameras.size() * columns);
    const auto makeOne = [&](std::size_t place) {
        const std::size_t view = place / 2, m = view % columns;
        const int camera = scene.rowCameras[view / columns];
        const MeshLayer posed = scene.poses && m < scene.poses->methods.size() ? scene.poses->methods[m] : MeshLayer();
        const MethodOutcome& method = scene.outcome->methods[m];
        OverlaySource source = place % 2 == 0 ? shapesSource(method, camera, scene.iteration, choice)
                                              : pictureSource(method, camera, scene.iteration, choice, posed);
        if (place < before.size() && before[place] && before[place]->source == source) {
            parts[place] = before[place];
            return;
        }
        auto part = std::make_shared<Part>();
        part->overlay = inspectOverlay(method, *scene.dataset, camera, scene.iteration, source.choice, posed);
        if (source.choice.isShown(InspectLayer::Uncertainty) && isAtResult(method, scene.iteration))
            addUncertainty(jointUncertainties(*scene.dataset, method),
                           scene.dataset->cameras[static_cast<std::size_t>(camera)], part->overlay.shapes);
        part->source = std::move(source);
        parts[place] = std::move(part);
    };
    core::forEachSideBySide(parts.size(), [&](std::size_t place) {
        if (!stop.stop_requested())
            makeOne(place);
    });
    return parts;
}

void InspectOverlays::rebuild() {
    const bool isEmpty = std::all_of(m_choice.shown.begin(), m_choice.shown.end(),
                                     [](InspectLayer layer) { return layer == InspectLayer::Error; });
    if (!m_scene.outcome || !m_scene.dataset || isEmpty) {
        m_job.stop();
        hand({});
        return;
    }
    m_job.start(
        [this, scene = m_scene, choice = m_choice, before = m_drawn](const JobContext& context) -> Job::Delivery {
            auto parts = std::make_shared<Parts>(makeParts(scene, choice, before, context.stop));
            return [this, parts] { hand(std::move(*parts)); };
        });
}

bool InspectOverlays::hasArrows(const std::shared_ptr<const Part>& now, const std::shared_ptr<const Part>& before) {
    const auto has = [](const std::shared_ptr<const Part>& part) {
        return part && !part->overlay.shapes.lines.empty();
    };
    return has(now) || has(before);
}

void InspectOverlays::hand(Parts parts) {
    static const InspectOverlay kNothing;
    const auto count = static_cast<std::size_t>(m_grid.count());
    const auto overlayOf = [](const std::shared_ptr<const Part>& part) -> const InspectOverlay& {
        return part ? part->overlay : kNothing;
    };
    parts.resize(2 * count);
    m_drawn.resize(2 * count);
    m_ious.clear();
    m_withoutForearms.clear();
    m_refusals.clear();
    const bool isDifference = isShown(InspectLayer::Difference);
    for (std::size_t view = 0; view < count; ++view) {
        const InspectOverlay &shapes = overlayOf(parts[2 * view]), &picture = overlayOf(parts[2 * view + 1]);
        CameraView& shown = *m_grid.view(static_cast<int>(view));
        const bool isOtherPicture = parts[2 * view + 1] != m_drawn[2 * view + 1];
        if (parts[2 * view] != m_drawn[2 * view] ||
            (isOtherPicture && hasArrows(parts[2 * view + 1], m_drawn[2 * view + 1])))
            shown.setShapes(joined(picture.shapes, shapes.shapes));
        if (isOtherPicture)
            shown.setFieldImage(picture.field, isDifference ? kDifferenceOpacity : kFieldOpacity, isDifference);
        m_ious.push_back(picture.iou);
        m_withoutForearms.push_back(picture.isWithoutForearm ? 1 : 0);
        m_refusals.insert(shapes.refusals.begin(), shapes.refusals.end());
    }
    m_drawn = std::move(parts);
    emit drawn();
}

} // namespace widgets
