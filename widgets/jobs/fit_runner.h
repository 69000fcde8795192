// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QRectF>
#include <QString>

#include <opencv2/core/mat.hpp>

#include "core/fitting/pose_estimator.h"
#include "core/io/dataset.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// Which frame pair to fit with which methods.
struct FitRequest {
    int start = 0; ///< frame whose recorded pose the fit starts from
    int test = 0;  ///< frame whose silhouettes are to be met
    std::vector<std::string> methods; ///< as core::parseMethod reads them
};

/// What one method made of the pair.
struct MethodOutcome {
    std::string method;
    core::FitResult result;
    double errorMm = 0;                ///< mean joint distance to the recorded pose of the test frame
    std::vector<double> iterationErrorMm; ///< the same after every iteration of result.history
    QString failure;                   ///< why there is no result; empty if there is one
};

/// All methods on one pair.
struct FitOutcome {
    std::string sequence;
    FitRequest request;
    core::HandPoses startPoses;
    core::HandPoses truePoses;
    double initialErrorMm = 0; ///< mean joint distance of the start pose
    std::vector<cv::Mat> masks; ///< target silhouettes, one per camera
    std::vector<QRectF> handsPx; ///< where they lie in each camera's image, with some room around; empty where there are none
    std::vector<MethodOutcome> methods;
};

/// Fits a frame pair with several methods, one after the other, in the background. Stopping keeps the methods that have ended.
class FitRunner : public QObject {
    Q_OBJECT

public:
    explicit FitRunner(JobPool& pool, QObject* parent = nullptr);
    ~FitRunner() override;

    void setSequence(std::shared_ptr<const core::Dataset> dataset, const core::Sequence* sequence,
                     std::shared_ptr<const core::Motion> motion);
    /// Starts; a run before that is dropped. Emits failed() if the request makes no sense.
    void run(const FitRequest& request);
    /// Ends early; finished() comes with what there is.
    void stop();
    bool isRunning() const { return m_job.isRunning(); }

    /// The last finished run of this sequence, or null.
    const std::shared_ptr<const FitOutcome>& outcome() const { return m_outcome; }

signals:
    void started();
    void progressed(double fraction, const QString& text);
    void finished();
    void failed(const QString& message);
    /// The outcome was forgotten: another sequence.
    void cleared();

private:
    struct Estimator;
    Job m_job;
    std::shared_ptr<const core::Dataset> m_dataset;
    std::shared_ptr<const core::Motion> m_motion;
    std::shared_ptr<Estimator> m_estimator;
    std::shared_ptr<const FitOutcome> m_outcome;
    std::string m_sequence;
};

} // namespace widgets
