// SPDX-License-Identifier: MIT
#include "widgets/jobs/benchmark_runner.h"

#include <algorithm>
#include <mutex>

#include <QDir>
#include <QThread>

#include "core/benchmark/scene_fingerprint.h"
#include "core/error.h"
#include "core/io/benchmark/benchmark_scene.h"

namespace widgets {

namespace {

constexpr qint64 kUpdateMs = 100; ///< rows may come faster than tables and curves are worth drawing

/// Why the folder cannot take these results; empty if it can. What is there is never replaced.
QString objectionTo(const std::filesystem::path& folder, const core::BenchmarkFolder& content) {
    if (std::filesystem::exists(folder / "run.json")) {
        core::BenchmarkRunInfo there = core::readRunInfo(folder);
        there.dataset = content.info.dataset;
        return there == content.info
                   ? QString()
                   : BenchmarkRunner::tr("This folder holds the results of another benchmark. Choose another one.");
    }
    for (const char* file : {"results.csv", "joints.csv", "curves.csv", "table.md", "table.tex", "report.html",
                             "pairs.json", "finished.jsonl"}) {
        if (std::filesystem::exists(folder / file))
            return BenchmarkRunner::tr("This folder already holds a file %1. Choose another one.")
                .arg(QLatin1String(file));
    }
    return {};
}

/// True if the results were made from this dataset as it is now.
bool isOf(const core::BenchmarkRunInfo& info, const core::Dataset& dataset) {
    std::vector<std::string> sequences;
    for (const core::FramePair& pair : info.pairs)
        if (std::find(sequences.begin(), sequences.end(), pair.sequence) == sequences.end())
            sequences.push_back(pair.sequence);
    try {
        if (core::sceneFingerprint(core::readBenchmarkScene(dataset, sequences, info.setup)) == info.fingerprint)
            return true;
        return core::sceneFingerprint(core::readBenchmarkScene(dataset, {}, info.setup)) ==
               info.fingerprint;   // the run may have drawn nothing from one
    } catch (const core::Error&) { // it lacks what they need
        return false;
    }
}

} // namespace

/// What has been found so far; shared by the window and the workers.
struct BenchmarkRunner::Live {
    std::mutex mutex;
    core::BenchmarkFolder folder;
    bool isReady = false; ///< the pairs are drawn
    bool hasNews = false;
};

BenchmarkRunner::BenchmarkRunner(JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_job(pool)
    , m_fileJob(pool) {
    connect(&m_job, &Job::started, this, &BenchmarkRunner::started);
    connect(&m_job, &Job::progressed, this, &BenchmarkRunner::progressed);
    connect(&m_job, &Job::progressed, this, [this] {
        if (!m_sinceUpdate.isValid() || m_sinceUpdate.elapsed() >= kUpdateMs)
            takeLive();
    });
    connect(&m_job, &Job::failed, this, [this](const QString& message) {
        takeLive();
        emit failed(message);
    });
    connect(&m_job, &Job::finished, this, &BenchmarkRunner::finished);
    connect(&m_fileJob, &Job::failed, this, &BenchmarkRunner::fileFailed);
}

BenchmarkRunner::~BenchmarkRunner() = default;

void BenchmarkRunner::setDataset(std::shared_ptr<const core::Dataset> dataset) {
    m_job.stop();
    m_fileJob.stop();
    m_live.reset();
    m_dataset = std::move(dataset);
    take(nullptr);
    emit cleared();
}

void BenchmarkRunner::take(FolderPtr folder) {
    m_folder = std::move(folder);
    m_results = m_folder ? std::shared_ptr<const core::BenchmarkResults>(m_folder, &m_folder->results) : nullptr;
    emit updated();
}

void BenchmarkRunner::takeLive() {
    if (!m_live)
        return;
    auto snapshot = std::make_shared<core::BenchmarkFolder>();
    {
        const std::scoped_lock lock(m_live->mutex);
        if (!m_live->isReady || !std::exchange(m_live->hasNews, false))
            return;
        *snapshot = m_live->folder;
    }
    m_sinceUpdate.start();
    take(snapshot);
}

void BenchmarkRunner::run(const BenchmarkRequest& request) {
    if (!m_dataset) {
        emit failed(tr("Open a dataset first."));
        return;
    }
    m_live = std::make_shared<Live>();
    m_sinceUpdate.invalidate();
    m_job.start([this, request, live = m_live, dataset = m_dataset](const JobContext& context) -> Job::Delivery {
        const core::BenchmarkScene scene = core::readBenchmarkScene(*dataset, request.sequences, request.setup);
        const auto pairs = core::drawPairs(core::pairFrames(scene, request.setup), request.pairs);
        core::BenchmarkOptions options;
        options.setup = request.setup;
        options.methods = request.methods;
        options.threads = std::max(1, QThread::idealThreadCount() - 1); // one is left to the window
        const core::BenchmarkRunInfo info = core::describeRun(dataset->folder.string(), scene, options, pairs);
        {
            const std::scoped_lock lock(live->mutex);
            live->folder = {info, {info.joints, pairs, info.methods, {}, {}, true, info.papersHands}};
            live->isReady = live->hasNews = true;
        }
        const auto progress = [&](const core::BenchmarkProgress& state) {
            if (state.latest != nullptr) {
                const std::scoped_lock lock(live->mutex);
                live->folder.results.rows.push_back(*state.latest);
                live->hasNews = true;
            }
            const double fraction = state.total > 0 ? double(state.finished) / state.total : 0;
            context.report(fraction, BenchmarkRunner::tr("%1 of %2 fits").arg(state.finished).arg(state.total));
        };
        auto whole = std::make_shared<core::BenchmarkFolder>();
        whole->info = info;
        whole->results =
            core::runBenchmark(scene, pairs, options, core::poseEstimatorOf(scene), progress, context.stop);
        return [this, whole] {
            m_live.reset();
            take(whole);
        };
    });
}

void BenchmarkRunner::stop() {
    m_job.requestEnd();
}

void BenchmarkRunner::save(const QString& folder) {
    if (!m_folder) {
        emit fileFailed(tr("There are no results to save yet."));
        return;
    }
    m_fileJob.start([this, folder, content = m_folder](const JobContext&) -> Job::Delivery {
        const std::filesystem::path path = folder.toStdString();
        if (const QString objection = objectionTo(path, *content); !objection.isEmpty())
            return [this, objection] { emit fileFailed(objection); };
        core::BenchmarkFolder sorted = *content; // rows of a run that goes on stand in the order in which they came
        core::sortRows(sorted.results);
        core::writeBenchmarkFolder(path, sorted);
        return [this, folder] { emit saved(folder); };
    });
}

void BenchmarkRunner::open(const QString& folder) {
    if (isRunning()) {
        emit fileFailed(tr("Stop the benchmark first."));
        return;
    }
    m_fileJob.start([this, folder, dataset = m_dataset](const JobContext&) -> Job::Delivery {
        const auto content =
            std::make_shared<const core::BenchmarkFolder>(core::readBenchmarkFolder(folder.toStdString()));
        QString note;
        if (!dataset || !isOf(content->info, *dataset))
            note = tr("These results are not of the open dataset, or it has changed since: %1.")
                       .arg(QDir::toNativeSeparators(QString::fromStdString(content->info.dataset)));
        else if (content->results.stopped)
            note = tr("This benchmark is not finished: %n fit(s) are in.", nullptr,
                      static_cast<int>(content->results.rows.size()));
        return [this, folder, content, note] {
            take(content);
            emit opened(folder, note);
        };
    });
}

} // namespace widgets
