// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QSize>

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "widgets/views/scene/orbit_camera.h"
#include "widgets/views/scene/scene_actors.h"
#include "widgets/views/scene/scene_camera.h"

namespace widgets {

/// What stands in the 3D scene and how it is looked at: VTK without a widget. Meshes, frusta and the grid hide each
/// other; joints and bones are drawn over them, so that flesh does not hide the skeleton.
class SceneStage {
public:
    SceneStage();

    /// Draws into this window from now on.
    void putInto(vtkRenderWindow& window);
    void setBackground(const QColor& colour);

    void setCameras(const std::vector<core::Camera>& cameras);
    void setMeshLayers(const std::vector<MeshLayer>& layers);
    void setJoints(const std::vector<SceneJoint>& joints);
    void setBones(const std::vector<SceneBone>& bones);
    void setLayerLines(const std::vector<SceneBone>& lines);
    void setCurrentCamera(int index);
    void setCameraImage(const QImage& image);
    void setCamerasShown(bool shown);
    void setGridShown(bool shown);
    bool setJointsShown(bool shown); ///< whether that changes anything
    void setLookedThrough(int camera);

    const std::vector<core::Camera>& cameras() const { return m_cameras; }
    int lookedThrough() const { return m_lookedThrough; }
    OrbitCamera& orbit() { return m_orbit; }
    bool isEmpty() const { return m_cameras.empty() && m_layers.empty() && m_joints.empty(); }

    /// Looks at the hands with the nearer part of the cameras around them, from the first camera's side and a little
    /// above.
    void resetOrbit(QSize window);
    /// Sets up the cameras of all renderers for a window of this size (device px) and brings the actors up to date.
    void prepare(QSize window);

    /// What is drawn at a place (device px, y down) of the window that was last prepared.
    std::optional<core::JointId> jointAt(QPointF place, double reachPx) const;
    int cameraAt(QPointF place, double reachPx) const;
    /// Where a world point is drawn (device px, centres at integers); empty behind the eye.
    std::optional<QPointF> placeOf(const Eigen::Vector3d& pointInWorld) const;

private:
    struct Ball {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        double radiusMm = 0;
    };
    Ball handsBall() const;
    Ball camerasBall() const;
    double frustumDepthMm() const;
    void rebuildCameras();
    void rebuildImage();
    void rebuildGrid();
    DepthRange depthRange(const Eigen::Vector3d& eye, const Eigen::Vector3d& forward) const;
    void showCameras();

    vtkSmartPointer<vtkRenderer> m_world;
    vtkSmartPointer<vtkRenderer> m_front;
    vtkSmartPointer<vtkRenderer> m_triad;
    std::vector<ActorPtr> m_meshActors;
    std::vector<ActorPtr> m_frustumActors;
    std::vector<vtkSmartPointer<vtkProp>> m_cameraNames;
    std::vector<ActorPtr> m_jointActors;
    ActorPtr m_bonesActor;
    ActorPtr m_linesActor;
    ActorPtr m_imageActor;
    ActorPtr m_gridActor;

    std::vector<core::Camera> m_cameras;
    std::vector<MeshLayer> m_layers;
    std::vector<SceneJoint> m_joints;
    QImage m_cameraImage;
    QColor m_foreground = Qt::white;
    OrbitCamera m_orbit;
    QSize m_window{1, 1};
    int m_currentCamera = -1;
    int m_lookedThrough = -1;
    bool m_camerasShown = true;
    bool m_gridShown = true;
    bool m_jointsShown = true;
};

} // namespace widgets
