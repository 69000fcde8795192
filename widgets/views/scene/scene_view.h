// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <QImage>
#include <QWidget>

#include "core/geometry/camera.h"
#include "widgets/views/camera/mesh_layer.h"
#include "widgets/views/scene/scene_joint.h"

class QMenu;

namespace widgets {

/// The 3D scene: meshes in their layer's colour, cameras as frusta, joints with their uncertainty. A left drag orbits,
/// a middle or Shift+left drag pans, the wheel zooms at the pointer; it can also look through a calibrated camera,
/// exactly.
///
/// Holds the program's only OpenGL widget, in a native window of its own, so that repaints elsewhere stay cheap. Call
/// prepareApplication() before QApplication is made. On a platform without OpenGL (offscreen) it says so instead.
class SceneView : public QWidget {
    Q_OBJECT
public:
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    /// Sets the surface format and the attributes that the scene needs. Before QApplication is made.
    static void prepareApplication();

    void setCameras(const std::vector<core::Camera>& cameras);
    void setMeshLayers(const std::vector<MeshLayer>& layers);
    void setJoints(const std::vector<SceneJoint>& joints);
    void setBones(const std::vector<SceneBone>& bones);
    /// Lines of inspected layers, drawn over everything.
    void setLayerLines(const std::vector<SceneBone>& lines);
    /// The camera whose frustum stands out, or -1.
    void setCurrentCamera(int index);
    /// The image of the current camera: shown on the end of its frustum, and behind the scene when it is looked
    /// through. Null for none.
    void setCameraImage(const QImage& image);
    /// Looks through a camera (index), without its lens; or orbits freely (-1).
    void lookThrough(int camera);
    int lookedThrough() const;
    void setCamerasShown(bool shown);
    void setGridShown(bool shown);
    /// Joints and bones; they are shown at first.
    void setJointsShown(bool shown);

    /// Looks at the hands and the cameras around them. Happens by itself when the first content arrives.
    void resetView();
    /// The scene as it is now, in device pixels. Renders at once.
    QImage grabPicture() const;
    /// Draws now what waits to be drawn.
    void finishDrawing();
    /// Appends "Copy picture", "Save picture...", "Reset view" and "Look through" to a menu.
    void addActions(QMenu& menu);

signals:
    void jointClicked(const core::JointId& joint);
    void cameraClicked(int index);
    void lookedThroughChanged(int index);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Impl;
    void requestRender();
    void renderNow() const;
    void contentChanged();
    bool handlePointer(QEvent* event);
    void click(QPointF place);

    std::unique_ptr<Impl> m_impl;
};

} // namespace widgets
