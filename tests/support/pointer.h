// SPDX-License-Identifier: MIT
#pragma once

#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>

namespace test {

/// Real pointer events at sub-pixel places of a widget (QTest's take whole pixels only).
inline void sendMouse(QWidget* widget, QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons buttons,
                      Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const QPointF global = QPointF(widget->mapToGlobal(QPoint(0, 0))) + at;
    QMouseEvent event(type, at, at, global, button, buttons, modifiers);
    QApplication::sendEvent(widget, &event);
}

inline void press(QWidget* widget, QPointF at, Qt::MouseButton button = Qt::LeftButton,
                  Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    sendMouse(widget, QEvent::MouseButtonPress, at, button, button, modifiers);
}

inline void moveTo(QWidget* widget, QPointF at, Qt::MouseButtons held = Qt::NoButton) {
    sendMouse(widget, QEvent::MouseMove, at, Qt::NoButton, held);
}

inline void release(QWidget* widget, QPointF at, Qt::MouseButton button = Qt::LeftButton) {
    sendMouse(widget, QEvent::MouseButtonRelease, at, button, Qt::NoButton);
}

inline void click(QWidget* widget, QPointF at, Qt::MouseButton button = Qt::LeftButton,
                  Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    press(widget, at, button, modifiers);
    release(widget, at, button);
}

inline void drag(QWidget* widget, QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton) {
    press(widget, from, button);
    constexpr int kSteps = 4;
    for (int i = 1; i <= kSteps; ++i)
        moveTo(widget, from + (to - from) * i / kSteps, button);
    release(widget, to, button);
}

/// What a person's double click sends: press, release, double click, release.
inline void doubleClick(QWidget* widget, QPointF at) {
    click(widget, at);
    sendMouse(widget, QEvent::MouseButtonDblClick, at, Qt::LeftButton, Qt::LeftButton);
    release(widget, at);
}

inline void wheel(QWidget* widget, QPointF at, int steps) {
    const QPointF global = QPointF(widget->mapToGlobal(QPoint(0, 0))) + at;
    QWheelEvent event(at, global, {}, {0, 120 * steps}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
}

} // namespace test
