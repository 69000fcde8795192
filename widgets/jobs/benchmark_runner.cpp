// SPDX-License-Identifier: MIT
#include "widgets/jobs/benchmark_runner.h"

#include <algorithm>

#include <QThread>

#include "core/io/benchmark_scene.h"

namespace widgets {

BenchmarkRunner::BenchmarkRunner(JobPool& pool, QObject* parent) : QObject(parent), m_job(pool) {
    connect(&m_job, &Job::started, this, &BenchmarkRunner::started);
    connect(&m_job, &Job::progressed, this, &BenchmarkRunner::progressed);
    connect(&m_job, &Job::failed, this, &BenchmarkRunner::failed);
    connect(&m_job, &Job::finished, this, &BenchmarkRunner::finished);
}

void BenchmarkRunner::setDataset(std::shared_ptr<const core::Dataset> dataset) {
    m_job.stop();
    m_dataset = std::move(dataset);
    m_results.reset();
    emit cleared();
}

void BenchmarkRunner::run(const BenchmarkRequest& request) {
    if (!m_dataset) {
        emit failed(tr("Open a dataset first."));
        return;
    }
    m_job.start([this, request, dataset = m_dataset](const JobContext& context) -> Job::Delivery {
        const core::BenchmarkScene scene = core::readBenchmarkScene(*dataset, request.sequences, request.setup);
        const auto pairs = core::drawPairs(core::pairFrames(scene, request.setup), request.pairs);
        core::BenchmarkOptions options;
        options.setup = request.setup;
        options.methods = request.methods;
        options.threads = std::max(1, QThread::idealThreadCount() - 1); // one is left to the window
        const auto progress = [&](const core::BenchmarkProgress& state) {
            const double fraction = state.total > 0 ? double(state.finished) / state.total : 0;
            context.report(fraction, BenchmarkRunner::tr("%1 of %2 fits").arg(state.finished).arg(state.total));
        };
        auto results = std::make_shared<const core::BenchmarkResults>(
            core::runBenchmark(scene, pairs, options, core::poseEstimatorOf(scene), progress, context.stop));
        return [this, results, setup = request.setup] {
            m_results = results;
            m_setup = setup;
        };
    });
}

void BenchmarkRunner::stop() {
    m_job.requestEnd();
}

} // namespace widgets
