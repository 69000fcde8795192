// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include <QString>

#include "core/io/benchmark/benchmark_folder.h"
#include "core/io/dataset/dataset.h"

namespace widgets {

/// What a benchmark that is finished or ended early has: a setup that it did not come to is left out.
std::vector<core::BenchmarkFolder> filledFolders(std::vector<core::BenchmarkFolder> folders);

/// Why the folder cannot take these results, in the person's language; empty if it can. What is there is never
/// replaced.
QString resultsObjection(const std::filesystem::path& folder, const std::vector<core::BenchmarkFolder>& contents);

/// Writes results of one setup or of both. Rows of a run that goes on may stand in any order.
void writeResults(const std::filesystem::path& folder, std::vector<core::BenchmarkFolder> contents);

/// Reads results of one setup, or of both. Throws core::Error.
std::vector<core::BenchmarkFolder> readResults(const std::filesystem::path& folder);

/// True if the results were made from this dataset as it is now.
bool areResultsOf(const core::BenchmarkRunInfo& info, const core::Dataset& dataset);

} // namespace widgets
