// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>

#include <QObject>

#include "core/io/dataset/dataset.h"
#include "widgets/document/joint_list.h"
#include "widgets/document/reconstructions.h"
#include "widgets/document/selection.h"
#include "widgets/views/camera/camera_grid.h"
#include "widgets/views/scene/scene_view.h"

namespace widgets {

/// Shows the current frame's joints in the camera views and the scene: marks, reprojections, epipolar guides, ellipses,
/// skeleton and what each view's title says. Everything is brought up to date together, right after an edit.
class MarkPresenter : public QObject {
    Q_OBJECT

public:
    /// `scene` may be null.
    MarkPresenter(const JointList& joints, const Reconstructions& reconstructions, const Selection& selection,
                  CameraGrid& grid, SceneView* scene, QObject* parent = nullptr);

    void setDataset(std::shared_ptr<const core::Dataset> dataset, const core::Sequence* sequence);
    void setSkeletonShown(bool shown);
    void setGuidesShown(bool shown);
    /// Whether joints that are pre-placed but not accepted are shown.
    void setProposalsShown(bool shown);
    /// Marks of a hand that is not shown are left out, but for the selected joint's.
    void setHandShown(core::Side hand, bool shown);
    bool skeletonShown() const { return m_skeletonShown; }
    bool guidesShown() const { return m_guidesShown; }
    bool proposalsShown() const { return m_proposalsShown; }

    void refresh();

private:
    void refreshView(int camera);
    void refreshScene();
    void moveName();
    bool isShown(const core::JointId& joint) const;
    std::vector<ViewMark> marksIn(int camera) const;
    std::vector<EpipolarGuide> guidesIn(int camera) const;
    ViewTitle titleOf(int camera) const;
    QString offsetText(const std::string& camera) const;

    const JointList& m_joints;
    const Reconstructions& m_reconstructions;
    const Selection& m_selection;
    CameraGrid& m_grid;
    SceneView* m_scene;
    std::shared_ptr<const core::Dataset> m_dataset;
    const core::Sequence* m_sequence = nullptr;
    std::string m_namedCamera;                   ///< whose view names the selected joint
    std::array<bool, 2> m_handShown{true, true}; ///< left, right
    bool m_skeletonShown = true;
    bool m_guidesShown = true;
    bool m_proposalsShown = true;
};

} // namespace widgets
