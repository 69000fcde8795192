// SPDX-License-Identifier: MIT
#include "widgets/jobs/fit_runner.h"

#include <mutex>
#include <thread>

#include <QCoreApplication>

#include <opencv2/imgproc.hpp>

#include "core/contour/rasteriser.h"
#include "core/error.h"

namespace widgets {

/// Made by the first fit of a dataset: preparing the coarser levels of the hands takes a moment.
struct FitRunner::Estimator {
    std::once_flag once;
    std::optional<core::PoseEstimator> estimator;

    const core::PoseEstimator& get(const core::Dataset& dataset) {
        std::call_once(once, [&] { estimator.emplace(dataset.hands, dataset.cameras); });
        return *estimator;
    }
};

namespace {

using Progress = std::function<void(double fractionOfMethod)>;

MethodOutcome runMethod(const core::PoseEstimator& estimator, const core::Dataset& dataset, const FitOutcome& pair,
                        const std::string& method, const std::stop_token& stop, const Progress& progress) {
    MethodOutcome outcome;
    outcome.method = method;
    const auto report = [&](int iteration, int most) { progress(most > 0 ? double(iteration) / most : 0); };
    const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency() / 2));
    try {
        outcome.result = estimator.fit(pair.masks, pair.startPoses, core::parseMethod(method), stop, report, threads);
        outcome.errorMm = core::meanJointDistanceMm(dataset.hands, outcome.result.poses, pair.truePoses);
        for (const core::FitIteration& step : outcome.result.history)
            outcome.iterationErrorMm.push_back(core::meanJointDistanceMm(dataset.hands, step.poses, pair.truePoses));
    } catch (const core::Error& error) {
        outcome.failure = QString::fromUtf8(error.what());
    }
    return outcome;
}

/// Where a mask's silhouette lies, with some room around it.
QRectF roomyBounds(const cv::Mat& mask) {
    constexpr double kRoom = 0.25; // of the longer side
    const cv::Rect box = mask.empty() ? cv::Rect() : cv::boundingRect(mask);
    if (box.empty())
        return {};
    const double room = kRoom * std::max(box.width, box.height);
    return QRectF(box.x, box.y, box.width, box.height).adjusted(-room, -room, room, room);
}

/// The pair's poses and target silhouettes, drawn from the recorded pose of the test frame.
FitOutcome preparePair(const core::Dataset& dataset, const core::Motion& motion, const std::string& sequence,
                       const FitRequest& request) {
    FitOutcome pair;
    pair.sequence = sequence;
    pair.request = request;
    pair.startPoses = motion[static_cast<std::size_t>(request.start)];
    pair.truePoses = motion[static_cast<std::size_t>(request.test)];
    pair.initialErrorMm = core::meanJointDistanceMm(dataset.hands, pair.startPoses, pair.truePoses);
    for (const core::Camera& camera : dataset.cameras)
        pair.masks.push_back(core::renderHandsMask(camera, dataset.hands, pair.truePoses));
    for (const cv::Mat& mask : pair.masks)
        pair.handsPx.push_back(roomyBounds(mask));
    return pair;
}

} // namespace

FitRunner::FitRunner(JobPool& pool, QObject* parent) : QObject(parent), m_job(pool) {
    connect(&m_job, &Job::started, this, &FitRunner::started);
    connect(&m_job, &Job::progressed, this, &FitRunner::progressed);
    connect(&m_job, &Job::failed, this, &FitRunner::failed);
    connect(&m_job, &Job::finished, this, &FitRunner::finished);
}

FitRunner::~FitRunner() = default;

void FitRunner::setSequence(std::shared_ptr<const core::Dataset> dataset, const core::Sequence* sequence,
                            std::shared_ptr<const core::Motion> motion) {
    m_job.stop();
    if (dataset != m_dataset)
        m_estimator = std::make_shared<Estimator>();
    m_dataset = std::move(dataset);
    m_motion = std::move(motion);
    m_sequence = sequence ? sequence->name : std::string();
    m_outcome.reset();
    emit cleared();
}

void FitRunner::run(const FitRequest& request) {
    const int frames = m_motion ? static_cast<int>(m_motion->size()) : 0;
    if (frames == 0) {
        emit failed(tr("This sequence has no recorded motion to start a fit from."));
        return;
    }
    if (request.start < 0 || request.start >= frames || request.test < 0 || request.test >= frames) {
        emit failed(tr("The start and the test frame must be between 0 and %1.").arg(frames - 1));
        return;
    }
    if (request.methods.empty()) {
        emit failed(tr("Choose at least one method."));
        return;
    }
    m_job.start([this, request, dataset = m_dataset, motion = m_motion, estimator = m_estimator,
                 sequence = m_sequence](const JobContext& context) -> Job::Delivery {
        auto outcome = std::make_shared<FitOutcome>(preparePair(*dataset, *motion, sequence, request));
        const core::PoseEstimator& poseEstimator = estimator->get(*dataset);
        const double count = static_cast<double>(request.methods.size());
        for (std::size_t i = 0; i < request.methods.size() && !context.stop.stop_requested(); ++i) {
            const std::string& method = request.methods[i];
            outcome->methods.push_back(
                runMethod(poseEstimator, *dataset, *outcome, method, context.stop, [&](double fraction) {
                    context.report((static_cast<double>(i) + fraction) / count, QString::fromStdString(method));
                }));
        }
        return [this, outcome] { m_outcome = outcome; };
    });
}

void FitRunner::stop() {
    m_job.requestEnd();
}

} // namespace widgets
