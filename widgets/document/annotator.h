// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QObject>

#include <Eigen/Core>

#include "widgets/document/annotation_document.h"
#include "widgets/document/joint_list.h"
#include "widgets/document/reconstructions.h"
#include "widgets/document/selection.h"

namespace widgets {

/// What the annotator's hands do, turned into edits: clicks, drags and keys about the selected joint and the current view.
/// Positions in recorded image pixels, centres at integers.
class Annotator : public QObject {
    Q_OBJECT

public:
    Annotator(AnnotationDocument& document, Selection& selection, Reconstructions& reconstructions, JointList& joints,
              QObject* parent = nullptr);

    void setDataset(std::shared_ptr<const core::Dataset> dataset) { m_dataset = std::move(dataset); }
    /// The cameras that are shown, in their order: what Q and E step through.
    void setCameraOrder(std::vector<std::string> cameras) { m_cameraOrder = std::move(cameras); }
    const std::vector<std::string>& cameraOrder() const { return m_cameraOrder; }
    /// Whether the next joint is selected when every view of this one is placed or not placeable.
    void setAutoAdvance(bool on) { m_autoAdvance = on; }
    bool autoAdvance() const { return m_autoAdvance; }

    /// Puts the selected joint there as a manual mark, and makes that view the current one.
    void place(const std::string& camera, const Eigen::Vector2d& px);
    /// Takes the place() before back without a trace: it was half of a double click.
    void withdrawPlace();
    /// A drag shows its effect at once, and becomes one step when it ends.
    void drag(const std::string& camera, const core::JointId& joint, const Eigen::Vector2d& px);
    void drop(const std::string& camera, const core::JointId& joint, const Eigen::Vector2d& px);
    void cancelDrag();

    /// Accepts the pre-placed mark in the current view or, if that view has a mark, in the next one without.
    void accept();
    void acceptAllViews();
    void acceptFrame();
    void remove();
    /// Deletes the selected joint's marks in all views of the frame.
    void removeInAllViews();
    void toggleOccluded();
    void toggleUnplaceable();
    /// Moves the mark in the current view by image pixels; a row of nudges is one step.
    void nudge(const Eigen::Vector2d& byPx);

    void stepFrame(int frames);
    void stepJoint(int joints);
    /// Makes the view `views` places further the current one, around the end.
    void stepCamera(int views);

    core::MarkKey keyFor(const std::string& camera, const core::JointId& joint) const;

signals:
    /// The key did nothing, and why.
    void nothingDone(const QString& reason);

private:
    core::MarkKey currentKey() const;
    void pushAndAdvance(const core::Edit& edit);
    const core::ViewReconstruction* selectedIn(const std::string& camera) const;

    AnnotationDocument& m_document;
    Selection& m_selection;
    Reconstructions& m_reconstructions;
    JointList& m_joints;
    std::shared_ptr<const core::Dataset> m_dataset;
    std::vector<std::string> m_cameraOrder;
    std::optional<core::MarkKey> m_nudged;
    core::Edit m_lastPlaced;
    core::JointId m_jointBeforePlace;
    int m_step = 0;
    bool m_autoAdvance = true;
};

} // namespace widgets
