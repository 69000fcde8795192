// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "core/benchmark/benchmark_results.h"
#include "core/benchmark/benchmark_run.h"

namespace core {

/// What a folder of results is about: `run.json` and `pairs.json`.
struct BenchmarkRunInfo {
    std::string dataset;     ///< folder of the dataset, as given
    std::string fingerprint; ///< sceneFingerprint of what was measured
    BenchmarkSetup setup = BenchmarkSetup::Synthetic;
    std::vector<std::string> methods;
    std::vector<std::string> external; ///< those of `methods` that are other trackers' estimates
    Shard shard;
    bool sweep = false;
    std::vector<JointId> joints;
    std::vector<FramePair> pairs; ///< of all shards
    bool papersHands = false;     ///< as in BenchmarkResults
    bool operator==(const BenchmarkRunInfo&) const = default;
};

/// The run of these methods on these pairs of the scene.
BenchmarkRunInfo describeRun(const std::string& dataset, const BenchmarkScene& scene, const BenchmarkOptions& options,
                             const std::vector<FramePair>& pairs);

BenchmarkRunInfo readRunInfo(const std::filesystem::path& folder);
void writeRunInfo(const std::filesystem::path& folder, const BenchmarkRunInfo& info);

/// The rows of `finished.jsonl`, in the order in which they were finished. A last line that was cut off is left out;
/// any other line that makes no sense throws Error(BadInput). Each row must have `jointCount` joint errors.
std::vector<PairResult> readFinishedRows(const std::filesystem::path& folder, std::size_t jointCount);
/// Rewrites that file, atomically.
void writeFinishedRows(const std::filesystem::path& folder, const std::vector<PairResult>& rows);

/// The finished fits of a run, one line each, flushed as they come: whatever ends the program, at most the line being
/// written is lost, and the next run of the same work goes on from there.
class BenchmarkJournal {
public:
    /// Opens or creates the folder. Throws Error(Usage) if it holds results of other data, pairs, setup or shard (other
    /// methods do not matter: finished pairs stay finished).
    BenchmarkJournal(const std::filesystem::path& folder, const BenchmarkRunInfo& info);
    ~BenchmarkJournal();
    BenchmarkJournal(const BenchmarkJournal&) = delete;
    BenchmarkJournal& operator=(const BenchmarkJournal&) = delete;

    /// Rows of earlier runs, without external estimates (they are read anew).
    const std::vector<PairResult>& finished() const { return m_finished; }
    /// Throws Error(Io) if the line cannot be written.
    void append(const PairResult& row);

private:
    std::filesystem::path m_file;
    std::vector<PairResult> m_finished;
    std::FILE* m_stream = nullptr;
};

} // namespace core
