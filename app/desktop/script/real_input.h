// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QKeySequence>
#include <QPointF>
#include <QString>

class QEvent;
class QWidget;

namespace widgets {
class CameraView;
}

namespace app {

class MainWindow;

/// Pointer and keyboard of a script: real events, delivered where a person's would be, through the same hit tests.
/// Every function throws core::Error(Usage) if the place cannot be reached.
class RealInput {
public:
    explicit RealInput(MainWindow& window)
        : m_window(window) {}

    /// Press and release at an image pixel of a view.
    void click(widgets::CameraView& view, QPointF px, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);
    /// Press, `moves` moves on the straight line, release.
    void drag(widgets::CameraView& view, QPointF fromPx, QPointF toPx, Qt::MouseButton button,
              Qt::KeyboardModifiers modifiers, int moves);
    void doubleClick(widgets::CameraView& view, QPointF px);
    void wheel(widgets::CameraView& view, QPointF px, int steps);
    /// A key or a combination such as "Ctrl+Z", held for a time; goes through the shortcuts like any key.
    void key(const QString& keys, int holdMs);

    /// Milliseconds from each event to the end of the painting that it caused, since the last call.
    std::vector<double> takeFrameTimes();

private:
    QWidget* target(widgets::CameraView& view, QPointF px) const;
    void send(QWidget& receiver, QEvent& event);

    MainWindow& m_window;
    std::vector<double> m_frameTimesMs;
};

} // namespace app
