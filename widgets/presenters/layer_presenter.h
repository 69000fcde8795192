// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QObject>
#include <QStringList>

#include "core/io/dataset/dataset.h"
#include "widgets/document/selection.h"
#include "widgets/jobs/fit_runner.h"
#include "widgets/jobs/job.h"
#include "widgets/presenters/layer_look.h"
#include "widgets/views/camera/camera_grid.h"
#include "widgets/views/scene/scene_view.h"

namespace widgets {

/// Shows meshes over the views and in the scene: the recorded pose of the current frame and, on the test frame of the
/// last fit, the start pose and every method's result in its colour. Surfaces are posed in the background. The scene
/// shows one pose at a time, the recorded one or one method's: several would hide each other.
class LayerPresenter : public QObject {
    Q_OBJECT

public:
    static constexpr const char* kRecorded = "recorded";
    static constexpr const char* kStart = "start";

    /// `scene` may be null.
    LayerPresenter(const Selection& selection, const FitRunner& fits, CameraGrid& grid, SceneView* scene, JobPool& pool,
                   QObject* parent = nullptr);

    void setSequence(std::shared_ptr<const core::Dataset> dataset, std::shared_ptr<const core::Motion> motion);
    void setLook(const LayerLook& look);
    const LayerLook& look() const { return m_look; }
    /// `layer` is kRecorded, kStart or a method's name.
    void setLayerShown(const QString& layer, bool shown);
    bool isLayerShown(const QString& layer) const { return !m_hidden.count(layer); }
    /// The hand models that were fitted to the annotations, shown as a layer of their own; an empty pose leaves that
    /// hand out, nothing takes the layer away.
    void setAnnotatedPose(const std::optional<core::HandPoses>& poses, int frame);

    /// Inspected poses, which the scene shows instead of those of the current frame; empty for the current frame's.
    void setInspected(std::optional<std::vector<MeshLayer>> layers);
    bool showsInspected() const { return m_inspected.has_value(); }
    /// Each way of inspecting has an opacity of its own: over footage that is clicked in, meshes must not hide it.
    void setInspecting(bool inspecting);

    /// What the scene can show, by name: kRecorded or a method's.
    QStringList sceneChoices() const;
    QString sceneChoice() const;
    void setSceneChoice(const QString& layer);

signals:
    void sceneChoicesChanged();
    void lookChanged();
    /// The layers of the current frame are in the views.
    void shown();

private:
    struct Wanted {
        QString name;
        QColor colour;
        core::HandPoses poses;
    };
    std::vector<Wanted> wantedLayers() const;
    void rebuild();
    void hand(const std::vector<MeshLayer>& layers);
    void applyLook();
    void showScene();
    const std::vector<MeshLayer>& sceneSource() const { return m_inspected ? *m_inspected : m_layers; }

    const Selection& m_selection;
    const FitRunner& m_fits;
    CameraGrid& m_grid;
    SceneView* m_scene;
    Job m_job;
    std::shared_ptr<const core::Dataset> m_dataset;
    std::shared_ptr<const core::Motion> m_motion;
    std::optional<core::HandPoses> m_annotatedPose;
    int m_annotatedFrame = -1;
    static constexpr double kInspectingOpacity = 0.85;
    LayerLook m_look;
    double m_otherOpacity = kInspectingOpacity; ///< of Inspect while not in it, and the other way round
    bool m_inspecting = false;
    QString m_sceneChoice; ///< the last one that was asked for
    std::optional<std::vector<MeshLayer>> m_inspected;
    std::set<QString> m_hidden;
    std::vector<MeshLayer> m_layers; ///< of the current frame, both hands
};

} // namespace widgets
