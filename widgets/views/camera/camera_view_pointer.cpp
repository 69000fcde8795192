// SPDX-License-Identifier: MIT
#include <cmath>

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "widgets/views/camera/camera_view.h"
#include "widgets/views/camera/camera_view_mouse.h"

// What a camera view does with mouse and keys.

namespace widgets {

namespace {

constexpr double kZoomPerStep = 1.25; // per notch of the wheel

} // namespace

std::unique_ptr<CameraViewMouse> CameraView::makeMouse() {
    auto mouse = std::make_unique<CameraViewMouse>(
        PointerSurface{[this](QPointF at) { return viewportToImage(at); }, [this](QPointF at) { return markAt(at); },
                       [this](const core::JointId& joint) { return markPosition(joint); }});
    using Mouse = CameraViewMouse;
    connect(mouse.get(), &Mouse::pointPlaced, this, &CameraView::pointPlaced);
    connect(mouse.get(), &Mouse::pointClicked, this, &CameraView::pointClicked);
    connect(mouse.get(), &Mouse::pointWithdrawn, this, &CameraView::pointWithdrawn);
    connect(mouse.get(), &Mouse::markDragStarted, this, &CameraView::markDragStarted);
    connect(mouse.get(), &Mouse::markDragged, this, &CameraView::markDragged);
    connect(mouse.get(), &Mouse::markDropped, this, &CameraView::markDropped);
    connect(mouse.get(), &Mouse::markDragCancelled, this, &CameraView::markDragCancelled);
    connect(mouse.get(), &Mouse::markSelected, this, &CameraView::markSelected);
    connect(mouse.get(), &Mouse::contextMenuRequested, this, &CameraView::contextMenuRequested);
    connect(mouse.get(), &Mouse::maximiseRequested, this, &CameraView::maximiseRequested);
    connect(mouse.get(), &Mouse::pointerMoved, this, &CameraView::pointerMoved);
    connect(mouse.get(), &Mouse::panningStarted, this, [this] { viewport()->setCursor(Qt::ClosedHandCursor); });
    connect(mouse.get(), &Mouse::panned, this, &CameraView::panBy);
    connect(mouse.get(), &Mouse::ended, this, &CameraView::updateCursor);
    return mouse;
}

void CameraView::mousePressEvent(QMouseEvent* event) {
    m_mouse->press(*event);
}

void CameraView::mouseMoveEvent(QMouseEvent* event) {
    m_mouse->move(*event);
    if (m_loupeShown)
        moveLoupe(event->localPos());
}

void CameraView::mouseReleaseEvent(QMouseEvent* event) {
    m_mouse->release(*event);
}
void CameraView::mouseDoubleClickEvent(QMouseEvent* event) {
    m_mouse->doubleClick(*event);
}

void CameraView::wheelEvent(QWheelEvent* event) {
    constexpr double kAnglePerStep = 120;
    zoomAt(event->position(), std::pow(kZoomPerStep, event->angleDelta().y() / kAnglePerStep));
    if (m_loupeShown)
        moveLoupe(event->position());
    event->accept();
}

/// The menu opens when the right button is released (CameraViewMouse); the menu key asks for it in the middle of the
/// view.
void CameraView::contextMenuEvent(QContextMenuEvent* event) {
    if (event->reason() == QContextMenuEvent::Keyboard) {
        const QPoint middle = viewport()->rect().center();
        emit contextMenuRequested(viewportToImage(middle), markAt(middle).value_or(core::JointId{}),
                                  viewport()->mapToGlobal(middle));
    }
    event->accept();
}

void CameraView::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape || !m_mouse->cancel())
        event->ignore(); // keys are the window's
}

void CameraView::keyReleaseEvent(QKeyEvent* event) {
    event->ignore();
}

bool CameraView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
        m_mouse->isDragging()) {
        event->accept(); // Escape ends the drag before it means anything else
        return true;
    }
    return QGraphicsView::event(event);
}

void CameraView::focusOutEvent(QFocusEvent* event) {
    m_mouse->cancel();
    QGraphicsView::focusOutEvent(event);
}

} // namespace widgets
