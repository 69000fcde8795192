// SPDX-License-Identifier: MIT
#pragma once

#include <QMouseEvent>
#include <QPointF>

#include "core/annotation/annotation_set.h"

namespace widgets {

class CameraView;

/// Tells a click from a drag, and what a drag does. Positions are the events' sub-pixel ones; the view's signals say
/// what happened.
class CameraViewMouse {
public:
    explicit CameraViewMouse(CameraView& view)
        : m_view(view) {}

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void doubleClick(const QMouseEvent& event);
    /// Ends a drag; the mark goes back. True if there was one.
    bool cancel();
    bool isDragging() const { return m_state == State::DraggingMark || m_state == State::Panning; }
    void setPlacingEnabled(bool enabled) { m_placingEnabled = enabled; }

private:
    enum class State { Idle, Pressed, RightPressed, DraggingMark, Panning, Ignoring };

    void begin(const QMouseEvent& event);
    void continueDrag(QPointF position);

    CameraView& m_view;
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
