// SPDX-License-Identifier: MIT
#include "widgets/views/camera/camera_view_mouse.h"

#include <cmath>
#include <utility>

namespace widgets {

namespace {

constexpr double kClickScreenPx = 3; // a pointer that moved no further was meant to stay

double distance(QPointF a, QPointF b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace

void CameraViewMouse::press(const QMouseEvent& event) {
    if (m_state != State::Idle)
        return; // a second button while the first one is down
    m_button = event.button();
    m_pressedAt = m_lastAt = event.localPos();
    m_lastClickPlaced = false;
    if (m_button == Qt::LeftButton && (event.modifiers() & Qt::AltModifier)) {
        if (const auto joint = m_surface.markAt(m_pressedAt))
            emit markSelected(*joint);
        m_state = State::Ignoring;
    } else if (m_button == Qt::LeftButton) {
        m_state = State::Pressed;
    } else if (m_button == Qt::MiddleButton) {
        startPanning();
    } else {
        m_state = m_button == Qt::RightButton ? State::RightPressed : State::Ignoring;
    }
}

void CameraViewMouse::move(const QMouseEvent& event) {
    const QPointF position = event.localPos();
    if (m_state == State::Pressed && distance(position, m_pressedAt) > kClickScreenPx)
        begin();
    continueDrag(position);
    emit pointerMoved(m_surface.toImage(position));
}

/// The press has become a drag: of a mark if one lies under it, else of the image.
void CameraViewMouse::begin() {
    const auto joint = m_placingEnabled ? m_surface.markAt(m_pressedAt) : std::nullopt;
    if (!joint) {
        startPanning();
        return;
    }
    m_state = State::DraggingMark;
    m_dragged = *joint;
    const QPointF markPx = m_surface.markPosition(*joint);
    m_grabOffsetPx = markPx - m_surface.toImage(m_pressedAt);
    emit markDragStarted(m_dragged, markPx);
}

void CameraViewMouse::startPanning() {
    m_state = State::Panning;
    emit panningStarted();
}

void CameraViewMouse::continueDrag(QPointF position) {
    if (m_state == State::DraggingMark)
        emit markDragged(m_dragged, m_surface.toImage(position) + m_grabOffsetPx);
    else if (m_state == State::Panning)
        emit panned(position - m_lastAt);
    m_lastAt = position;
}

void CameraViewMouse::release(const QMouseEvent& event) {
    if (event.button() != m_button)
        return;
    const State state = std::exchange(m_state, State::Idle);
    emit ended();
    if (state == State::Pressed && m_placingEnabled) {
        m_lastClickPlaced = true;
        emit pointPlaced(m_surface.toImage(m_pressedAt));
    } else if (state == State::Pressed) {
        emit pointClicked(m_surface.toImage(m_pressedAt));
    } else if (state == State::DraggingMark) {
        emit markDropped(m_dragged, m_surface.toImage(event.localPos()) + m_grabOffsetPx);
    } else if (state == State::RightPressed) {
        const auto joint = m_surface.markAt(m_pressedAt);
        emit contextMenuRequested(m_surface.toImage(m_pressedAt), joint.value_or(core::JointId{}), event.globalPos());
    }
}

void CameraViewMouse::doubleClick(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) {
        press(event);
        return;
    }
    m_button = Qt::LeftButton;
    m_state = State::Ignoring;
    if (std::exchange(m_lastClickPlaced, false))
        emit pointWithdrawn();
    emit maximiseRequested();
}

bool CameraViewMouse::cancel() {
    const State state = m_state;
    if (state == State::Idle)
        return false;
    m_state = State::Ignoring;
    emit ended();
    if (state == State::DraggingMark)
        emit markDragCancelled(m_dragged);
    return state == State::DraggingMark;
}

} // namespace widgets
