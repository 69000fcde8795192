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

/// What a benchmark that is finished or ended early has: a setup that it did not come to is left out.
std::vector<core::BenchmarkFolder> withRows(std::vector<core::BenchmarkFolder> folders) {
    const auto first = folders.front();
    std::erase_if(folders, [](const core::BenchmarkFolder& folder) { return folder.results.rows.empty(); });
    return folders.empty() ? std::vector{first} : folders;
}

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

QString objectionTo(const std::filesystem::path& folder, const std::vector<core::BenchmarkFolder>& contents) {
    if (contents.size() == 1)
        return objectionTo(folder, contents.front());
    if (std::filesystem::exists(folder / "run.json"))
        return BenchmarkRunner::tr("This folder holds the results of another benchmark. Choose another one.");
    for (const core::BenchmarkFolder& content : contents)
        if (const QString why = objectionTo(core::setupFolder(folder, content.info.setup), content); !why.isEmpty())
            return why;
    for (const char* file : {"table.md", "table.tex", "report.html"})
        if (!core::holdsBothSetups(folder) && std::filesystem::exists(folder / file))
            return BenchmarkRunner::tr("This folder already holds a file %1. Choose another one.")
                .arg(QLatin1String(file));
    return {};
}

void write(const std::filesystem::path& folder, std::vector<core::BenchmarkFolder> contents) {
    for (core::BenchmarkFolder& content : contents) {
        core::sortRows(content.results); // rows of a run that goes on stand in the order in which they came
        core::writeBenchmarkFolder(contents.size() == 1 ? folder : core::setupFolder(folder, content.info.setup),
                                   content);
    }
    if (contents.size() > 1)
        core::writeSetupTables(folder, contents);
}

std::vector<core::BenchmarkFolder> read(const std::filesystem::path& folder) {
    if (!core::holdsBothSetups(folder))
        return {core::readBenchmarkFolder(folder)};
    return {core::readBenchmarkFolder(core::setupFolder(folder, core::BenchmarkSetup::Synthetic)),
            core::readBenchmarkFolder(core::setupFolder(folder, core::BenchmarkSetup::Realistic))};
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
    std::vector<core::BenchmarkFolder> folders; ///< none before the pairs are drawn
    bool hasNews = false;
};

namespace {

/// One setup, ready to run.
struct SetupRun {
    core::BenchmarkScene scene;
    core::BenchmarkOptions options;
    core::BenchmarkFolder folder; ///< without rows

    SetupRun(const core::Dataset& dataset, const BenchmarkRequest& request, core::BenchmarkSetup setup)
        : scene(core::readBenchmarkScene(dataset, request.sequences, setup)) {
        options.setup = setup;
        options.methods = request.methods;
        options.threads = std::max(1, QThread::idealThreadCount() - 1); // one is left to the window
        const auto pairs = core::drawPairs(core::pairFrames(scene, setup), request.pairs);
        folder.info = core::describeRun(dataset.folder.string(), scene, options, pairs);
        folder.results = {folder.info.joints, pairs, folder.info.methods, {}, {}, true, folder.info.papersHands};
    }
    int fits() const { return static_cast<int>(folder.info.pairs.size() * folder.info.methods.size()); }
};

} // namespace

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

void BenchmarkRunner::take(std::shared_ptr<const Held> held) {
    m_held = std::move(held);
    const core::BenchmarkFolder* folder = shown();
    m_results = folder ? std::shared_ptr<const core::BenchmarkResults>(m_held, &folder->results) : nullptr;
    emit updated();
}

const core::BenchmarkFolder* BenchmarkRunner::shown() const {
    if (!m_held)
        return nullptr;
    const std::vector<core::BenchmarkFolder>& folders = m_held->folders;
    const auto found = std::find_if(folders.begin(), folders.end(), [this](const core::BenchmarkFolder& folder) {
        return folder.info.setup == m_shown;
    });
    return found == folders.end() ? &folders.front() : &*found;
}

core::BenchmarkSetup BenchmarkRunner::setup() const {
    const core::BenchmarkFolder* folder = shown();
    return folder ? folder->info.setup : core::BenchmarkSetup::Synthetic;
}

