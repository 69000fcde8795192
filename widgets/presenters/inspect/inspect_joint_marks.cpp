// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect/inspect_joint_marks.h"

#include "core/geometry/camera.h"
#include "widgets/presenters/inspect/inspected_poses.h"
#include "widgets/text/edit_text.h"

namespace widgets {

core::JointPositions inspectedJoints(const core::Dataset& dataset, const FitOutcome& outcome, std::size_t column,
                                     int iteration) {
    if (column >= outcome.methods.size())
        return {};
    const core::HandPoses& poses = inspectedPosesAt(outcome, outcome.methods[column], iteration);
    return poses.size() == dataset.hands.size() ? core::namedJointPositions(dataset.hands, poses)
                                                : core::JointPositions{};
}

InspectJointMarks::InspectJointMarks(const InspectColumns& columns, const InspectOverlays& overlays, CameraGrid& grid,
                                     QObject* parent)
    : QObject(parent)
    , m_columns(columns)
    , m_overlays(overlays)
    , m_grid(grid) {
    connect(&overlays, &InspectOverlays::drawn, this, &InspectJointMarks::refresh);
}

void InspectJointMarks::setJoint(const std::optional<core::JointId>& joint) {
    if (joint == m_joint)
        return;
    m_joint = joint;
    refresh();
    emit jointChanged();
}

std::optional<ViewMark> InspectJointMarks::markOf(const core::JointPositions& joints,
                                                  const core::Camera& camera) const {
    const auto place = [&](const core::JointPositions& positions) -> std::optional<QPointF> {
        const auto found = positions.find(*m_joint);
        const auto px = found == positions.end() ? std::nullopt : core::project(camera, found->second);
        return px ? std::optional(QPointF(px->x(), px->y())) : std::nullopt;
    };
    const auto px = place(joints);
    if (!px)
        return std::nullopt;
    ViewMark mark;
    mark.joint = *m_joint;
    mark.px = *px;
    mark.selected = true;
    mark.named = true;
    mark.label = jointText(*m_joint);
    mark.reprojectionPx = place(m_overlays.scene().outcome->reference);
    return mark;
}

void InspectJointMarks::refresh() {
    const InspectOverlays::Scene& scene = m_overlays.scene();
    const std::size_t columns = scene.outcome ? scene.outcome->methods.size() : 0;
    std::vector<core::JointPositions> joints;
    for (std::size_t column = 0; m_joint && column < columns; ++column)
        joints.push_back(inspectedJoints(*scene.dataset, *scene.outcome, column, scene.iteration));
    for (int index = 0; index < m_grid.count(); ++index) {
        const std::size_t column = columns ? static_cast<std::size_t>(index) % columns : 0;
        const std::size_t row = columns ? static_cast<std::size_t>(index) / columns : 0;
        std::vector<ViewMark> marks;
        if (column < joints.size() && row < scene.rowCameras.size() && m_columns.isShown(column, scene.rowCameras[row]))
            if (const auto mark = markOf(joints[column], m_grid.view(index)->camera()))
                marks.push_back(*mark);
        m_grid.view(index)->setMarks(marks);
    }
}

} // namespace widgets
