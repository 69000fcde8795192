// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QStringList>
#include <QTimer>

#include "core/annotation/click_sigmas.h"
#include "core/io/dataset/dataset.h"
#include "core/rig/refinement_advice.h"
#include "core/rig/rig_health.h"
#include "core/rig/rig_refinement.h"
#include "widgets/document/annotation_document.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// What the clicks of all sequences and raters say of the calibration in use.
struct RigState {
    std::vector<core::RigJoint> joints;
    core::RigHealth health;
    core::RefinementNeeds needs;
    core::RigResiduals residuals;
    core::ClickSigmas sigmas;           ///< of this moment
    std::vector<std::string> sequences; ///< names, as findings number them
    QStringList unread;                 ///< sequences whose annotations cannot be read, and why
};

/// A refined calibration that waits to be used or discarded.
struct RigProposal {
    core::RigRefinement refinement;
    core::RigResiduals residuals;         ///< of the same clicks about the refined cameras
    std::optional<double> worldSigmaMm{}; ///< how far its world as a whole may lie from the true one (worldCovariance)
};

/// Judges the open dataset's calibration by its clicks, in the background, a moment after the last edit; refines it
/// when asked. From the same clicks follows what a click is worth, for all that triangulates in the window.
class RigStudy : public QObject {
    Q_OBJECT

public:
    RigStudy(const AnnotationDocument& document, JobPool& pool, QObject* parent = nullptr);
    ~RigStudy() override;

    /// The dataset, and which of its sequences the document holds: the others are read from their files.
    void setSequence(std::shared_ptr<const core::Dataset> dataset, const std::string& sequence);

    /// Null before the first look has ended.
    const std::shared_ptr<const RigState>& state() const { return m_state; }
    /// What the clicks of the dataset are worth, of every rater. Follows state()->sigmas once a triangulation would
    /// notice the difference (core::areAlike), and is assumed until the first look has ended.
    const core::ClickSigmas& clickSigmas() const { return m_sigmas; }
    /// True when every edit has been looked at.
    bool isUpToDate() const { return !m_job.isRunning() && !m_wait.isActive(); }

    /// Looks at the last edits without waiting for a pause.
    void lookNow();

    /// Refines the calibration from all clicks as they stand now; proposalChanged() or failed() follows.
    void refine();
    void stop();
    bool isRefining() const { return m_refiningWanted || m_refinement.isRunning(); }
    /// Null if there is none.
    const std::shared_ptr<const RigProposal>& proposal() const { return m_proposal; }
    void discardProposal();

signals:
    void changed();
    /// 3D points and their uncertainty are to be made anew.
    void clickSigmasChanged();
    void refiningChanged();
    void proposalChanged();
    /// Refining was not possible, and why.
    void failed(const QString& message);

private:
    struct Evidence;
    void forget();
    void take(const std::shared_ptr<const RigState>& state);
    void setClickSigmas(const core::ClickSigmas& sigmas);
    void queue(const core::Edit& edit);
    void look();
    void startRefinement();

    const AnnotationDocument& m_document;
    Job m_job;
    Job m_refinement;
    QTimer m_wait;
    std::shared_ptr<const core::Dataset> m_dataset;
    std::shared_ptr<Evidence> m_evidence; ///< the worker's while it runs
    std::vector<core::Edit> m_edits;      ///< that the evidence does not hold yet
    std::shared_ptr<const RigState> m_state;
    core::ClickSigmas m_sigmas;
    std::shared_ptr<const RigProposal> m_proposal;
    bool m_refiningWanted = false; ///< as soon as the state is up to date
};

} // namespace widgets
