// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QStackedWidget>
#include <QToolButton>
#include <QWidget>

#include "widgets/document/selection.h"
#include "widgets/document/shown_cameras.h"
#include "widgets/jobs/fit_runner.h"
#include "widgets/panels/compare/camera_choice.h"
#include "widgets/panels/compare/column_bar.h"
#include "widgets/presenters/inspect/inspected_poses.h"
#include "widgets/presenters/inspect_columns.h"
#include "widgets/session/dataset_session.h"
#include "widgets/views/curve_plot.h"
#include "widgets/views/message_bar.h"
#include "widgets/workspaces/inspect_grid.h"
#include "widgets/workspaces/inspect_joint_errors.h"
#include "widgets/workspaces/inspect_layer_bar.h"
#include "widgets/workspaces/inspect_probe_pin.h"

namespace widgets {

/// The fitted pair, methods side by side: the views of InspectGrid, the recorded silhouette as a white line, at the
/// iteration that the slider chooses; below, how error and cost fell.
class InspectPage : public QWidget {
    Q_OBJECT

public:
    InspectPage(FitRunner& fits, const DatasetSession& datasets, const Selection& selection,
                const ShownCameras& cameras, JobPool& pool, QWidget* parent = nullptr);

    CameraGrid* grid() const { return m_views->grid(); }
    InspectGrid* views() const { return m_views; }
    InspectColumns* columns() const { return m_columns; }
    /// 0 is the start pose; methods that ended before stay at their result.
    int iteration() const;
    void setIteration(int iteration);
    int lastIteration() const;
    /// Which pair is shown, and which iteration, in words; empty without a fit.
    QString heading() const;
    /// What is tried instead of what was fitted, in words; empty for nothing. Numbers stand with it wherever they go.
    QString trialText() const;
    QString iterationText() const { return m_iterationText->text(); }
    /// How the meshes are drawn, and whether the start pose and the recorded silhouette are.
    void setLook(const LayerLook& look, bool startShown, bool recordedShown);
    /// The picture of the test frame; null without a fit, or before it has come.
    ImagePyramid picture(int camera) const { return m_views->picture(camera); }
    /// Start, recorded pose and every method at the iteration that is shown, for the scene; none without a fit.
    std::vector<MeshLayer> posedLayers() const;

    /// Which layers are drawn over the views.
    InspectOverlays* overlays() const { return m_views->overlays(); }
    InspectLayerBar* layerBar() const { return m_layerBar; }
    InspectJointErrors* jointErrors() const { return m_joints; }
    CurvePlot* errorPlot() const { return m_errors; }
    CurvePlot* costPlot() const { return m_costs; }
    /// Cameras that are shown, from the current one on.
    int rows() const { return m_rows->value(); }
    void setRows(int rows) { m_rows->setValue(rows); }
    InspectProbePin* probePin() const { return m_probePin; }
    ColumnBar* columnBar() const { return m_columnBar; }

signals:
    /// Other poses are shown: another pair, another iteration, or none.
    void posesShown();
    void pictureShown(int camera);
    void fitRequested();
    /// What is tried is to go.
    void trialEnded();
    /// A joint of the drawing was clicked.
    void jointChosen(const core::JointId& joint);

private:
    void build();
    QWidget* makeEmptyPage();
    QWidget* makeViews();
    QLayout* makeIterationRow();
    void showHint();
    void showCameras();
    void takeColumns();
    void takePreviews();
    void showRange(bool isSamePair);
    void showPoses();
    void showCurves();
    void showPhases();
    void showProbe(int view, QPointF px);
    void showProbeAgain();
    void showErrors();
    void showPinned();
    void showLegend();
    void showTrial();

    const FitRunner& m_fits;
    const DatasetSession& m_datasets;
    Job m_job;
    InspectColumns* m_columns;
    std::shared_ptr<const FitOutcome> m_shown; ///< of which the curves are
    QStackedWidget* m_pages;
    QLabel* m_hint;
    QPushButton* m_fit;
    MessageBar* m_message;
    QLabel* m_heading;
    QLabel* m_trial;
    QToolButton* m_endTrial;
    QSlider* m_slider;
    QLabel* m_iterationText;
    QSpinBox* m_rows;
    InspectGrid* m_views;
    ColumnBar* m_columnBar;
    CameraChoice* m_cameraChoice;
    InspectLayerBar* m_layerBar;
    InspectJointMarks* m_jointMarks;
    ProbeTargets m_probeTargets;
    InspectProbePin* m_probePin;
    InspectJointErrors* m_joints;
    CurvePlot* m_errors;
    CurvePlot* m_costs;
    std::shared_ptr<const InspectedPoses> m_posed;
    std::shared_ptr<const InspectedPoses> m_posedBefore; ///< the last ones of this pair
    std::optional<std::pair<int, QPointF>> m_pointed;    ///< view and pixel under the pointer
    bool m_recordedShown = true;
};

} // namespace widgets
