// SPDX-License-Identifier: MIT
#include "widgets/views/scene/scene_view.h"

#include <cmath>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVBoxLayout>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include "widgets/views/picture_export.h"
#include "widgets/views/scene/scene_stage.h"

namespace widgets {

namespace {

constexpr double kClickScreenPx = 3;
constexpr double kReachScreenPx = 10;
constexpr double kZoomPerStep = 1.2;
constexpr double kFastMs = 8; ///< a picture that takes less is drawn at once
constexpr int kPauseMs = 200; ///< longer than a step of a dragged setting takes: the views have the processor first
constexpr int kLongestWaitMs = 500;

bool hasOpenGl() {
    const QString platform = QGuiApplication::platformName();
    return platform != QLatin1String("offscreen") && platform != QLatin1String("minimal");
}

} // namespace

struct SceneView::Impl {
    SceneStage stage;
    QVTKOpenGLNativeWidget* gl = nullptr; ///< nullptr without OpenGL
    QTimer renderTimer;
    QElapsedTimer waiting; ///< since the first change that is not drawn yet
    double lastRenderMs = 0;
    bool viewChosen = false; ///< by the user, or by the first content
    Qt::MouseButton button = Qt::NoButton;
    QPointF pressedAt, lastAt;
    bool dragging = false;

    QSize deviceSize() const { return gl ? (QSizeF(gl->size()) * gl->devicePixelRatioF()).toSize() : QSize(1, 1); }
};

void SceneView::prepareApplication() {
    QCoreApplication::setAttribute(Qt::AA_DontCreateNativeWidgetSiblings);
    QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
}

SceneView::SceneView(QWidget* parent)
    : QWidget(parent)
    , m_impl(std::make_unique<Impl>()) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    m_impl->renderTimer.setSingleShot(true);
    connect(&m_impl->renderTimer, &QTimer::timeout, this, &SceneView::renderNow);
    if (!hasOpenGl()) {
        auto* label = new QLabel(tr("The 3D scene needs OpenGL, which this display does not have."), this);
        label->setAlignment(Qt::AlignCenter);
        label->setWordWrap(true);
        layout->addWidget(label);
        return;
    }
    // Without a native window of its own, the GL widget would make every repaint of the main window a composition on
    // the GPU.
    auto* host = new QWidget(this);
    host->setAttribute(Qt::WA_DontCreateNativeAncestors);
    host->setAttribute(Qt::WA_NativeWindow);
    layout->addWidget(host);
    auto* inner = new QVBoxLayout(host);
    inner->setContentsMargins(0, 0, 0, 0);
    m_impl->gl = new QVTKOpenGLNativeWidget(host);
    m_impl->gl->setFocusPolicy(Qt::NoFocus);
    m_impl->gl->setMinimumSize(80, 60);
    inner->addWidget(m_impl->gl);
    const auto window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
    window->SetMultiSamples(0); // the stage smooths edges in another way, which is far cheaper without a graphics card
    m_impl->gl->setRenderWindow(window);
    window->GetInteractor()->SetInteractorStyle(nullptr);
    m_impl->stage.putInto(*window);
    m_impl->stage.setBackground(palette().color(QPalette::Base));
    m_impl->gl->installEventFilter(this);
}

SceneView::~SceneView() = default;

/// Many changes in a row, such as a drag, are one picture: where drawing is slow, it waits until they pause, but not
/// for ever.
void SceneView::contentChanged() {
    if (!m_impl->viewChosen && !m_impl->stage.isEmpty())
        m_impl->stage.resetOrbit(m_impl->deviceSize());
    if (!m_impl->gl || !isVisible())
        return;
    if (m_impl->lastRenderMs < kFastMs) {
        requestRender();
        return;
    }
    if (!m_impl->renderTimer.isActive())
        m_impl->waiting.start();
    if (!m_impl->renderTimer.isActive() || m_impl->waiting.elapsed() < kLongestWaitMs)
        m_impl->renderTimer.start(kPauseMs);
}

void SceneView::setCameras(const std::vector<core::Camera>& cameras) {
    m_impl->stage.setCameras(cameras);
    contentChanged();
}

void SceneView::setMeshLayers(const std::vector<MeshLayer>& layers) {
    m_impl->stage.setMeshLayers(layers);
    contentChanged();
}

void SceneView::setJoints(const std::vector<SceneJoint>& joints) {
    m_impl->stage.setJoints(joints);
    contentChanged();
}

void SceneView::setBones(const std::vector<SceneBone>& bones) {
    m_impl->stage.setBones(bones);
    contentChanged();
}

void SceneView::setLayerLines(const std::vector<SceneBone>& lines) {
    m_impl->stage.setLayerLines(lines);
    contentChanged();
}

void SceneView::setCurrentCamera(int index) {
    m_impl->stage.setCurrentCamera(index);
    contentChanged();
}

void SceneView::setCameraImage(const QImage& image) {
    m_impl->stage.setCameraImage(image);
    contentChanged();
}

void SceneView::lookThrough(int camera) {
    const int before = lookedThrough();
    m_impl->stage.setLookedThrough(camera);
    requestRender();
    if (lookedThrough() != before)
        emit lookedThroughChanged(lookedThrough());
}

int SceneView::lookedThrough() const {
    return m_impl->stage.lookedThrough();
}

void SceneView::setCamerasShown(bool shown) {
    m_impl->stage.setCamerasShown(shown);
    requestRender();
}

