// SPDX-License-Identifier: MIT
#include "widgets/jobs/fit_runner.h"

#include <algorithm>
#include <thread>

#include "core/error.h"
#include "core/fitting/method_name.h"
#include "widgets/text/error_text.h"

namespace widgets {

const core::PoseEstimator& SharedEstimator::get(const core::Dataset& dataset) {
    std::call_once(m_once, [&] { m_estimator.emplace(dataset.hands, dataset.cameras); });
    return *m_estimator;
}

MethodOutcome runMethod(const core::PoseEstimator& estimator, const core::Dataset& dataset, const FitPair& pair,
                        const std::string& method, const std::stop_token& stop, int threads,
                        const std::function<void(double)>& progress, bool judged) {
    MethodOutcome outcome;
    outcome.method = method;
    const auto report = [&](int iteration, int most) {
        if (progress)
            progress(most > 0 ? double(iteration) / most : 0);
    };
    try {
        outcome.result = estimator.fit(pair.masks, pair.startPoses, core::parseMethod(method), stop, report, threads,
                                       {.matches = true, .confidence = judged});
        outcome.errorMm = errorAgainst(pair, dataset, outcome.result.poses);
        for (const core::FitIteration& step : outcome.result.history)
            outcome.iterationErrorMm.push_back(errorAgainst(pair, dataset, step.poses));
    } catch (const core::Error& error) {
        outcome.failure = errorInWords(error);
    }
    return outcome;
}

FitRunner::FitRunner(const AnnotationDocument& document, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_job(pool) {
    connect(&m_job, &Job::started, this, &FitRunner::started);
    connect(&m_job, &Job::progressed, this, &FitRunner::progressed);
    connect(&m_job, &Job::failed, this, [this](const QString& message) {
        m_pending.reset();
        emit failed(message);
    });
    connect(&m_job, &Job::finished, this, [this] {
        m_pending.reset();
        emit finished();
    });
}

FitRunner::~FitRunner() = default;

void FitRunner::setSequence(std::shared_ptr<const core::Dataset> dataset, const core::Sequence* sequence,
                            std::shared_ptr<const core::Motion> motion) {
    m_job.stop();
    m_pending.reset();
    if (dataset != m_dataset)
        m_estimator = std::make_shared<SharedEstimator>();
    m_dataset = std::move(dataset);
    m_motion = std::move(motion);
    m_sequence = sequence ? *sequence : core::Sequence();
    m_outcome.reset();
    emit cleared();
}

/// Why the request makes no sense; empty if it does.
QString FitRunner::objection(const FitRequest& request) const {
    const int frames = hasMotion() ? static_cast<int>(m_motion->size()) : m_sequence.frameCount;
    if (!m_dataset || m_dataset->hands.empty())
        return tr("This dataset has no hand models to fit.");
    if (needsSilhouettes())
        return tr("This sequence needs silhouettes: attach a folder of masks, or make them.");
    if (request.target == FitTarget::Masks && !hasMasks())
        return tr("This sequence has no mask files.");
    if (request.target == FitTarget::Recorded && !hasMotion())
        return tr("This sequence has no recorded motion to draw silhouettes from.");
    if (request.start < 0 || request.start >= frames || request.test < 0 || request.test >= frames)
        return tr("The start and the test frame must be between 0 and %1.").arg(frames - 1);
    if (request.methods.empty())
        return tr("Choose at least one method.");
    return {};
}

void FitRunner::run(const FitRequest& request) {
    if (const QString why = objection(request); !why.isEmpty()) {
        emit failed(why);
        return;
    }
    const bool readsMarks = request.target == FitTarget::Masks || !hasMotion();
    const FitSource source{m_dataset,          m_sequence,
                           m_motion,           readsMarks ? m_document.annotations() : core::AnnotationSet(),
                           m_document.rater(), m_sigmas};
    m_pending = request;
    start(request.methods, [request, source](FitOutcome& outcome) -> std::optional<FitRefusal> {
        auto prepared = prepareFitPair(source, request);
        if (const auto* refusal = std::get_if<FitRefusal>(&prepared))
            return *refusal;
        static_cast<FitPair&>(outcome) = std::move(std::get<FitPair>(prepared));
        outcome.sequence = source.sequence.name;
        outcome.request = request;
        return std::nullopt;
    });
}

void FitRunner::extend(const std::vector<std::string>& methods) {
    if (!m_outcome)
        return;
    std::vector<std::string> missing;
    for (const std::string& method : methods) {
        const bool isThere = std::any_of(m_outcome->methods.begin(), m_outcome->methods.end(),
                                         [&](const MethodOutcome& fitted) { return fitted.method == method; });
        if (!isThere && std::find(missing.begin(), missing.end(), method) == missing.end())
            missing.push_back(method);
    }
    if (missing.empty())
        return;
    m_pending.reset();
    start(missing, [before = m_outcome, missing](FitOutcome& outcome) -> std::optional<FitRefusal> {
        outcome = *before;
        outcome.request.methods.insert(outcome.request.methods.end(), missing.begin(), missing.end());
        return std::nullopt;
    });
}

/// `prepare` makes the pair, on the worker; the methods' outcomes come behind those that it holds.
void FitRunner::start(std::vector<std::string> methods, std::function<std::optional<FitRefusal>(FitOutcome&)> prepare) {
    m_job.start([this, methods = std::move(methods), prepare = std::move(prepare), dataset = m_dataset,
                 estimator = m_estimator](const JobContext& context) -> Job::Delivery {
        auto outcome = std::make_shared<FitOutcome>();
        if (const std::optional<FitRefusal> refusal = prepare(*outcome))
            return [this, why = *refusal] {
                m_job.stop();
                m_pending.reset();
                emit failed(fitRefusalText(why));
            };
        const core::PoseEstimator& poseEstimator = estimator->get(*dataset);
        const double count = static_cast<double>(methods.size());
        const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency() / 2));
        for (std::size_t i = 0; i < methods.size() && !context.stop.stop_requested(); ++i)
            outcome->methods.push_back(runMethod(
                poseEstimator, *dataset, *outcome, methods[i], context.stop, threads,
                [&](double fraction) {
                    context.report((static_cast<double>(i) + fraction) / count, QString::fromStdString(methods[i]));
                }));
        return [this, outcome] { m_outcome = outcome; };
    });
}

void FitRunner::stop() {
    m_job.requestEnd();
}

} // namespace widgets
