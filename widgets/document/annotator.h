// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QObject>

#include <Eigen/Core>

#include "widgets/document/annotation_document.h"
#include "widgets/document/joint_list.h"
#include "widgets/document/reconstructions.h"
#include "widgets/document/selection.h"
#include "widgets/document/shown_cameras.h"

namespace widgets {

/// What the annotator's hands do, turned into edits: clicks, drags and keys about the selected joint and the current
/// view. Positions in recorded image pixels, centres at integers.
class Annotator : public QObject {
    Q_OBJECT

public:
    Annotator(AnnotationDocument& document, Selection& selection, Reconstructions& reconstructions, JointList& joints,
              const ShownCameras& cameras, QObject* parent = nullptr);

    void setDataset(std::shared_ptr<const core::Dataset> dataset) { m_dataset = std::move(dataset); }
    /// Whether the next joint is selected when a step has finished this one for the first time (every view is placed or
    /// not placeable). Corrections - drags, nudges, marks of a joint that was finished before - never select another
    /// joint.
    void setAutoAdvance(bool on) { m_autoAdvance = on; }
    bool autoAdvance() const { return m_autoAdvance; }

    /// Puts the selected joint there as a manual mark, and makes that view the current one. A place outside the picture
    /// is refused.
    void place(const std::string& camera, const Eigen::Vector2d& px);
    /// Takes the place() before back without a trace: it was half of a double click.
    void withdrawPlace();
    /// A drag shows its effect at once, at the nearest place within the picture, and becomes one step when it ends; one
    /// that ends outside the picture changes nothing.
    void drag(const std::string& camera, const core::JointId& joint, const Eigen::Vector2d& px);
    void drop(const std::string& camera, const core::JointId& joint, const Eigen::Vector2d& px);
    void cancelDrag();

    /// Accepts the pre-placed mark in the current view or, if that view has a mark, in the next one without.
    void accept();
    void acceptAllViews();
    void acceptFrame();
    /// Accepts every joint of the frame as it stands: clicked ones in the views that are left, proposed ones where they
    /// are. False, and why is said, if there is nothing to accept.
    bool acceptProposals();
    void remove();
    /// Deletes the selected joint's marks in all views of the frame.
    void removeInAllViews();
    void toggleOccluded();
    void toggleUnplaceable();
    /// Moves the mark in the current view by image pixels, up to the picture's edge; a row of nudges is one step.
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
    QString nothingToAcceptText() const;
    bool refusesPlace(const std::string& camera, const Eigen::Vector2d& px);
    Eigen::Vector2d withinPicture(const std::string& camera, const Eigen::Vector2d& px) const;
    core::Edit whereThereArePictures(core::Edit edit) const;
    void noteIfFinished();
    const core::ViewReconstruction* selectedIn(const std::string& camera) const;

    AnnotationDocument& m_document;
    Selection& m_selection;
    Reconstructions& m_reconstructions;
    JointList& m_joints;
    const ShownCameras& m_cameras; ///< what Q and E step through
    std::shared_ptr<const core::Dataset> m_dataset;
    std::optional<core::MarkKey> m_nudged;
    core::Edit m_lastPlaced;
    core::JointId m_jointBeforePlace;
    int m_step = 0;
    std::set<core::MarkKey> m_finished; ///< joints that were done at some time (no camera in the key)
    bool m_placeFinished = false;       ///< the last place() finished its joint
    bool m_autoAdvance = true;
};

} // namespace widgets
