// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QWidget>

#include "widgets/panels/compare/what_if_panel.h"
#include "widgets/panels/fitting_panel.h"
#include "widgets/panels/joints_panel.h"
#include "widgets/panels/quality/quality_panel.h"
#include "widgets/panels/raters_panel.h"
#include "widgets/panels/review/review_panel.h"
#include "widgets/panels/scene_panel.h"
#include "widgets/panels/view_panel.h"
#include "widgets/presenters/frame_pictures.h"
#include "widgets/presenters/hand_framing.h"
#include "widgets/presenters/layer_presenter.h"
#include "widgets/presenters/mark_presenter.h"
#include "widgets/presenters/residual_arrows.h"
#include "widgets/presenters/view_options.h"
#include "widgets/session/mask_attacher.h"
#include "widgets/session/window_session.h"
#include "widgets/views/camera/camera_grid.h"
#include "widgets/views/scene/scene_view.h"
#include "widgets/workspaces/benchmark_page.h"
#include "widgets/workspaces/inspect_page.h"
#include "widgets/workspaces/work_words.h"

namespace widgets {

/// The middle of the window: joints on the left, camera views in the middle, scene and panels on the right; what the
/// middle shows depends on the workspace. It builds the panels, pages and presenters, gives each the parts of the
/// session that it needs, and turns what happens in the views into the annotator's steps.
class Workspaces : public QWidget {
    Q_OBJECT

public:
    enum class Kind { Annotate, Inspect, Benchmark };
    Q_ENUM(Kind)

    explicit Workspaces(WindowSession& session, QWidget* parent = nullptr);

    void setCurrent(Kind kind);
    Kind current() const { return m_kind; }

    CameraGrid* grid() const { return m_grid; }
    SceneView* scene() const { return m_scene; }
    JointsPanel* jointsPanel() const { return m_joints; }
    FittingPanel* fittingPanel() const { return m_fitting; }
    MarkPresenter* marks() const { return m_marks; }
    ResidualArrows* residuals() const { return m_residuals; }
    LayerPresenter* layers() const { return m_layers; }
    HandFraming* framing() const { return m_framing; }
    ViewOptions* options() const { return m_options; }
    QualityPanel* qualityPanel() const { return m_quality; }
    RatersPanel* ratersPanel() const { return m_raters; }
    ReviewPanel* reviewPanel() const { return m_review; }
    ViewPanel* viewPanel() const { return m_viewPanel; }
    WhatIfPanel* whatIfPanel() const { return m_whatIf; }
    InspectPage* inspectPage() const { return m_inspect; }
    BenchmarkPage* benchmarkPage() const { return m_benchmark; }
    ScenePanel* scenePanel() const { return m_scenePanel; }
    MaskAttacher* masks() { return &m_masks; }
    /// What the status line says in this workspace; empty where it describes the selected joint.
    WorkWords words() const;
    /// Brings the tab with this panel to the front.
    void raisePanel(QWidget* panel);
    /// A part of the window by its name for scripts: "scene", "joints", "diagram", "fit", "quality", "review",
    /// "raters", "view", "whatif", "curves", "views", "inspect", "benchmark" or a camera's name; null if there is none.
    QWidget* part(const QString& name) const;

    QByteArray saveState() const;
    void restoreState(const QByteArray& state);

signals:
    void currentChanged(widgets::Workspaces::Kind kind);
    /// Footage is missing, and a person wants to say where it is.
    void footageWanted();
    void wordsChanged(const widgets::WorkWords& words);
    /// A right click in a view; `joint` has an empty name if there is no mark.
    void viewMenuRequested(int camera, QPointF px, const core::JointId& joint, const QPoint& globalPosition);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();
    void shareWidth();
    void connectView(int camera, CameraView* view);
    void connectGrid();
    void connectInspect();
    void connectWords();
    void lookInspected();
    bool inspects() const;
    void showInScene();
    ImagePyramid shownPicture(int camera) const;
    void showTabs();
    int tabOf(const QWidget* panel) const;
    void takeSequence();
    void showOrder();
    void showCurrentCamera();
    void openPair(const QString& sequence, const FitRequest& request);

    WindowSession& m_session;
    Kind m_kind = Kind::Annotate;
    bool m_columnsMoved = false; ///< a person has chosen the columns' widths
    QSplitter* m_columns;
    QStackedWidget* m_middle;
    QSplitter* m_right;
    QTabWidget* m_tabs;
    JointsPanel* m_joints;
    CameraGrid* m_grid;
    SceneView* m_scene;
    FittingPanel* m_fitting;
    FramePictures* m_pictures;
    MarkPresenter* m_marks;
    ResidualArrows* m_residuals;
    LayerPresenter* m_layers;
    ViewOptions* m_options;
    HandFraming* m_framing;
    QualityPanel* m_quality;
    RatersPanel* m_raters;
    ReviewPanel* m_review;
    ViewPanel* m_viewPanel;
    InspectPage* m_inspect;
    WhatIfPanel* m_whatIf;
    BenchmarkPage* m_benchmark;
    ScenePanel* m_scenePanel;
    MaskAttacher m_masks;
    QWidget* m_annotationTab = nullptr; ///< the one in front before the workspace was left
};

} // namespace widgets
