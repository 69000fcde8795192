// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <vector>

#include <QObject>

#include "widgets/jobs/job.h"
#include "widgets/presenters/inspect/inspect_overlays.h"
#include "widgets/presenters/layer_presenter.h"
#include "widgets/views/scene/scene_joint.h"
#include "widgets/views/scene/scene_view.h"

namespace widgets {

/// What the layers of an inspected method mean in space, as lines in the world (mm):
/// Error: from every joint of the truth to the same one of the method, by length;
/// Matches: for rim points that were kept in the shown cameras, from the nearest vertex to the viewing ray of its
/// contour point, by residual, and a piece of that ray; Uncertainty: the axes of every joint's 95 % ellipsoid. `method`
/// is an index into the outcome's; none for poses that no method found.
std::vector<SceneBone> inspectSceneLines(const InspectOverlays::Scene& scene, std::size_t method,
                                         const std::set<InspectLayer>& shown);

/// Draws them in the 3D scene, of the method whose pose stands there, while a pair is inspected.
class InspectSceneLines : public QObject {
    Q_OBJECT

public:
    InspectSceneLines(const InspectOverlays& overlays, const LayerPresenter& layers, SceneView& scene, JobPool& pool,
                      QObject* parent = nullptr);

private:
    /// What the lines depend on.
    struct Source {
        std::shared_ptr<const FitOutcome> outcome;
        std::shared_ptr<const InspectedPoses> poses;
        std::vector<int> rowCameras;
        int iteration = 0;
        std::size_t method = 0;
        std::set<InspectLayer> shown; ///< of the layers that have lines
        bool operator==(const Source&) const = default;
    };
    void refresh();
    void setLines(const std::vector<SceneBone>& lines);

    const InspectOverlays& m_overlays;
    const LayerPresenter& m_layers;
    SceneView& m_scene;
    Job m_job;
    Source m_source;
    bool m_hasLines = false;
};

} // namespace widgets
