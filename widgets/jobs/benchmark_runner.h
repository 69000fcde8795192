// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "core/benchmark/benchmark_run.h"
#include "core/io/dataset.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// What a benchmark of the open dataset is asked to do.
struct BenchmarkRequest {
    std::vector<std::string> sequences; ///< empty: all with a recorded motion
    std::vector<std::string> methods;
    core::BenchmarkSetup setup = core::BenchmarkSetup::Synthetic;
    core::PairOptions pairs;
};

/// Runs the benchmark in the background. Stopping keeps the pairs that are finished.
class BenchmarkRunner : public QObject {
    Q_OBJECT

public:
    explicit BenchmarkRunner(JobPool& pool, QObject* parent = nullptr);

    void setDataset(std::shared_ptr<const core::Dataset> dataset);
    void run(const BenchmarkRequest& request);
    void stop();
    bool isRunning() const { return m_job.isRunning(); }

    /// The last results of this dataset, or null.
    const std::shared_ptr<const core::BenchmarkResults>& results() const { return m_results; }
    /// Their setup.
    core::BenchmarkSetup setup() const { return m_setup; }

signals:
    void started();
    void progressed(double fraction, const QString& text);
    void finished();
    void failed(const QString& message);
    void cleared();

private:
    Job m_job;
    std::shared_ptr<const core::Dataset> m_dataset;
    std::shared_ptr<const core::BenchmarkResults> m_results;
    core::BenchmarkSetup m_setup = core::BenchmarkSetup::Synthetic;
};

} // namespace widgets
