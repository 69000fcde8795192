// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QColor>
#include <QObject>

#include "core/rig/rig_residuals.h"
#include "widgets/jobs/rig_study.h"
#include "widgets/views/camera/camera_grid.h"

namespace widgets {

/// How many times longer than true the arrows are drawn.
inline constexpr double kResidualLengthening = 10;

/// The mean residual of a camera's clicks, cell by cell of its picture (8 along its longer side): from the mean place
/// of the cell's clicks towards where they lie off what the other cameras say, kResidualLengthening times as long.
/// Wrong clicks hardly count.
std::vector<ResidualArrow> residualArrows(const core::RigResiduals& residuals, int camera, const core::ImageSize& size,
                                          const QColor& colour);

/// Shows residual arrows in all camera views: of the calibration in use and, where one waits to be used, of the refined
/// one.
class ResidualArrows : public QObject {
    Q_OBJECT

public:
    ResidualArrows(const RigStudy& rig, CameraGrid& grid, QObject* parent = nullptr);

    void setShown(bool shown);
    bool isShown() const { return m_shown; }
    /// For new views.
    void refresh();

private:
    const RigStudy& m_rig;
    CameraGrid& m_grid;
    bool m_shown = false;
};

} // namespace widgets