void SceneView::setGridShown(bool shown) {
    m_impl->stage.setGridShown(shown);
    requestRender();
}

void SceneView::setJointsShown(bool shown) {
    if (m_impl->stage.setJointsShown(shown))
        requestRender();
}

void SceneView::resetView() {
    lookThrough(-1);
    m_impl->stage.resetOrbit(m_impl->deviceSize());
    m_impl->viewChosen = false;
    requestRender();
}

void SceneView::requestRender() {
    if (m_impl->gl && isVisible())
        m_impl->renderTimer.start(0); // several changes at once are one picture
}

void SceneView::finishDrawing() {
    if (m_impl->renderTimer.isActive()) {
        m_impl->renderTimer.stop();
        renderNow();
    }
}

void SceneView::renderNow() const {
    if (m_impl->gl && m_impl->gl->isValid()) {
        QElapsedTimer clock;
        clock.start();
        m_impl->stage.prepare(m_impl->deviceSize());
        m_impl->gl->renderWindow()->Render();
        m_impl->lastRenderMs = static_cast<double>(clock.nsecsElapsed()) / 1e6;
    }
}

QImage SceneView::grabPicture() const {
    if (!m_impl->gl || !m_impl->gl->isValid())
        return const_cast<SceneView*>(this)->grab().toImage();
    renderNow();
    return m_impl->gl->grabFramebuffer().convertToFormat(QImage::Format_RGB32);
}

void SceneView::addActions(QMenu& menu) {
    connect(menu.addAction(tr("Reset view")), &QAction::triggered, this, &SceneView::resetView);
    QMenu* through = menu.addMenu(tr("Look through"));
    for (int i = 0; i < static_cast<int>(m_impl->stage.cameras().size()); ++i) {
        const QString name = QString::fromStdString(m_impl->stage.cameras()[static_cast<std::size_t>(i)].name);
        QAction* action = through->addAction(name);
        action->setCheckable(true);
        action->setChecked(i == lookedThrough());
        connect(action, &QAction::triggered, this, [this, i] { lookThrough(i == lookedThrough() ? -1 : i); });
    }
    through->setEnabled(!through->isEmpty());
    menu.addSeparator();
    addPictureActions(menu, this, {[this](double) { return grabPicture(); }, {}, tr("scene"), {}});
}

void SceneView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        m_impl->stage.setBackground(palette().color(QPalette::Base));
        requestRender();
    }
}

bool SceneView::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_impl->gl)
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show) {
        if (!m_impl->viewChosen && !m_impl->stage.isEmpty())
            m_impl->stage.resetOrbit(m_impl->deviceSize());
        requestRender();
        return false;
    }
    return handlePointer(event);
}

/// Pointer events never reach VTK's own interactor. True if the event was one.
bool SceneView::handlePointer(QEvent* event) {
    Impl& s = *m_impl;
    const int height = s.gl->height();
    if (event->type() == QEvent::MouseButtonPress) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        s.button = mouse->button();
        s.pressedAt = s.lastAt = mouse->localPos();
        s.dragging = false;
    } else if (event->type() == QEvent::MouseMove) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const QPointF place = mouse->localPos(), moved = place - s.pressedAt;
        s.dragging = s.dragging || (s.button != Qt::NoButton && std::hypot(moved.x(), moved.y()) > kClickScreenPx);
        if (s.dragging) {
            const bool pans = s.button == Qt::MiddleButton || (mouse->modifiers() & Qt::ShiftModifier);
            if (lookedThrough() >= 0) {
                s.stage.orbit().standAt(s.stage.cameras()[static_cast<std::size_t>(lookedThrough())].centreInWorld());
                lookThrough(-1);
            }
            if (s.button == Qt::LeftButton && !pans)
                s.stage.orbit().orbit(place - s.lastAt, height);
            else if (pans)
                s.stage.orbit().pan(place - s.lastAt, height);
            s.viewChosen = true;
            requestRender();
        }
        s.lastAt = place;
    } else if (event->type() == QEvent::MouseButtonRelease) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const bool wasClick = !s.dragging && mouse->button() == s.button;
        s.button = Qt::NoButton;
        s.dragging = false;
        if (wasClick && mouse->button() == Qt::LeftButton) {
            click(mouse->localPos());
        } else if (wasClick && mouse->button() == Qt::RightButton) {
            QMenu menu;
            addActions(menu);
            menu.exec(mouse->globalPos());
        }
    } else if (event->type() == QEvent::Wheel) {
        const auto* wheel = static_cast<QWheelEvent*>(event);
        if (lookedThrough() < 0) {
            const QPointF middle(s.gl->width() / 2.0, height / 2.0);
            s.stage.orbit().zoom(std::pow(kZoomPerStep, wheel->angleDelta().y() / 120.0), wheel->position() - middle,
                                 height);
            s.viewChosen = true;
            requestRender();
        }
    } else {
        return event->type() == QEvent::MouseButtonDblClick || event->type() == QEvent::ContextMenu;
    }
    event->accept();
    return true;
}

void SceneView::click(QPointF place) {
    const double ratio = m_impl->gl->devicePixelRatioF();
    m_impl->stage.prepare(m_impl->deviceSize());
    if (const auto joint = m_impl->stage.jointAt(place * ratio, kReachScreenPx * ratio))
        emit jointClicked(*joint);
    else if (const int camera = m_impl->stage.cameraAt(place * ratio, 1.5 * kReachScreenPx * ratio); camera >= 0)
        emit cameraClicked(camera);
}

} // namespace widgets
