// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include <QObject>
#include <QString>
#include <QTimer>

#include "core/io/dataset/dataset.h"
#include "core/io/detector/first_pass.h"
#include "widgets/document/annotation_document.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// What a person wants the first pass to label.
struct FirstPassRequest {
    std::vector<int> frames; ///< ascending
    std::set<core::Side> hands{core::Side::Left, core::Side::Right};
    std::set<core::JointId> joints{}; ///< empty: every joint that it finds
};

/// The frames of a sequence that labels are wanted for, and the file that keeps what is done.
struct FirstPassWork {
    std::shared_ptr<const core::Dataset> dataset;
    core::Sequence sequence;
    std::vector<int> frames;
    std::filesystem::path journal;
};

/// What was labelled.
struct FirstPassLabels {
    core::AutoLabels labels;
    bool isFinished = false; ///< false: it was stopped, and the journal has what is done
    double camerasOffPx = 0; ///< core::PassResult::camerasOffPx
};

/// What labels frames; tests put something else in its place. All run on a worker's thread but isInstalled.
struct FirstPassProgram {
    std::function<bool()> isInstalled;
    /// Installs the detector's networks; returns what they are.
    std::function<std::string(const std::filesystem::path& package)> install;
    /// Labels what it can before `stop`. `progress` counts steps.
    std::function<FirstPassLabels(const FirstPassWork& work, std::stop_token stop, const core::PassProgress& progress)>
        label;
    /// Labels the frames around one that a person has corrected anew, following the hands from there; empty: it cannot.
    std::function<core::AutoLabels(const FirstPassWork& work, const core::AnnotationSet& set, const std::string& rater,
                                   int frame, std::stop_token stop)>
        follow = {};
    /// Labels a frame that a person is correcting anew: what is not placed follows what is; empty: it cannot.
    std::function<core::AutoLabels(const FirstPassWork& work, const core::AnnotationSet& set, const std::string& rater,
                                   int frame, std::stop_token stop)>
        refit = {};
};

/// How a run of the first pass ended.
struct FirstPassResult {
    int wanted = 0;                   ///< frames
    int frames = 0;                   ///< with a hand
    int proposed = 0;                 ///< marks
    std::set<core::JointId> joints{}; ///< that were proposed
    bool isFinished = false;          ///< false: it was stopped
    double camerasOffPx = 0;          ///< above 0: the calibration is off; the pass adjusted its own copy
};

/// Labels the frames of the open sequence without a click, in the background: proposals for the document's rater, one
/// undo step a run. What is done is kept beside the annotations, and the next run goes on from there. While a person
/// corrects proposals, the other proposals of the frame follow: as soon as a joint has marks in two views, and not
/// while something undone could be done again.
class FirstPass : public QObject {
    Q_OBJECT

public:
    FirstPass(AnnotationDocument& document, JobPool& pool, FirstPassProgram program, QObject* parent = nullptr);

    void setProgram(FirstPassProgram program);
    /// The open sequence; null: none is open.
    void setSequence(std::shared_ptr<const core::Dataset> dataset, const core::Sequence* sequence);

    bool isInstalled() const { return m_program.isInstalled(); }
    /// Takes the networks out of a package (its folder or .tgz); installed() or failed() follows.
    void install(const QString& package);

    /// finished() or failed() follows.
    void run(const FirstPassRequest& request);
    /// Ends the run after the step at work: the frames that are done become proposals. Following ends, too.
    void stop();
    bool isRunning() const { return m_job.isRunning(); }
    /// Proposes the frames around a corrected one anew, in the background, if the program can; one undo step.
    /// Frames that are corrected meanwhile follow.
    void followFrom(int frame);
    /// Whether the proposals of a frame are being brought to a joint that was placed there.
    bool isRefitting() const { return m_refitting.isRunning(); }
    bool isFollowing() const { return m_following.isRunning(); }
    bool isInstalling() const { return m_installing.isRunning(); }

signals:
    void runningChanged();
    void progressed(core::PassStage stage, int done, int total);
    void finished(const widgets::FirstPassResult& result);
    /// The frames around a corrected one have new proposals.
    void followed(int frame, int proposed);
    /// The other joints of a frame in which a joint was placed have new proposals.
    void refitted(int frame, int proposed);
    void installed(const QString& title);
    void failed(const QString& message);

private:
    void deliver(core::Edit edit, FirstPassResult result, const std::filesystem::path& journal);
    void removeJournal();
    void followNext();
    void noteTouched(const core::Edit& edit);
    void noteCorrection(const core::Edit& edit);
    void refit();
    void forgetRefit();
    void forgetFollowing();
    FirstPassWork workOn(std::vector<int> frames) const;

    AnnotationDocument& m_document;
    FirstPassProgram m_program;
    Job m_job;
    Job m_installing;
    Job m_following;
    Job m_refitting;
    QTimer m_settling;            ///< a joint was placed: more clicks may follow
    std::optional<int> m_toRefit; ///< frame
    std::deque<int> m_toFollow;
    std::map<const Job*, std::set<core::MarkKey>> m_touched; ///< marks that changed since the job began
    std::optional<std::filesystem::path> m_doneJournal;      ///< of a finished run that is not all in the file yet
    std::shared_ptr<const core::Dataset> m_dataset;
    std::optional<core::Sequence> m_sequence;
};

} // namespace widgets
