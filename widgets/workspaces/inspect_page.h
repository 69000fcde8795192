// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QStackedWidget>
#include <QWidget>

#include "widgets/document/selection.h"
#include "widgets/document/shown_cameras.h"
#include "widgets/jobs/fit_runner.h"
#include "widgets/jobs/frame_loader.h"
#include "widgets/presenters/inspect_overlays.h"
#include "widgets/presenters/inspected_poses.h"
#include "widgets/session/dataset_session.h"
#include "widgets/views/camera/camera_grid.h"
#include "widgets/views/curve_plot.h"
#include "widgets/workspaces/inspect_layer_bar.h"

namespace widgets {

/// The fitted pair, methods side by side: a column per method, a row per camera, over the pictures of the pair's own
/// test frame, the recorded silhouette as a white line, at the iteration that the slider chooses; below, how error and
/// cost fell.
class InspectPage : public QWidget {
    Q_OBJECT

public:
    InspectPage(const FitRunner& fits, const DatasetSession& datasets, const Selection& selection,
                const ShownCameras& cameras, JobPool& pool, QWidget* parent = nullptr);

    CameraGrid* grid() const { return m_grid; }
    /// 0 is the start pose; methods that ended before stay at their result.
    int iteration() const;
    void setIteration(int iteration);
    int lastIteration() const;
    /// How the meshes are drawn, and whether the start pose and the recorded silhouette are.
    void setLook(const LayerLook& look, bool startShown, bool recordedShown);
    /// The picture of the test frame; null without a fit, or before it has come.
    ImagePyramid picture(int camera) const;
    /// Start, recorded pose and every method at the iteration that is shown, for the scene; none without a fit.
    std::vector<MeshLayer> posedLayers() const;

    /// Which layers are drawn over the views.
    InspectOverlays* overlays() const { return m_overlays; }
    CurvePlot* errorPlot() const { return m_errors; }
    CurvePlot* costPlot() const { return m_costs; }
    /// Cameras that are shown, from the current one on.
    int rows() const { return m_rows->value(); }
    void setRows(int rows) { m_rows->setValue(rows); }
    /// Of a method of the fit, in a camera, at the iteration that is shown.
    ShownMatches matches(const QString& method, int camera) const;

signals:
    /// Other poses are shown: another pair, another iteration, or none.
    void posesShown();
    void pictureShown(int camera);
    void fitRequested();

private:
    void build();
    QWidget* makeEmptyPage();
    QWidget* makeViews();
    QLayout* makeIterationRow();
    void requestPictures();
    void showHint();
    void showFailure(int camera, const QString& message);
    void showLayers();
    void takeOutcome();
    void layOutGrid();
    void showPoses();
    void showPicture(int camera, const ImagePyramid& picture);
    void showCurves();
    void showTitles();
    void showProbe(int view, QPointF px);
    void syncRow(int index);
    std::vector<int> rowCameras() const;
    std::size_t methodCount() const;

    const FitRunner& m_fits;
    const DatasetSession& m_datasets;
    const Selection& m_selection;
    const ShownCameras& m_cameras;
    FrameLoader m_frames; ///< of the pair's test frame, whatever the window's current one is
    std::shared_ptr<const core::Dataset> m_dataset;
    const core::Sequence* m_sequence = nullptr;
    Job m_job;
    QStackedWidget* m_pages;
    QLabel* m_hint;
    QPushButton* m_fit;
    QLabel* m_heading;
    QSlider* m_slider;
    QLabel* m_iterationText;
    QSpinBox* m_rows;
    CameraGrid* m_grid;
    InspectOverlays* m_overlays;
    InspectLayerBar* m_layerBar;
    CurvePlot* m_errors;
    CurvePlot* m_costs;
    std::vector<int> m_rowCameras; ///< per row
    std::shared_ptr<const InspectedPoses> m_posed;
    LayerLook m_look;
    bool m_startShown = false;
    bool m_recordedShown = true;
    bool m_syncing = false;
};

} // namespace widgets
