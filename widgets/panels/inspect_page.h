// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <QWidget>

#include "widgets/jobs/workbench.h"
#include "widgets/views/camera_grid.h"
#include "widgets/views/curve_plot.h"

namespace widgets {

/// The fitted pair, methods side by side: a column per method, a row per camera, the recorded silhouette as a white line, at the
/// iteration that the slider chooses; below, how error and cost fell.
class InspectPage : public QWidget {
    Q_OBJECT

public:
    explicit InspectPage(Workbench& workbench, QWidget* parent = nullptr);

    CameraGrid* grid() const { return m_grid; }
    /// 0 is the start pose; methods that ended before stay at their result.
    int iteration() const;
    void setIteration(int iteration);
    int lastIteration() const;

private:
    void build();
    void takeOutcome();
    void layOutGrid();
    void showPoses();
    void showPicture(int camera, const ImagePyramid& picture);
    void showCurves();
    void showTitles();
    void syncRow(int index);
    std::vector<int> rowCameras() const;
    std::size_t methodCount() const;

    Workbench& m_workbench;
    Job m_job;
    QLabel* m_heading;
    QSlider* m_slider;
    QLabel* m_iterationText;
    QSpinBox* m_rows;
    CameraGrid* m_grid;
    CurvePlot* m_errors;
    CurvePlot* m_costs;
    std::vector<int> m_shownCameras; ///< per row
    bool m_syncing = false;
};

} // namespace widgets
