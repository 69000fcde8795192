// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "core/fitting/pose_estimator.h"
#include "core/io/dataset/dataset.h"
#include "widgets/document/annotation_document.h"
#include "widgets/jobs/fit_pair.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// What one method made of the pair, or a pose that no method made beside them.
struct MethodOutcome {
    std::string method; ///< as core::parseMethod reads it; any name if the pose is fixed
    core::FitResult result;
    double errorMm = 0;                   ///< mean joint distance to the pair's reference; NaN if it has none
    std::vector<double> iterationErrorMm; ///< the same after every iteration of result.history
    QString failure;                      ///< why there is no result; empty if there is one
    QString note;                         ///< what of the result cannot be drawn, and why; mostly empty
    bool isFixed = false;                 ///< not fitted here: result.poses at every iteration, no history
};

/// All methods on one pair.
struct FitOutcome : FitPair {
    std::string sequence;
    FitRequest request;
    std::vector<MethodOutcome> methods;
};

/// Made by the first fit of a dataset: preparing the coarser levels of the hands takes a moment.
class SharedEstimator {
public:
    const core::PoseEstimator& get(const core::Dataset& dataset);

private:
    std::once_flag m_once;
    std::optional<core::PoseEstimator> m_estimator;
};

/// One method on one pair, errors measured against the pair's reference. Slow: not for the window's thread.
/// `progress` gets the share of the method's iterations that are done. `judged`: with the uncertainty of the result.
MethodOutcome runMethod(const core::PoseEstimator& estimator, const core::Dataset& dataset, const FitPair& pair,
                        const std::string& method, const std::stop_token& stop, int threads,
                        const std::function<void(double)>& progress = {}, bool judged = true);

/// Fits a frame pair with several methods, one after the other, in the background. Stopping keeps the methods that have
/// ended.
class FitRunner : public QObject {
    Q_OBJECT

public:
    FitRunner(const AnnotationDocument& document, JobPool& pool, QObject* parent = nullptr);
    ~FitRunner() override;

    void setSequence(std::shared_ptr<const core::Dataset> dataset, const core::Sequence* sequence,
                     std::shared_ptr<const core::Motion> motion);
    /// What marks are worth in the next fit.
    void setClickSigmas(core::ClickSigmas sigmas) { m_sigmas = std::move(sigmas); }
    /// Starts; a run before that is dropped. Emits failed() if the request makes no sense.
    void run(const FitRequest& request);
    /// Fits the pair of the outcome with more methods; those it has stay as they are. Does nothing without an outcome.
    void extend(const std::vector<std::string>& methods);
    /// Ends early; finished() comes with what there is.
    void stop();
    bool isRunning() const { return m_job.isRunning(); }
    /// The pair that is being fitted in the place of the outcome's; none while nothing is, or the outcome is extended.
    const std::optional<FitRequest>& pending() const { return m_pending; }
    /// What the open sequence has to take silhouettes from.
    bool hasMotion() const { return m_motion && !m_motion->empty(); }
    bool hasMasks() const { return core::hasMasks(m_sequence); }

    /// True if it has nothing: no fit is possible before masks are attached.
    bool needsSilhouettes() const { return !hasMotion() && !hasMasks(); }

    /// The last finished run of this sequence, or null.
    const std::shared_ptr<const FitOutcome>& outcome() const { return m_outcome; }

    /// Of the open dataset; null before one is open.
    const std::shared_ptr<SharedEstimator>& estimator() const { return m_estimator; }

signals:
    void started();
    void progressed(double fraction, const QString& text);
    void finished();
    void failed(const QString& message);
    /// The outcome was forgotten: another sequence.
    void cleared();

private:
    void start(std::vector<std::string> methods, std::function<std::optional<FitRefusal>(FitOutcome&)> prepare);
    QString objection(const FitRequest& request) const;

    const AnnotationDocument& m_document;
    Job m_job;
    std::shared_ptr<const core::Dataset> m_dataset;
    std::shared_ptr<const core::Motion> m_motion;
    std::shared_ptr<SharedEstimator> m_estimator;
    std::shared_ptr<const FitOutcome> m_outcome;
    std::optional<FitRequest> m_pending;
    core::Sequence m_sequence;
    core::ClickSigmas m_sigmas;
};

} // namespace widgets
