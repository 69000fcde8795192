// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QString>

#include "core/benchmark/benchmark_run.h"
#include "core/benchmark/comparison/benchmark_digest.h"
#include "core/benchmark/rank_agreement.h"
#include "core/io/benchmark/benchmark_folder.h"
#include "core/io/dataset/dataset.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// What a benchmark of the open dataset is asked to do.
struct BenchmarkRequest {
    std::vector<std::string> sequences; ///< empty: all with a recorded motion
    std::vector<std::string> methods;
    std::vector<core::BenchmarkSetup> setups{core::BenchmarkSetup::Synthetic}; ///< one or both, in this order
    core::PairOptions pairs;
    /// These pairs of the results that are shown, instead of sequences, setups and drawn pairs: what the methods make
    /// of them is added to the results.
    std::vector<core::FramePair> framePairs;
};

/// Runs the benchmark in the background, hands its results out as they come, writes them as the command line does, and
/// reads what that has written. Stopping keeps the pairs that are finished.
class BenchmarkRunner : public QObject {
    Q_OBJECT

public:
    explicit BenchmarkRunner(JobPool& pool, QObject* parent = nullptr);
    ~BenchmarkRunner() override;

    void setDataset(std::shared_ptr<const core::Dataset> dataset);
    void run(const BenchmarkRequest& request);
    void stop();
    bool isRunning() const { return m_job.isRunning(); }

    /// Writes the results that there are into a folder: all files of `handlens-batch benchmark`, with one page for both
    /// setups. A folder that holds other results is not touched. Ends with saved() or fileFailed().
    void save(const QString& folder);
    /// Shows the results of such a folder. Ends with opened() or fileFailed().
    void open(const QString& folder);

    /// The last results of this dataset, finished or not, or those of a folder that was opened; of a run in both setups
    /// those that show() has chosen, else the first ones. Null if there are none.
    const std::shared_ptr<const core::BenchmarkResults>& results() const { return m_results; }
    /// What is shown of them; null if there are none.
    const std::shared_ptr<const core::BenchmarkDigest>& digest() const { return m_digest; }
    /// The same with a row per pair; null if there are none.
    std::shared_ptr<const core::PairTable> pairTable() const {
        return m_digest ? std::shared_ptr<const core::PairTable>(m_digest, &m_digest->table) : nullptr;
    }
    /// Their setup.
    core::BenchmarkSetup setup() const;
    /// All setups that there are results of.
    std::vector<core::BenchmarkSetup> setups() const;
    /// Which of them results() are from now on.
    void show(core::BenchmarkSetup setup);
    /// How far the orders of the methods in both setups agree. No value without both, and before a run has ended.
    std::optional<core::RankAgreement> agreement() const { return m_held ? m_held->agreement : std::nullopt; }

signals:
    void started();
    void progressed(double fraction, const QString& text);
    /// There are other results, or more of them.
    void updated();
    void finished();
    void failed(const QString& message);
    void cleared();
    void saved(const QString& folder);
    /// `note` says what must be known about them; empty if nothing must.
    void opened(const QString& folder, const QString& note);
    void fileFailed(const QString& message);

private:
    struct Live;
    struct SetupRun;
    struct Held {
        std::vector<core::BenchmarkFolder> folders; ///< one per setup, at least one
        std::optional<core::RankAgreement> agreement;
        std::vector<std::shared_ptr<const core::BenchmarkDigest>>
            digests; ///< parallel to folders; none while a run goes on
    };
    static std::vector<SetupRun> setupRuns(const core::Dataset& dataset, const BenchmarkRequest& request,
                                           const core::BenchmarkFolder* there);
    static std::shared_ptr<const Held> makeHeld(std::vector<core::BenchmarkFolder> folders);
    Job::Delivery work(const std::vector<SetupRun>& runs, Live& live, const JobContext& context);
    void take(std::shared_ptr<const Held> held);
    void takeLive();
    const core::BenchmarkFolder* shown() const;

    Job m_job;
    Job m_fileJob;
    std::shared_ptr<const core::Dataset> m_dataset;
    std::shared_ptr<Live> m_live; ///< of the run that goes on
    QElapsedTimer m_sinceUpdate;
    qint64 m_updateMs = 0; ///< at least so long between two updates of a run
    std::shared_ptr<const Held> m_held;
    core::BenchmarkSetup m_shown = core::BenchmarkSetup::Synthetic;
    std::shared_ptr<const core::BenchmarkResults> m_results; ///< of the shown one of m_held
    std::shared_ptr<const core::BenchmarkDigest> m_digest;
};

} // namespace widgets
