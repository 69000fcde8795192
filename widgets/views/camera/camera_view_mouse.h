// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include <QMouseEvent>
#include <QObject>
#include <QPointF>

#include "core/annotation/annotation_set.h"

namespace widgets {

/// What lies under the pointer of a view: how the mouse asks for it.
struct PointerSurface {
    std::function<QPointF(QPointF viewportPoint)> toImage;
    std::function<std::optional<core::JointId>(QPointF viewportPoint)> markAt;
    std::function<QPointF(const core::JointId& joint)> markPosition; ///< image px
};

/// Tells a click from a drag, and what a drag does. Positions are the events' sub-pixel ones; the signals, which are
/// those of the view, say what happened.
class CameraViewMouse : public QObject {
    Q_OBJECT
public:
    explicit CameraViewMouse(PointerSurface surface)
        : m_surface(std::move(surface)) {}

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void doubleClick(const QMouseEvent& event);
    /// Ends a drag; the mark goes back. True if there was one.
    bool cancel();
    bool isDragging() const { return m_state == State::DraggingMark || m_state == State::Panning; }
    void setPlacingEnabled(bool enabled) { m_placingEnabled = enabled; }

signals:
    void pointPlaced(QPointF px);
    void pointClicked(QPointF px);
    void pointWithdrawn();
    void markDragStarted(const core::JointId& joint, QPointF px);
    void markDragged(const core::JointId& joint, QPointF px);
    void markDropped(const core::JointId& joint, QPointF px);
    void markDragCancelled(const core::JointId& joint);
    void markSelected(const core::JointId& joint);
    void contextMenuRequested(QPointF px, const core::JointId& joint, QPoint globalPosition);
    void maximiseRequested();
    void pointerMoved(QPointF px);
    /// The image is about to be dragged.
    void panningStarted();
    void panned(QPointF viewportDelta);
    /// The button is up, or the drag was cancelled: the cursor is the usual one again.
    void ended();

private:
    enum class State { Idle, Pressed, RightPressed, DraggingMark, Panning, Ignoring };

    void begin();
    void startPanning();
    void continueDrag(QPointF position);

    PointerSurface m_surface;
    State m_state = State::Idle;
    Qt::MouseButton m_button = Qt::NoButton;
    QPointF m_pressedAt; ///< viewport
    QPointF m_lastAt;
    core::JointId m_dragged;
    QPointF m_grabOffsetPx; ///< from the pointer to the dragged mark, image px
    bool m_placingEnabled = true;
    bool m_lastClickPlaced = false;
};

} // namespace widgets
