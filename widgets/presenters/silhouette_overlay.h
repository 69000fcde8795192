// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QPointF>

#include "widgets/jobs/silhouette_study.h"
#include "widgets/views/camera/camera_grid.h"

namespace widgets {

/// A silhouette as it lies over a picture: tinted inside, its outline and the forearm's cut in full strength.
/// Premultiplied ARGB of the mask's size.
QImage silhouettePicture(const core::Silhouette& silhouette);

/// Shows silhouettes in all camera views and, with the brush on, lets them be touched up there: the left button paints
/// foreground, the right one (or Shift) background, Ctrl and the wheel change the brush's size.
class SilhouetteOverlay : public QObject {
    Q_OBJECT

public:
    SilhouetteOverlay(SilhouetteStudy& study, CameraGrid& grid, QObject* parent = nullptr);
    ~SilhouetteOverlay() override;

    void setBrushOn(bool on);
    bool isBrushOn() const { return m_brushOn; }
    /// Radius, image px; kept within 1 to 200.
    void setBrushRadius(double radiusPx);
    double brushRadius() const { return m_radiusPx; }

signals:
    void brushChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show(int camera);
    void clear();
    void watchViews();
    int viewOf(const QObject* viewport) const;
    bool press(int camera, const QMouseEvent& event);
    void paintTo(QPointF px);
    void refreshCursors();

    SilhouetteStudy& m_study;
    CameraGrid& m_grid;
    bool m_brushOn = false;
    double m_radiusPx = 12;
    int m_camera = -1; ///< that a stroke is being made in
    bool m_isForeground = true;
    QPointF m_lastPx;
    cv::Mat m_stroke; ///< the mask with the stroke
};

} // namespace widgets
