// SPDX-License-Identifier: MIT
#include "widgets/views/scene/scene_stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include <vtkAxesActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCaptionActor2D.h>
#include <vtkLight.h>
#include <vtkTextProperty.h>

#include "core/geometry/camera_target.h"

namespace widgets {

namespace {

const QColor kFrustum(0x8A, 0x90, 0x99);
const QColor kCurrentFrustum(0x4D, 0xA3, 0xFF);
constexpr double kJointRadiusMm = 2.2;
constexpr double kGridSpacingMm = 50;
constexpr int kGridCells = 16;

void replace(vtkRenderer& renderer, std::vector<ActorPtr>& actors, std::vector<ActorPtr> by) {
    for (const ActorPtr& actor : actors)
        renderer.RemoveActor(actor);
    actors = std::move(by);
    for (const ActorPtr& actor : actors)
        renderer.AddActor(actor);
}

void replace(vtkRenderer& renderer, ActorPtr& actor, const ActorPtr& by) {
    if (actor)
        renderer.RemoveActor(actor);
    actor = by;
    if (actor)
        renderer.AddActor(actor);
}

/// The world's vertical as the cameras see it, snapped to an axis that is near.
Eigen::Vector3d verticalOf(const std::vector<core::Camera>& cameras) {
    Eigen::Vector3d up = Eigen::Vector3d::Zero();
    for (const core::Camera& camera : cameras)
        up -= camera.cameraFromWorld.rotation.row(1);
    if (up.norm() < 0.2 * static_cast<double>(cameras.size()) || cameras.empty())
        return -Eigen::Vector3d::UnitY();
    up.normalize();
    Eigen::Index axis = 0;
    up.cwiseAbs().maxCoeff(&axis);
    constexpr double kNear = 0.9; // within 26 degrees
    return std::abs(up[axis]) > kNear ? Eigen::Vector3d(Eigen::Vector3d::Unit(axis) * (up[axis] > 0 ? 1 : -1)) : up;
}

vtkSmartPointer<vtkProp> makeName(const core::Camera& camera, const QColor& colour) {
    auto text = vtkSmartPointer<vtkBillboardTextActor3D>::New();
    text->SetInput(camera.name.c_str());
    text->SetPosition(camera.centreInWorld().data());
    text->SetDisplayOffset(6, 4);
    text->GetTextProperty()->SetFontSize(13);
    text->GetTextProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
    return text;
}

} // namespace

SceneStage::SceneStage()
    : m_world(vtkSmartPointer<vtkRenderer>::New())
    , m_front(vtkSmartPointer<vtkRenderer>::New())
    , m_triad(vtkSmartPointer<vtkRenderer>::New()) {
    m_front->SetLayer(1);
    m_front->SetActiveCamera(m_world->GetActiveCamera());
    m_front->InteractiveOff();
    m_triad->SetLayer(1);
    m_triad->SetViewport(0, 0, 0.14, 0.14);
    m_triad->InteractiveOff();
    auto axes = vtkSmartPointer<vtkAxesActor>::New();
    axes->SetXAxisLabelText("x");
    axes->SetYAxisLabelText("y");
    axes->SetZAxisLabelText("z");
    m_triad->AddActor(axes);
    for (vtkRenderer* renderer : {m_world.Get(), m_front.Get()}) {
        auto light = vtkSmartPointer<vtkLight>::New();
        light->SetLightTypeToHeadlight();
        light->SetIntensity(0.75);
        renderer->AddLight(light);
        auto key = vtkSmartPointer<vtkLight>::New();
        key->SetLightTypeToCameraLight();
        key->SetPosition(-0.6, 0.8, 1.0);
        key->SetIntensity(0.45);
        renderer->AddLight(key);
        renderer->SetAutomaticLightCreation(0);
    }
}

void SceneStage::putInto(vtkRenderWindow& window) {
    window.SetNumberOfLayers(2);
    window.AddRenderer(m_world);
    window.AddRenderer(m_front);
    window.AddRenderer(m_triad);
    m_world->UseFXAAOn();
    m_front->UseFXAAOn();
}

void SceneStage::setBackground(const QColor& colour) {
    const QColor top = colour.lighter(125), bottom = colour.darker(115);
    m_world->SetBackground(bottom.redF(), bottom.greenF(), bottom.blueF());
    m_world->SetBackground2(top.redF(), top.greenF(), top.blueF());
    m_world->GradientBackgroundOn();
    m_foreground = colour.lightnessF() < 0.5 ? QColor(Qt::white) : QColor(Qt::black);
    rebuildCameras();
    rebuildGrid();
}

void SceneStage::setCameras(const std::vector<core::Camera>& cameras) {
    m_cameras = cameras;
    m_lookedThrough = m_lookedThrough < static_cast<int>(cameras.size()) ? m_lookedThrough : -1;
    m_currentCamera = m_currentCamera < static_cast<int>(cameras.size()) ? m_currentCamera : -1;
    rebuildCameras();
    rebuildImage();
    rebuildGrid();
}

void SceneStage::setMeshLayers(const std::vector<MeshLayer>& layers) {
    m_layers = layers;
    std::vector<ActorPtr> actors;
    for (const MeshLayer& layer : layers) {
        if (layer.style == MeshStyle::Off)
            continue;
        for (const ViewSurfacePtr& surface : layer.surfaces)
            actors.push_back(makeMeshActor(*surface, layer));
    }
    const bool hadNone = m_meshActors.empty();
    replace(*m_world, m_meshActors, std::move(actors));
    if (hadNone)
        rebuildGrid();
}

void SceneStage::setJoints(const std::vector<SceneJoint>& joints) {
    m_joints = joints;
    std::vector<ActorPtr> actors;
    for (const SceneJoint& joint : joints) {
        const double radius = joint.selected ? 1.5 * kJointRadiusMm : kJointRadiusMm;
        actors.push_back(makeJointActor(joint, radius));
        if (joint.selected)
            actors.push_back(makeHaloActor(joint.pointInWorld, 1.45 * radius));
        if (joint.covariance)
            actors.push_back(makeEllipsoidActor(joint));
    }
    replace(*m_front, m_jointActors, std::move(actors));
}

void SceneStage::setBones(const std::vector<SceneBone>& bones) {
    replace(*m_front, m_bonesActor, bones.empty() ? ActorPtr() : makeBonesActor(bones));
}

void SceneStage::setLayerLines(const std::vector<SceneBone>& lines) {
    replace(*m_front, m_linesActor, lines.empty() ? ActorPtr() : makeBonesActor(lines));
}

void SceneStage::setCurrentCamera(int index) {
    m_currentCamera = index >= 0 && index < static_cast<int>(m_cameras.size()) ? index : -1;
    rebuildCameras();
    rebuildImage();
}

void SceneStage::setCameraImage(const QImage& image) {
    m_cameraImage = image;
    rebuildImage();
}

void SceneStage::setCamerasShown(bool shown) {
    m_camerasShown = shown;
    showCameras();
}

void SceneStage::setGridShown(bool shown) {
    m_gridShown = shown;
    rebuildGrid();
}

bool SceneStage::setJointsShown(bool shown) {
    m_front->SetDraw(shown);
    return std::exchange(m_jointsShown, shown) != shown;
}

void SceneStage::setLookedThrough(int camera) {
    m_lookedThrough = camera >= 0 && camera < static_cast<int>(m_cameras.size()) ? camera : -1;
    showCameras();
    rebuildImage();
    rebuildGrid();
}

SceneStage::Ball SceneStage::handsBall() const {
    Eigen::AlignedBox3d box;
    for (const MeshLayer& layer : m_layers) {
        for (const ViewSurfacePtr& surface : layer.surfaces)
            for (const Eigen::Vector3d& v : surface->verticesInWorld)
                box.extend(v);
    }
    for (const SceneJoint& joint : m_joints)
        box.extend(joint.pointInWorld);
    return box.isEmpty() ? Ball{} : Ball{box.center(), std::max(30.0, box.diagonal().norm() / 2)};
}

/// The point that the optical axes come nearest to, and how far the cameras are from it.
SceneStage::Ball SceneStage::camerasBall() const {
    if (m_cameras.empty())
        return {};
    Ball ball{core::commonTargetNearOrigin(m_cameras), 0};
    for (const core::Camera& camera : m_cameras)
        ball.radiusMm = std::max(ball.radiusMm, (camera.centreInWorld() - ball.centre).norm());
    return ball;
}

double SceneStage::frustumDepthMm() const {
    const Ball ball = camerasBall();
    return std::max(20.0, 0.16 * ball.radiusMm);
}

void SceneStage::rebuildCameras() {
    std::vector<ActorPtr> frusta;
    for (const vtkSmartPointer<vtkProp>& name : m_cameraNames)
        m_world->RemoveViewProp(name);
    m_cameraNames.clear();
    for (int i = 0; i < static_cast<int>(m_cameras.size()); ++i) {
        const core::Camera& camera = m_cameras[static_cast<std::size_t>(i)];
        const bool current = i == m_currentCamera;
        frusta.push_back(
            makeFrustumActor(camera, frustumDepthMm(), current ? kCurrentFrustum : kFrustum, current ? 2 : 1));
        m_cameraNames.push_back(makeName(camera, current ? kCurrentFrustum : m_foreground));
        m_world->AddViewProp(m_cameraNames.back());
    }
    replace(*m_world, m_frustumActors, std::move(frusta));
    showCameras();
}

void SceneStage::showCameras() {
    const bool shown = m_camerasShown && m_lookedThrough < 0;
    for (const ActorPtr& actor : m_frustumActors)
        actor->SetVisibility(shown);
    for (const vtkSmartPointer<vtkProp>& name : m_cameraNames)
        name->SetVisibility(shown);
}

/// The image stands at the end of the current camera's frustum, or behind everything when that camera is looked
/// through.
void SceneStage::rebuildImage() {
    const int index = m_lookedThrough >= 0 ? m_lookedThrough : m_currentCamera;
    if (m_cameraImage.isNull() || index < 0 || (m_lookedThrough >= 0 && m_lookedThrough != m_currentCamera)) {
        replace(*m_world, m_imageActor, nullptr);
        return;
    }
    const double depth = m_lookedThrough >= 0 ? 3 * std::max(100.0, camerasBall().radiusMm) : frustumDepthMm();
    replace(*m_world, m_imageActor, makeImageActor(m_cameras[static_cast<std::size_t>(index)], m_cameraImage, depth));
}

void SceneStage::rebuildGrid() {
    if (!m_gridShown || isEmpty() || m_lookedThrough >= 0) {
        replace(*m_world, m_gridActor, nullptr);
        return;
    }
    const Ball hands = handsBall(), cameras = camerasBall();
    const Ball& middle = hands.radiusMm > 0 ? hands : cameras;
    const Eigen::Vector3d up = verticalOf(m_cameras);
    const double below = hands.radiusMm > 0 ? 0.8 * hands.radiusMm : 0.3 * cameras.radiusMm;
    QColor colour = m_foreground;
    const bool dark = m_foreground == QColor(Qt::white);
    colour = dark ? QColor(0x45, 0x49, 0x50) : QColor(0xB4, 0xB8, 0xBE);
    replace(*m_world, m_gridActor, makeGridActor(middle.centre - below * up, up, kGridSpacingMm, kGridCells, colour));
}

void SceneStage::resetOrbit(QSize window) {
    const Ball hands = handsBall(), cameras = camerasBall();
    const Ball& middle = hands.radiusMm > 0 ? hands : cameras;
    m_orbit.up = verticalOf(m_cameras);
    m_orbit.focus = middle.centre;
    const Eigen::Vector3d front = m_cameras.empty() ? Eigen::Vector3d(-Eigen::Vector3d::UnitZ())
                                                    : Eigen::Vector3d(m_cameras[0].centreInWorld() - middle.centre);
    const Eigen::Vector3d level = (front - m_orbit.up * front.dot(m_orbit.up)).normalized();
    constexpr double kAboveRad = 0.38, kAsideRad = 0.35; // so that depth is seen
    const Eigen::Vector3d aside = Eigen::AngleAxisd(kAsideRad, m_orbit.up) * level;
    m_orbit.away = std::cos(kAboveRad) * aside + std::sin(kAboveRad) * m_orbit.up;
    m_orbit.frame(middle.centre, std::max(1.15 * hands.radiusMm, 0.28 * cameras.radiusMm), window);
}

DepthRange SceneStage::depthRange(const Eigen::Vector3d& eye, const Eigen::Vector3d& forward) const {
    double nearest = 1e9, farthest = -1e9;
    for (vtkRenderer* renderer : {m_world.Get(), m_front.Get()}) {
        double b[6];
        renderer->ComputeVisiblePropBounds(b);
        if (b[0] > b[1])
            continue;
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3d p(b[corner & 1], b[2 + (corner >> 1 & 1)], b[4 + (corner >> 2)]);
            nearest = std::min(nearest, (p - eye).dot(forward));
            farthest = std::max(farthest, (p - eye).dot(forward));
        }
    }
    farthest = std::max(10.0, farthest * 1.02);
    return {std::clamp(nearest * 0.98, farthest / 2000, farthest * 0.9), farthest};
}

