// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <set>
#include <vector>

#include <QObject>

#include "core/io/dataset/dataset.h"
#include "widgets/jobs/job.h"
#include "widgets/presenters/inspect_layers.h"
#include "widgets/presenters/inspected_poses.h"
#include "widgets/views/camera/camera_grid.h"

namespace widgets {

/// Draws the layers of inspected methods over the views of a grid whose columns are methods and whose rows are cameras.
/// Made in the background.
class InspectOverlays : public QObject {
    Q_OBJECT

public:
    InspectOverlays(CameraGrid& grid, JobPool& pool, QObject* parent = nullptr);

    /// Difference and Field take each other's place.
    void setShown(InspectLayer layer, bool shown);
    bool isShown(InspectLayer layer) const { return m_shown.count(layer) > 0; }
    const std::set<InspectLayer>& shown() const { return m_shown; }
    /// The direction whose field is shown.
    void setFieldAngleRad(double angleRad);
    double fieldAngleRad() const { return m_fieldAngleRad; }

    /// What the grid shows from now on; a null outcome clears it.
    struct Scene {
        std::shared_ptr<const core::Dataset> dataset;
        std::shared_ptr<const FitOutcome> outcome;
        std::shared_ptr<const InspectedPoses> poses;
        std::vector<int> rowCameras;
        int iteration = 0;
    };
    void show(Scene scene);
    const Scene& scene() const { return m_scene; }
    /// Of the silhouettes of one view, while their difference is shown; else NaN.
    double iou(int view) const;

signals:
    void shownChanged();
    void drawn();

private:
    void rebuild();
    void hand(std::vector<InspectOverlay> overlays);

    CameraGrid& m_grid;
    Job m_job;
    std::set<InspectLayer> m_shown;
    double m_fieldAngleRad = 0;
    Scene m_scene;
    std::vector<double> m_ious; ///< per view
};

} // namespace widgets
