// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <set>
#include <vector>

#include <QObject>

#include "core/io/dataset/dataset.h"
#include "widgets/jobs/job.h"
#include "widgets/presenters/inspect/inspect_layers.h"
#include "widgets/presenters/inspect/inspected_poses.h"
#include "widgets/views/camera/camera_grid.h"

namespace widgets {

/// Draws the layers of inspected methods over the views of a grid whose columns are methods and whose rows are cameras.
/// Made in the background; what has not changed since the last time is neither made nor drawn again.
class InspectOverlays : public QObject {
    Q_OBJECT

public:
    InspectOverlays(CameraGrid& grid, JobPool& pool, QObject* parent = nullptr);

    /// Difference and Field take each other's place.
    void setShown(InspectLayer layer, bool shown);
    bool isShown(InspectLayer layer) const { return m_choice.isShown(layer); }
    const std::set<InspectLayer>& shown() const { return m_choice.shown; }
    /// The direction whose field is shown.
    void setFieldAngleRad(double angleRad);
    double fieldAngleRad() const { return m_choice.fieldAngleRad; }
    /// Which rim points and matches are drawn, and in which colours.
    void setMatchChoice(MatchChoice choice);
    MatchChoice matchChoice() const { return m_choice.matches; }

    /// What the grid shows from now on; a null outcome clears it.
    struct Scene {
        std::shared_ptr<const core::Dataset> dataset;
        std::shared_ptr<const FitOutcome> outcome;
        std::shared_ptr<const InspectedPoses> poses;
        std::vector<int> rowCameras;
        int iteration = 0;
    };
    void show(Scene scene);
    /// Draws everything again: the views have been cleared in the meantime.
    void drawAgain();
    const Scene& scene() const { return m_scene; }
    /// The difference or field that lies over a view; null for none.
    QImage picture(int view) const;
    /// Of the silhouettes of one view, while their difference is shown; else NaN.
    double iou(int view) const;
    /// Whether a forearm is in the view's difference, which does not count.
    bool isWithoutForearm(int view) const;
    bool isWithoutForearm() const; ///< in any view
    /// Reasons for which matches are refused that are drawn now.
    const std::set<core::MatchVerdict>& refusals() const { return m_refusals; }

signals:
    void shownChanged();
    void drawn();

private:
    struct Part;
    using Parts = std::vector<std::shared_ptr<const Part>>; ///< of every view the shapes, then the picture
    static Parts makeParts(const Scene& scene, const OverlayChoice& choice, const Parts& before,
                           const std::stop_token& stop);
    void rebuild();
    static bool hasArrows(const std::shared_ptr<const Part>& now, const std::shared_ptr<const Part>& before);
    void hand(Parts parts);

    CameraGrid& m_grid;
    Job m_job;
    OverlayChoice m_choice;
    Scene m_scene;
    Parts m_drawn;                       ///< in the views; null where nothing is
    std::vector<double> m_ious;          ///< per view
    std::vector<char> m_withoutForearms; ///< per view
    std::set<core::MatchVerdict> m_refusals;
};

} // namespace widgets
