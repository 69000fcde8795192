// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QColor>
#include <QImage>
#include <QWidget>

#include <Eigen/Core>

#include "core/annotation/annotation_set.h"
#include "core/geometry/camera.h"
#include "widgets/views/mesh_layer.h"

namespace widgets {

/// A 3D joint in the scene.
struct SceneJoint {
    core::JointId joint;
    Eigen::Vector3d pointInWorld;              ///< mm
    std::optional<Eigen::Matrix3d> covariance; ///< mm^2; drawn as the 95 % ellipsoid
    QColor colour;
    bool selected = false;
};

/// A bone between two joints in the world, mm.
struct SceneBone {
    Eigen::Vector3d from;
    Eigen::Vector3d to;
    QColor colour;
};

/// The 3D scene: meshes in their layer's colour, cameras as frusta, joints with their uncertainty. Left drag orbits,
/// middle or Shift+left drag pans, right drag or the wheel zooms; it can also look through a calibrated camera,
/// exactly.
///
/// Holds the program's only OpenGL widget, in a native window of its own. QApplication must have been made with
/// AA_DontCreateNativeWidgetSiblings and SceneView::useSurfaceFormat(). Without OpenGL (the offscreen platform) it says
/// so instead.
class SceneView : public QWidget {
    Q_OBJECT
public:
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    /// Sets the default surface format and the attributes that the scene needs. Call before QApplication is made.
    static void prepareApplication();

    void setCameras(const std::vector<core::Camera>& cameras);
    void setMeshLayers(const std::vector<MeshLayer>& layers);
    void setJoints(const std::vector<SceneJoint>& joints);
    void setBones(const std::vector<SceneBone>& bones);
    /// The camera whose frustum stands out, or -1.
    void setCurrentCamera(int index);
    /// The image shown on the far end of the current camera's frustum and behind the scene when looking through it;
    /// null for none.
    void setCameraImage(const QImage& image);
    /// Looks through a camera (index) or orbits freely (-1).
    void lookThrough(int camera);
    int lookedThrough() const;
    void setCamerasShown(bool shown);
    void setGridShown(bool shown);

    /// Looks at everything from the front: at the meshes and joints if there are any, else at the cameras.
    void resetView();
    /// The scene as a picture of the widget's size times `scale`.
    QImage grabPicture(double scale = 1) const;

signals:
    void jointClicked(const core::JointId& joint);
    void cameraClicked(int index);
    void lookedThroughChanged(int index);

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace widgets
