// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QWidget>

#include "widgets/document/selection.h"
#include "widgets/document/shown_cameras.h"
#include "widgets/jobs/frame_loader.h"
#include "widgets/panels/compare/column_wipe.h"
#include "widgets/presenters/inspect/inspect_overlays.h"
#include "widgets/presenters/inspect/inspected_poses.h"
#include "widgets/presenters/inspect_columns.h"
#include "widgets/session/dataset_session.h"
#include "widgets/views/camera/camera_grid.h"

namespace widgets {

/// The views of the Inspect workspace: a column per InspectColumn, a row per camera, over the pictures of the pair's
/// own test frame. Zoom and pan of a row's views are linked.
class InspectGrid : public QWidget {
    Q_OBJECT

public:
    InspectGrid(InspectColumns& columns, const DatasetSession& datasets, const Selection& selection,
                const ShownCameras& cameras, JobPool& pool, QWidget* parent = nullptr);

    CameraGrid* grid() const { return m_grid; }
    /// Which layers are drawn over the views.
    InspectOverlays* overlays() const { return m_overlays; }

    /// One column over another.
    ColumnWipe* wipe() const { return m_wipe; }

    /// What the views show from now on; null clears them.
    void showPoses(std::shared_ptr<const InspectedPoses> posed, int iteration);
    /// The titles of another iteration, before its poses are there.
    void setIteration(int iteration);
    /// Mean error of a column at that iteration, with its unit; empty without a reference.
    QString errorText(std::size_t column) const;
    /// How the meshes are drawn, and whether the start pose and the recorded silhouette are.
    void setLook(const LayerLook& look, bool startShown, bool recordedShown);

    /// As many cameras as this are shown, from the current one on, unless cameras are chosen.
    int rows() const { return m_rows; }
    void setRows(int rows);
    /// Cameras by name, from top to bottom; none: rows() of them from the current one on.
    const std::vector<std::string>& chosenCameras() const { return m_chosenCameras; }
    void chooseCameras(std::vector<std::string> cameras);
    /// The camera of every row, as an index into the dataset's.
    const std::vector<int>& rowCameras() const { return m_rowCameras; }

    /// The picture of the test frame; null without a fit, or before it has come.
    ImagePyramid picture(int camera) const;
    /// The view that keys are about; -1 without one.
    int currentView() const;
    /// The view of a column (by its id) and a camera; -1 if there is none.
    int viewOf(const std::string& column, int camera) const;
    /// What is seen of a row that was zoomed or moved: the point in the middle and the width, image px. None if its
    /// views show their whole home.
    struct Region {
        QPointF centrePx;
        double widthPx = 0;
    };
    std::optional<Region> region(std::size_t row) const;
    void setRegion(std::size_t row, const std::optional<Region>& region);
    /// Column and camera of a view.
    std::size_t columnOf(int view) const;
    int cameraOf(int view) const;

    /// Columns, pair or cameras have changed.
    void layOut();

signals:
    void pictureShown(int camera);
    void pointerMoved(int view, QPointF px);
    void pointerLeft();
    void pointClicked(int view, QPointF px);
    void camerasChanged();
    /// A right click.
    void menuRequested(int view, const QPoint& globalPosition);

private:
    void connectView(int index, CameraView* view);
    void requestPictures();
    void showPicture(int camera, const ImagePyramid& picture);
    void showFailure(int camera, const QString& message);
    void showTitles();
    void showOutlines();
    bool hasNoisyOutlines() const;
    void showPictureMessage(int index);
    void showLayers();
    void clearHidden();
    void syncRow(int index);
    std::vector<int> wantedCameras() const;

    InspectColumns& m_columns;
    const DatasetSession& m_datasets;
    const Selection& m_selection;
    const ShownCameras& m_cameras;
    FrameLoader m_frames; ///< of the pair's test frame, whatever the window's current one is
    std::shared_ptr<const core::Dataset> m_dataset;
    const core::Sequence* m_sequence = nullptr;
    CameraGrid* m_grid;
    InspectOverlays* m_overlays;
    ColumnWipe* m_wipe;
    int m_rows = 2;
    std::vector<std::string> m_chosenCameras;
    std::vector<int> m_rowCameras;
    struct Outlines {
        bool isShown = false;
        std::shared_ptr<const CameraOutlines> noisyPx; ///< null: the pair's own
        bool operator==(const Outlines&) const = default;
    };
    std::optional<Outlines> m_outlines; ///< that lie over the views
    std::shared_ptr<const InspectedPoses> m_posed;
    int m_iteration = 0;
    LayerLook m_look;
    bool m_startShown = false;
    bool m_recordedShown = true;
    bool m_syncing = false;
};

} // namespace widgets
