// SPDX-License-Identifier: MIT
#pragma once

#include <QPointer>
#include <QWidget>

#include "widgets/views/camera/camera_view.h"

namespace widgets {

/// Lies over a view and shows another one of the same camera to the right of a line that can be dragged: a wipe. All
/// the way to the left it shows the other view alone, which is how two views blink.
class WipeCover : public QWidget {
    Q_OBJECT

public:
    WipeCover(CameraView& over, const CameraView& other);

    /// Where the line is, as a share of the width: 0 shows the other view alone, 1 hides it.
    void setPlace(double share);
    double place() const { return m_place; }
    const CameraView* other() const { return m_other; }

signals:
    void dragged(double share);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void layOut();
    void paintName(QPainter& painter) const;
    int line() const;

    QWidget* m_area; ///< the view's viewport
    QPointer<const CameraView> m_other;
    double m_place = 0.5;
    bool m_dragging = false;
    bool m_grabbing = false;
};

} // namespace widgets
