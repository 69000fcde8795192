// SPDX-License-Identifier: MIT
#include "widgets/presenters/layer_presenter.h"

#include <algorithm>

#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

constexpr const char* kAnnotated = "annotated";
const QColor kAnnotatedColour(0x4D, 0xA3, 0xFF);

std::vector<ViewSurfacePtr> surfacesOf(const core::Dataset& dataset, const core::HandPoses& poses) {
    std::vector<ViewSurfacePtr> surfaces;
    for (std::size_t i = 0; i < dataset.hands.size() && i < poses.size(); ++i)
        if (poses[i].size() > 0) // else this hand has no pose
            surfaces.push_back(makeViewSurface(dataset.hands[i], poses[i]));
    return surfaces;
}

} // namespace

LayerPresenter::LayerPresenter(const Selection& selection, const FitRunner& fits, CameraGrid& grid, SceneView* scene,
                               JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_selection(selection)
    , m_fits(fits)
    , m_grid(grid)
    , m_scene(scene)
    , m_job(pool) {
    connect(&selection, &Selection::frameChanged, this, &LayerPresenter::rebuild);
    connect(&fits, &FitRunner::finished, this, &LayerPresenter::rebuild);
    connect(&fits, &FitRunner::cleared, this, &LayerPresenter::rebuild);
}

void LayerPresenter::setSequence(std::shared_ptr<const core::Dataset> dataset,
                                 std::shared_ptr<const core::Motion> motion) {
    m_dataset = std::move(dataset);
    m_motion = std::move(motion);
    m_annotatedPose.reset();
    rebuild();
}

void LayerPresenter::setLook(const LayerLook& look) {
    m_look = look;
    applyLook();
    emit lookChanged();
}

void LayerPresenter::setLayerShown(const QString& layer, bool shown) {
    if (shown)
        m_hidden.erase(layer);
    else
        m_hidden.insert(layer);
    rebuild();
    emit lookChanged();
}

void LayerPresenter::setAnnotatedPose(const std::optional<core::HandPoses>& poses, int frame) {
    m_annotatedPose = poses;
    m_annotatedFrame = frame;
    rebuild();
}

std::vector<LayerPresenter::Wanted> LayerPresenter::wantedLayers() const {
    std::vector<Wanted> wanted;
    const auto add = [&](const QString& name, const QColor& colour, const core::HandPoses& poses) {
        if (isLayerShown(name) && !poses.empty())
            wanted.push_back({name, colour, poses});
    };
    const int frame = m_selection.frame();
    if (m_motion && frame < static_cast<int>(m_motion->size()))
        add(kRecorded, methodColour(kRecorded), (*m_motion)[static_cast<std::size_t>(frame)]);
    if (m_annotatedPose && m_annotatedFrame == frame)
        add(kAnnotated, kAnnotatedColour, *m_annotatedPose);
    const auto& outcome = m_fits.outcome();
    if (outcome && outcome->request.test == frame) {
        add(kStart, methodColour("start"), outcome->startPoses);
        for (const MethodOutcome& method : outcome->methods)
            add(QString::fromStdString(method.method), methodColour(method.method), method.result.poses);
    }
    return wanted;
}

void LayerPresenter::rebuild() {
    const auto wanted = wantedLayers();
    if (!m_dataset || wanted.empty()) {
        m_job.stop();
        hand({});
        return;
    }
    m_job.start([this, wanted, dataset = m_dataset](const JobContext& context) -> Job::Delivery {
        std::vector<MeshLayer> layers;
        for (const Wanted& layer : wanted) {
            if (context.stop.stop_requested())
                return {};
            MeshLayer made;
            made.name = layer.name;
            made.colour = layer.colour;
            made.surfaces = surfacesOf(*dataset, layer.poses);
            layers.push_back(std::move(made));
        }
        return [this, layers] { hand(layers); };
    });
}

void LayerPresenter::hand(const std::vector<MeshLayer>& layers) {
    m_layers = layers;
    applyLook();
    emit sceneChoicesChanged();
    emit shown();
}

void LayerPresenter::applyLook() {
    std::vector<MeshLayer> layers;
    for (const MeshLayer& layer : m_layers)
        if (auto seen = withLook(layer, m_look))
            layers.push_back(std::move(*seen));
    for (CameraView* view : m_grid.views())
        view->setMeshLayers(m_look.style == MeshStyle::Off ? std::vector<MeshLayer>{} : layers);
    showScene();
}

void LayerPresenter::setInspected(std::optional<std::vector<MeshLayer>> layers) {
    if (layers == m_inspected)
        return;
    m_inspected = std::move(layers);
    showScene();
    emit sceneChoicesChanged();
}

void LayerPresenter::setInspecting(bool inspecting) {
    if (inspecting == m_inspecting)
        return;
    m_inspecting = inspecting;
    std::swap(m_look.opacity, m_otherOpacity);
    applyLook();
    emit lookChanged();
}

QStringList LayerPresenter::sceneChoices() const {
    QStringList names;
    for (const MeshLayer& layer : sceneSource())
        if (layer.name != QLatin1String(kStart) && layer.name != QLatin1String(kAnnotated) && !layer.surfaces.empty())
            names << layer.name;
    return names;
}

/// The one that was asked for, else the first method, else the recorded pose.
QString LayerPresenter::sceneChoice() const {
    const QStringList names = sceneChoices();
    if (names.contains(m_sceneChoice))
        return m_sceneChoice;
    return names.size() > 1 && names.front() == QLatin1String(kRecorded) ? names[1] : names.value(0);
}

void LayerPresenter::setSceneChoice(const QString& layer) {
    m_sceneChoice = layer;
    showScene();
    emit sceneChoicesChanged();
}

void LayerPresenter::showScene() {
    if (!m_scene)
        return;
    LayerLook look = m_look;
    look.opacity = std::min(1.0, look.opacity / (m_inspecting ? kInspectingOpacity : LayerLook().opacity));
    if (!m_inspecting && look.style == MeshStyle::Off) // the footage is to be seen; the scene has no footage
        look.style = MeshStyle::Shaded;
    const QString choice = sceneChoice();
    std::vector<MeshLayer> layers;
    for (const MeshLayer& layer : sceneSource()) {
        const bool isBeside =
            (layer.name == QLatin1String(kStart) && isLayerShown(kStart)) || layer.name == QLatin1String(kAnnotated);
        if (!isBeside && layer.name != choice)
            continue;
        if (auto seen = withLook(layer, look))
            layers.push_back(std::move(*seen));
    }
    m_scene->setMeshLayers(layers);
}

} // namespace widgets
