// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

#include "widgets/document/annotation_document.h"
#include "widgets/document/annotator.h"
#include "widgets/document/joint_list.h"
#include "widgets/document/reconstructions.h"
#include "widgets/document/selection.h"
#include "widgets/document/shown_cameras.h"
#include "widgets/jobs/benchmark/benchmark_runner.h"
#include "widgets/jobs/first_pass.h"
#include "widgets/jobs/fit_runner.h"
#include "widgets/jobs/frame_loader.h"
#include "widgets/jobs/hand_model_fit.h"
#include "widgets/jobs/job.h"
#include "widgets/jobs/quality_checks.h"
#include "widgets/jobs/rater_study.h"
#include "widgets/jobs/review_queue.h"
#include "widgets/jobs/rig_study.h"
#include "widgets/jobs/silhouette_study.h"
#include "widgets/jobs/subject_study.h"
#include "widgets/session/annotation_coverage.h"
#include "widgets/session/annotation_files.h"
#include "widgets/session/calibration_choice.h"
#include "widgets/session/dataset_session.h"

namespace widgets {

/// What all workspaces of one window share, wired to each other: the open dataset, the annotations, the selection and
/// the work that goes on in the background. Which joints and cameras are shown is kept with the annotations.
/// Only the classes that build the window know it; every other one is given the parts that it needs.
class WindowSession : public QObject {
    Q_OBJECT

public:
    explicit WindowSession(QObject* parent = nullptr);
    ~WindowSession() override;

    JobPool pool;
    Selection selection;
    AnnotationDocument document;
    JointList joints;
    ShownCameras shownCameras;
    Reconstructions reconstructions;
    Annotator annotator;
    AnnotationCoverage coverage;
    DatasetSession opened;
    FrameLoader frames;
    FitRunner fits;
    AnnotationFiles files;
    BenchmarkRunner benchmarks;
    QualityChecks checks;
    HandModelFit model;
    RaterStudy raters;
    RigStudy rig;
    SilhouetteStudy silhouettes;
    SubjectStudy subject;
    FirstPass firstPass;
    ReviewQueue review;
    CalibrationChoice calibrations;

    /// True when no background work that a person waits for is running and all pictures of the frame have come.
    bool isIdle() const {
        return pool.isIdle() && frames.isComplete() && !rig.isRefining() && review.isUpToDate() && !document.isBusy();
    }

signals:
    /// A sequence is open and everything above knows it.
    void ready();

private:
    void takeDataset();
    void takeSequence(int frame);
    void restoreChoices();

    bool m_restoring = false;
};

} // namespace widgets