std::vector<core::BenchmarkSetup> BenchmarkRunner::setups() const {
    std::vector<core::BenchmarkSetup> setups;
    if (m_held)
        for (const core::BenchmarkFolder& folder : m_held->folders)
            setups.push_back(folder.info.setup);
    return setups;
}

void BenchmarkRunner::show(core::BenchmarkSetup setup) {
    m_shown = setup;
    take(m_held);
}

void BenchmarkRunner::takeLive() {
    if (!m_live)
        return;
    auto snapshot = std::make_shared<Held>();
    {
        const std::scoped_lock lock(m_live->mutex);
        if (!std::exchange(m_live->hasNews, false))
            return;
        snapshot->folders = m_live->folders;
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
        std::vector<SetupRun> runs; // all that one of them lacks is said before the first begins
        for (const core::BenchmarkSetup setup : request.setups)
            runs.emplace_back(*dataset, request, setup);
        std::vector<core::BenchmarkFolder> whole;
        int total = 0, before = 0;
        for (const SetupRun& one : runs) {
            whole.push_back(one.folder);
            total += one.fits();
        }
        {
            const std::scoped_lock lock(live->mutex);
            live->folders = whole;
            live->hasNews = true;
        }
        for (std::size_t i = 0; i < runs.size() && !context.stop.stop_requested(); ++i) {
            const auto progress = [&](const core::BenchmarkProgress& state) {
                if (state.latest != nullptr) {
                    const std::scoped_lock lock(live->mutex);
                    live->folders[i].results.rows.push_back(*state.latest);
                    live->hasNews = true;
                }
                const int done = before + state.finished;
                context.report(total > 0 ? double(done) / total : 0,
                               BenchmarkRunner::tr("%1 of %2 fits").arg(done).arg(total));
            };
            whole[i].results = core::runBenchmark(runs[i].scene, runs[i].folder.info.pairs, runs[i].options,
                                                  core::poseEstimatorOf(runs[i].scene), progress, context.stop);
            before += runs[i].fits();
        }
        auto held = std::make_shared<Held>(Held{withRows(whole), {}});
        held->agreement = core::setupsRankAgreement(core::setupResults(held->folders));
        return [this, held] {
            m_live.reset();
            take(held);
        };
    });
}

void BenchmarkRunner::stop() {
    m_job.requestEnd();
}

void BenchmarkRunner::save(const QString& folder) {
    if (!m_results) {
        emit fileFailed(tr("There are no results to save yet."));
        return;
    }
    m_fileJob.start([this, folder, contents = m_held](const JobContext&) -> Job::Delivery {
        const std::filesystem::path path = folder.toStdString();
        const std::vector<core::BenchmarkFolder> filled = withRows(contents->folders);
        if (const QString objection = objectionTo(path, filled); !objection.isEmpty())
            return [this, objection] { emit fileFailed(objection); };
        write(path, filled);
        return [this, folder] { emit saved(folder); };
    });
}

void BenchmarkRunner::open(const QString& folder) {
    if (isRunning()) {
        emit fileFailed(tr("Stop the benchmark first."));
        return;
    }
    m_fileJob.start([this, folder, dataset = m_dataset](const JobContext&) -> Job::Delivery {
        auto held = std::make_shared<Held>(Held{read(folder.toStdString()), {}});
        held->agreement = core::setupsRankAgreement(core::setupResults(held->folders));
        QString note;
        int rows = 0;
        bool isOfDataset = dataset != nullptr, isStopped = false;
        for (const core::BenchmarkFolder& content : held->folders) {
            isOfDataset = isOfDataset && isOf(content.info, *dataset);
            isStopped = isStopped || content.results.stopped;
            rows += static_cast<int>(content.results.rows.size());
        }
        if (!isOfDataset)
            note = tr("These results are not of the open dataset, or it has changed since: %1.")
                       .arg(QDir::toNativeSeparators(QString::fromStdString(held->folders.front().info.dataset)));
        else if (isStopped)
            note = tr("This benchmark is not finished: %n fit(s) are in.", nullptr, rows);
        return [this, folder, held, note] {
            take(held);
            emit opened(folder, note);
        };
    });
}

} // namespace widgets
