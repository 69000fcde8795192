// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QObject>

#include "core/annotation/annotation_set.h"
#include "core/benchmark/joint_errors.h"
#include "widgets/presenters/inspect/inspect_overlays.h"
#include "widgets/presenters/inspect_columns.h"
#include "widgets/views/camera/camera_grid.h"

namespace widgets {

/// Where the joints of a column are after so many steps, mm; a joint that has no pose is left out.
core::JointPositions inspectedJoints(const core::Dataset& dataset, const FitOutcome& outcome, std::size_t column,
                                     int iteration);

/// Marks one joint in every view of the inspected pair: where its column puts it, with a line to where it is to be.
class InspectJointMarks : public QObject {
    Q_OBJECT

public:
    InspectJointMarks(const InspectColumns& columns, const InspectOverlays& overlays, CameraGrid& grid,
                      QObject* parent = nullptr);

    /// None takes the marks away.
    void setJoint(const std::optional<core::JointId>& joint);
    const std::optional<core::JointId>& joint() const { return m_joint; }

signals:
    void jointChanged();

private:
    void refresh();
    std::optional<ViewMark> markOf(const core::JointPositions& joints, const core::Camera& camera) const;

    const InspectColumns& m_columns;
    const InspectOverlays& m_overlays;
    CameraGrid& m_grid;
    std::optional<core::JointId> m_joint;
};

} // namespace widgets
