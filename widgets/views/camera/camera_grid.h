// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "core/geometry/camera.h"
#include "widgets/views/camera/camera_view.h"

namespace widgets {

/// Camera views side by side, packed so that the least is wasted; one of them can fill the whole grid.
class CameraGrid : public QWidget {
    Q_OBJECT
public:
    explicit CameraGrid(QWidget* parent = nullptr);
    ~CameraGrid() override;

    /// Makes one view per camera (1 to 16, more are possible). Views of the same index are kept, with zoom if the size
    /// stays.
    void setCameras(const std::vector<core::Camera>& cameras);
    int count() const { return static_cast<int>(m_views.size()); }
    CameraView* view(int index) const { return m_views[static_cast<std::size_t>(index)]; }
    /// The view of that camera, or nullptr.
    CameraView* view(const QString& cameraName) const;
    const std::vector<CameraView*>& views() const { return m_views; }

    /// Which views are shown, and in which order (indices; default: all in their order).
    void setOrder(const std::vector<int>& order);
    static constexpr int kPacked = 0;
    /// Fixes the number of columns (inspection: columns are methods), or packs.
    void setFixedColumns(int columns);
    /// Fills the grid with one view; -1 or the maximised one itself goes back. Emits maximisedChanged.
    void setMaximised(int index);
    int maximised() const { return m_maximised; }
    /// The view that key presses are about; drawn with an accent frame.
    void setCurrent(int index);
    int current() const { return m_current; }

    /// What the empty grid says (what to do).
    void setEmptyText(const QString& text);
    /// Completes every view's drawing on this thread (scripts and tests).
    void finishDrawing();
    /// All visible views as one picture.
    QImage grabPicture(double scale = 1) const;

    QSize minimumSizeHint() const override;

signals:
    void maximisedChanged(int index);
    void currentChanged(int index);
    /// A view was created; connect to it here.
    void viewAdded(int index, widgets::CameraView* view);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void layOut();
    std::vector<CameraView*> shownViews() const;

    std::vector<CameraView*> m_views;
    std::vector<int> m_order;
    QString m_emptyText;
    int m_fixedColumns = kPacked;
    int m_maximised = -1;
    int m_current = -1;
};

} // namespace widgets
