// SPDX-License-Identifier: MIT
#include "widgets/jobs/benchmark/benchmark_runner.h"

#include <algorithm>
#include <mutex>
#include <set>

#include <QDir>
#include <QThread>

#include "core/error.h"
#include "core/io/benchmark/benchmark_scene.h"
#include "widgets/jobs/benchmark/benchmark_files.h"

namespace widgets {

namespace {

constexpr std::size_t kMostLiveRows = 20000;
constexpr qint64 kUpdateMs = 100; ///< rows may come faster than tables and curves are worth drawing

} // namespace

/// What has been found so far; shared by the window and the workers.
struct BenchmarkRunner::Live {
    std::mutex mutex;
    std::vector<core::BenchmarkFolder> folders; ///< none before the pairs are drawn
    bool hasNews = false;
};

/// One setup, ready to run.
struct BenchmarkRunner::SetupRun {
    core::BenchmarkScene scene;
    core::BenchmarkOptions options;
    std::vector<core::FramePair> pairs;
    core::BenchmarkFolder folder; ///< what there is before the first fit

    SetupRun(const core::Dataset& dataset, const BenchmarkRequest& request, core::BenchmarkSetup setup)
        : scene(core::readBenchmarkScene(dataset, request.sequences, setup)) {
        options.setup = setup;
        options.methods = request.methods;
        options.threads = std::max(1, QThread::idealThreadCount() - 1); // one is left to the window
        pairs = request.framePairs.empty() ? core::drawPairs(core::pairFrames(scene, setup), request.pairs)
                                           : request.framePairs;
        folder.info = core::describeRun(dataset.folder.string(), scene, options, pairs);
        folder.results = {folder.info.joints, pairs, folder.info.methods, {}, {}, true, folder.info.papersHands};
    }
    int fits() const { return static_cast<int>(pairs.size() * options.methods.size()); }
};

namespace {

/// The results that are there, with room for what a run of some of their pairs will find: that takes the place of what
/// they say of the same pairs and methods.
core::BenchmarkFolder withRoom(core::BenchmarkFolder there, const BenchmarkRequest& request) {
    for (const std::string& method : request.methods) {
        if (std::find(there.info.methods.begin(), there.info.methods.end(), method) == there.info.methods.end()) {
            there.info.methods.push_back(method);
            there.results.methods.push_back(method);
        }
    }
    const std::set<core::FramePair> pairs(request.framePairs.begin(), request.framePairs.end());
    const std::set<std::string> methods(request.methods.begin(), request.methods.end());
    std::erase_if(there.results.rows, [&](const core::PairResult& row) {
        return pairs.contains(row.pair) && methods.contains(row.method);
    });
    return there;
}

} // namespace

/// The setups of a request, ready to run. All that one of them lacks is said before the first begins. `there` are the
/// results that a run of chosen pairs adds to.
std::vector<BenchmarkRunner::SetupRun> BenchmarkRunner::setupRuns(const core::Dataset& dataset,
                                                                  const BenchmarkRequest& request,
                                                                  const core::BenchmarkFolder* there) {
    std::vector<SetupRun> runs;
    for (const core::BenchmarkSetup setup : request.setups)
        runs.emplace_back(dataset, request, setup);
    if (!request.framePairs.empty() && there)
        runs.front().folder = withRoom(*there, request);
    return runs;
}

BenchmarkRunner::BenchmarkRunner(JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_job(pool)
    , m_fileJob(pool) {
    connect(&m_job, &Job::started, this, &BenchmarkRunner::started);
    connect(&m_job, &Job::progressed, this, &BenchmarkRunner::progressed);
    connect(&m_job, &Job::progressed, this, [this] {
        if (!m_sinceUpdate.isValid() || m_sinceUpdate.elapsed() >= m_updateMs)
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
    m_digest = nullptr;
    if (folder) {
        const auto place = static_cast<std::size_t>(folder - m_held->folders.data());
        m_digest = place < m_held->digests.size()
                       ? m_held->digests[place]
                       : std::make_shared<core::BenchmarkDigest>(core::benchmarkDigest(*m_results));
    }
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
        std::size_t rows = 0;
        for (const core::BenchmarkFolder& folder : m_live->folders)
            rows += folder.results.rows.size();
        if (rows > kMostLiveRows || !std::exchange(m_live->hasNews, false))
            return; // of very many results, the new ones are shown at the end
        snapshot->folders = m_live->folders;
    }
    m_sinceUpdate.start();
    take(snapshot);
    m_updateMs = std::max(kUpdateMs, 10 * m_sinceUpdate.elapsed()); // many results take longer to show
    m_sinceUpdate.start();
}

void BenchmarkRunner::run(const BenchmarkRequest& asked) {
    if (!m_dataset) {
        emit failed(tr("Open a dataset first."));
        return;
    }
    BenchmarkRequest request = asked;
    std::shared_ptr<const core::BenchmarkFolder> there; // keeps what holds it
    if (!request.framePairs.empty()) {
        request.setups = {setup()};
        request.sequences.clear();
        for (const core::FramePair& pair : request.framePairs)
            if (std::find(request.sequences.begin(), request.sequences.end(), pair.sequence) == request.sequences.end())
                request.sequences.push_back(pair.sequence);
        there = std::shared_ptr<const core::BenchmarkFolder>(m_held, shown());
    }
    m_live = std::make_shared<Live>();
    m_sinceUpdate.invalidate();
    m_job.start([this, request, there, live = m_live, dataset = m_dataset](const JobContext& context) -> Job::Delivery {
        if (there && !areResultsOf(there->info, *dataset))
            return [this] {
                emit failed(tr("These results are not of the open dataset, or it has changed since: pairs cannot be "
                               "added to them."));
            };
        return work(setupRuns(*dataset, request, there.get()), *live, context);
    });
}

Job::Delivery BenchmarkRunner::work(const std::vector<SetupRun>& runs, Live& live, const JobContext& context) {
    std::vector<core::BenchmarkFolder> whole;
    int total = 0, before = 0;
    for (const SetupRun& one : runs) {
        whole.push_back(one.folder);
        total += one.fits();
    }
    {
        const std::scoped_lock lock(live.mutex);
        live.folders = whole;
        live.hasNews = true;
    }
    for (std::size_t i = 0; i < runs.size() && !context.stop.stop_requested(); ++i) {
        const auto progress = [&](const core::BenchmarkProgress& state) {
            if (state.latest != nullptr) {
                const std::scoped_lock lock(live.mutex);
                live.folders[i].results.rows.push_back(*state.latest);
                live.hasNews = true;
            }
            const int done = before + state.finished;
            context.report(total > 0 ? double(done) / total : 0,
                           BenchmarkRunner::tr("%1 of %2 fits").arg(done).arg(total));
        };
        const core::BenchmarkResults found =
            core::runBenchmark(runs[i].scene, runs[i].pairs, runs[i].options, core::poseEstimatorOf(runs[i].scene),
                               progress, context.stop);
        core::BenchmarkResults& all = whole[i].results;
        all.rows.insert(all.rows.end(), found.rows.begin(), found.rows.end());
        all.stopped = found.stopped || all.rows.size() < all.pairs.size() * all.methods.size();
        core::sortRows(all);
        before += runs[i].fits();
    }
    const auto held = makeHeld(filledFolders(std::move(whole)));
    return [this, held] {
        m_live.reset();
        take(held);
    };
}

/// With all that takes long for many results.
std::shared_ptr<const BenchmarkRunner::Held> BenchmarkRunner::makeHeld(std::vector<core::BenchmarkFolder> folders) {
    auto held = std::make_shared<Held>(Held{std::move(folders), {}, {}});
    held->agreement = core::setupsRankAgreement(core::setupResults(held->folders));
    for (const core::BenchmarkFolder& folder : held->folders)
        held->digests.push_back(std::make_shared<core::BenchmarkDigest>(core::benchmarkDigest(folder.results)));
    return held;
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
        const std::vector<core::BenchmarkFolder> filled = filledFolders(contents->folders);
        if (const QString objection = resultsObjection(path, filled); !objection.isEmpty())
            return [this, objection] { emit fileFailed(objection); };
        writeResults(path, filled);
        return [this, folder] { emit saved(folder); };
    });
}

void BenchmarkRunner::open(const QString& folder) {
    if (isRunning()) {
        emit fileFailed(tr("Stop the benchmark first."));
        return;
    }
    m_fileJob.start([this, folder, dataset = m_dataset](const JobContext&) -> Job::Delivery {
        const auto held = makeHeld(readResults(folder.toStdString()));
        QString note;
        int rows = 0;
        bool isOfDataset = dataset != nullptr, isStopped = false;
        for (const core::BenchmarkFolder& content : held->folders) {
            isOfDataset = isOfDataset && areResultsOf(content.info, *dataset);
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
