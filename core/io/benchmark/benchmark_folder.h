// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "core/benchmark/benchmark_results.h"
#include "core/benchmark/setups_report.h"
#include "core/io/benchmark/benchmark_journal.h"

namespace core {

/// A folder of results.
struct BenchmarkFolder {
    BenchmarkRunInfo info;
    BenchmarkResults results;
};

/// Reads what a run has written, finished or not: the rows of the methods that it was last asked for.
BenchmarkFolder readBenchmarkFolder(const std::filesystem::path& folder);

/// Brings the folders of all shards of a run together, in the order of a run without shards. Throws Error(Usage) if
/// they belong to different runs, or if a shard is missing, named twice, or not finished.
BenchmarkFolder mergedBenchmarkFolders(const std::vector<std::filesystem::path>& folders);

/// Writes results.csv, joints.csv, curves.csv, table.md, table.tex and report.html, each atomically.
void writeBenchmarkTables(const std::filesystem::path& folder, const BenchmarkFolder& content);

/// The results of several setups for tables; they point into `folders`.
std::vector<SetupResults> setupResults(const std::vector<BenchmarkFolder>& folders);
/// Where a run in both setups keeps the results of one: "synthetic" or "realistic" within its folder.
std::filesystem::path setupFolder(const std::filesystem::path& folder, BenchmarkSetup setup);
/// True for the folder of a run in both setups.
bool holdsBothSetups(const std::filesystem::path& folder);
/// Writes table.md, table.tex and report.html of several setups side by side, each atomically.
void writeSetupTables(const std::filesystem::path& folder, const std::vector<BenchmarkFolder>& setups);

/// Writes a folder that no run has filled: run.json, pairs.json, finished.jsonl and the tables.
void writeBenchmarkFolder(const std::filesystem::path& folder, const BenchmarkFolder& content);

} // namespace core