void SceneStage::prepare(QSize window) {
    m_window = window;
    vtkCamera& camera = *m_world->GetActiveCamera();
    if (m_lookedThrough >= 0) {
        const core::Camera& through = m_cameras[static_cast<std::size_t>(m_lookedThrough)];
        const DepthRange depths = depthRange(through.centreInWorld(), through.cameraFromWorld.rotation.row(2));
        setCalibrated(camera, fittedToWindow(through, window), depths);
    } else {
        setOrbiting(camera, m_orbit);
        const DepthRange depths = depthRange(m_orbit.eye(), -m_orbit.away);
        camera.SetClippingRange(depths.nearMm, depths.farMm);
    }
    const Eigen::Vector3d back(camera.GetDirectionOfProjection());
    const Eigen::Vector3d eye = -5 * back;
    vtkCamera& triad = *m_triad->GetActiveCamera();
    triad.SetFocalPoint(0, 0, 0);
    triad.SetPosition(eye.data());
    triad.SetViewUp(camera.GetViewUp());
    m_triad->ResetCameraClippingRange();
}

std::optional<QPointF> SceneStage::placeOf(const Eigen::Vector3d& pointInWorld) const {
    vtkCamera& camera = *m_world->GetActiveCamera();
    const double aspect = static_cast<double>(m_window.width()) / m_window.height();
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> clipFromWorld(
        camera.GetCompositeProjectionTransformMatrix(aspect, -1, 1)->GetData());
    const Eigen::Vector4d clip = clipFromWorld * pointInWorld.homogeneous();
    if (clip.w() <= 0)
        return std::nullopt;
    return QPointF((clip.x() / clip.w() + 1) / 2 * m_window.width() - 0.5,
                   (1 - clip.y() / clip.w()) / 2 * m_window.height() - 0.5);
}

std::optional<core::JointId> SceneStage::jointAt(QPointF place, double reachPx) const {
    if (!m_jointsShown)
        return std::nullopt;
    const SceneJoint* nearest = nullptr;
    double nearestDistance = reachPx;
    for (const SceneJoint& joint : m_joints) {
        const auto at = placeOf(joint.pointInWorld);
        const double distance = at ? std::hypot(at->x() - place.x(), at->y() - place.y()) : 1e9;
        if (distance <= nearestDistance) {
            nearest = &joint;
            nearestDistance = distance;
        }
    }
    return nearest ? std::optional(nearest->joint) : std::nullopt;
}

int SceneStage::cameraAt(QPointF place, double reachPx) const {
    if (!m_camerasShown || m_lookedThrough >= 0)
        return -1;
    int nearest = -1;
    double nearestDistance = reachPx;
    for (std::size_t i = 0; i < m_cameras.size(); ++i) {
        const auto at = placeOf(m_cameras[i].centreInWorld());
        const double distance = at ? std::hypot(at->x() - place.x(), at->y() - place.y()) : 1e9;
        if (distance <= nearestDistance) {
            nearest = static_cast<int>(i);
            nearestDistance = distance;
        }
    }
    return nearest;
}

} // namespace widgets
