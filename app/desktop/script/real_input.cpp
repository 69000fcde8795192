// SPDX-License-Identifier: MIT
#include "app/desktop/script/real_input.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QPointer>
#include <QWheelEvent>
#include <QWindow>

#include "app/desktop/main_window.h"
#include "app/desktop/script/idle_wait.h"
#include "core/error.h"

// Delivers a key as the window system does: shortcuts first, then the widget with the keyboard. Exported by Qt for its
// test library.
Q_GUI_EXPORT void qt_handleKeyEvent(QWindow* window, QEvent::Type type, int key, Qt::KeyboardModifiers modifiers,
                                    const QString& text = QString(), bool autoRepeat = false, ushort count = 1);

namespace app {

namespace {

constexpr int kWheelStep = 120;
constexpr int kActivationMs = 1000;

core::Error unreachable(const QString& why) {
    return {core::ErrorCode::Usage, {}, {}, why.toStdString()};
}

/// The widget's position in the window, kept in sub-pixels.
QPointF inWindow(const QWidget& widget, QPointF position) {
    const QPoint origin = widget.mapTo(widget.window(), QPoint(0, 0));
    return position + origin;
}

QMouseEvent mouseEvent(QEvent::Type type, const QWidget& receiver, QPointF position, Qt::MouseButton button,
                       Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
    const QPointF windowPosition = inWindow(receiver, position);
    const QPointF screenPosition = windowPosition + receiver.window()->mapToGlobal(QPoint(0, 0));
    return {type, position, windowPosition, screenPosition, button, buttons, modifiers};
}

} // namespace

QWidget* RealInput::target(widgets::CameraView& view, QPointF px) const {
    const QString name = QString::fromStdString(view.camera().name);
    QWidget* viewport = view.viewport();
    const QPointF position = view.imageToViewport(px);
    if (!view.isVisible() || !QRectF(viewport->rect()).contains(position))
        throw unreachable(QStringLiteral("pixel %1, %2 of %3 is not on the screen").arg(px.x()).arg(px.y()).arg(name));
    QWidget* top = view.window();
    const QWidget* hit = top->childAt(viewport->mapTo(top, position.toPoint()));
    if (hit != viewport)
        throw unreachable(QStringLiteral("pixel %1, %2 of %3 is covered").arg(px.x()).arg(px.y()).arg(name));
    return viewport;
}

void RealInput::send(QWidget& receiver, QEvent& event) {
    QElapsedTimer timer;
    timer.start();
    QCoreApplication::sendEvent(&receiver, &event);
    QCoreApplication::sendPostedEvents();
    m_frameTimesMs.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
}

void RealInput::click(widgets::CameraView& view, QPointF px, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    QWidget* viewport = target(view, px);
    const QPointF position = view.imageToViewport(px);
    QMouseEvent move = mouseEvent(QEvent::MouseMove, *viewport, position, Qt::NoButton, Qt::NoButton, modifiers);
    send(*viewport, move);
    QMouseEvent press = mouseEvent(QEvent::MouseButtonPress, *viewport, position, button, button, modifiers);
    send(*viewport, press);
    QMouseEvent release = mouseEvent(QEvent::MouseButtonRelease, *viewport, position, button, Qt::NoButton, modifiers);
    send(*viewport, release);
}

void RealInput::drag(widgets::CameraView& view, QPointF fromPx, QPointF toPx, Qt::MouseButton button,
                     Qt::KeyboardModifiers modifiers, int moves) {
    QWidget* viewport = target(view, fromPx);
    const QPointF from = view.imageToViewport(fromPx);
    const QPointF to = view.imageToViewport(toPx);
    QMouseEvent hover = mouseEvent(QEvent::MouseMove, *viewport, from, Qt::NoButton, Qt::NoButton, modifiers);
    send(*viewport, hover);
    QMouseEvent press = mouseEvent(QEvent::MouseButtonPress, *viewport, from, button, button, modifiers);
    send(*viewport, press);
    for (int i = 1; i <= moves; ++i) {
        const QPointF position = from + (to - from) * (static_cast<double>(i) / moves);
        QMouseEvent move = mouseEvent(QEvent::MouseMove, *viewport, position, Qt::NoButton, button, modifiers);
        send(*viewport, move);
    }
    QMouseEvent release = mouseEvent(QEvent::MouseButtonRelease, *viewport, to, button, Qt::NoButton, modifiers);
    send(*viewport, release);
}

void RealInput::doubleClick(widgets::CameraView& view, QPointF px) {
    click(view, px, Qt::LeftButton, Qt::NoModifier);
    QWidget* viewport = target(view, px);
    const QPointF position = view.imageToViewport(px);
    QMouseEvent twice =
        mouseEvent(QEvent::MouseButtonDblClick, *viewport, position, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    send(*viewport, twice);
    QMouseEvent release =
        mouseEvent(QEvent::MouseButtonRelease, *viewport, position, Qt::LeftButton, Qt::NoButton, Qt::NoModifier);
    send(*viewport, release);
}

void RealInput::wheel(widgets::CameraView& view, QPointF px, int steps) {
    QWidget* viewport = target(view, px);
    const QPointF position = view.imageToViewport(px);
    const QPointF screen = inWindow(*viewport, position) + viewport->window()->mapToGlobal(QPoint(0, 0));
    for (int i = 0; i < std::abs(steps); ++i) {
        QWheelEvent turn(position, screen, QPoint(), QPoint(0, steps > 0 ? kWheelStep : -kWheelStep), Qt::NoButton,
                         Qt::NoModifier, Qt::NoScrollPhase, false);
        send(*viewport, turn);
    }
}

void RealInput::key(const QString& keys, int holdMs) {
    const QKeySequence sequence = QKeySequence::fromString(keys, QKeySequence::PortableText);
    if (sequence.count() != 1 || (sequence[0] & ~static_cast<int>(Qt::KeyboardModifierMask)) == Qt::Key_unknown)
        throw unreachable(QStringLiteral("\"%1\" is an unknown key").arg(keys));
    const int key = sequence[0] & ~static_cast<int>(Qt::KeyboardModifierMask);
    const Qt::KeyboardModifiers modifiers(sequence[0] & static_cast<int>(Qt::KeyboardModifierMask));
    const bool printable = key < 0x80 && !(modifiers & ~Qt::KeyboardModifiers(Qt::ShiftModifier));
    const QChar letter = modifiers & Qt::ShiftModifier ? QChar(key) : QChar(key).toLower();
    const QString text = printable ? QString(letter) : QString();
    // A dialog that has just closed may still be named as the active window.
    const auto shownWindow = [] {
        const QWidget* window = QApplication::activeWindow();
        return window && window->isVisible() ? window : nullptr;
    };
    if (!QApplication::activePopupWidget() &&
        !shownWindow()) { // no window manager gives the keyboard back after a dialog
        m_window.activateWindow();
        waitFor(
            m_window, [&] { return shownWindow() != nullptr; }, kActivationMs);
    }
    const QWidget* popup = QApplication::activePopupWidget();
    const QWidget* active = popup ? popup : shownWindow() ? shownWindow() : &m_window;
    const QPointer<QWindow> window = active->windowHandle();
    QElapsedTimer timer;
    timer.start();
    qt_handleKeyEvent(window, QEvent::KeyPress, key, modifiers, text);
    QCoreApplication::sendPostedEvents();
    m_frameTimesMs.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
    if (holdMs > 0)
        waitMs(holdMs);
    // The key may have closed the window that it was pressed in.
    qt_handleKeyEvent(window ? window.data() : m_window.windowHandle(), QEvent::KeyRelease, key, modifiers, text);
    QCoreApplication::sendPostedEvents();
}

std::vector<double> RealInput::takeFrameTimes() {
    return std::exchange(m_frameTimesMs, {});
}

} // namespace app
