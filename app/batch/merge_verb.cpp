// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/batch/verbs.h"
#include "core/benchmark/result_table.h"
#include "core/benchmark/setups_report.h"
#include "core/io/benchmark/benchmark_folder.h"

namespace app {

namespace {

/// True for the folder of a run in both setups.
bool holdsBothSetups(const std::filesystem::path& folder) {
    return !std::filesystem::exists(folder / "run.json") && std::filesystem::exists(folder / "synthetic/run.json") &&
           std::filesystem::exists(folder / "realistic/run.json");
}

void merge(const std::vector<std::string>& folders, const std::string& out) {
    const std::vector<std::filesystem::path> paths(folders.begin(), folders.end());
    if (!std::all_of(paths.begin(), paths.end(), holdsBothSetups)) {
        const core::BenchmarkFolder merged = core::mergedBenchmarkFolders(paths);
        core::writeBenchmarkFolder(out, merged);
        std::printf("%s", core::markdownTable(core::resultTable(merged.results, merged.info.setup)).c_str());
        return;
    }
    std::vector<core::BenchmarkFolder> merged;
    for (const char* setup : {"synthetic", "realistic"}) {
        std::vector<std::filesystem::path> parts;
        for (const std::filesystem::path& path : paths)
            parts.push_back(path / setup);
        merged.push_back(core::mergedBenchmarkFolders(parts));
        core::writeBenchmarkFolder(std::filesystem::path(out) / setup, merged.back());
    }
    core::writeSetupTables(out, merged);
    std::printf("%s", core::markdownTable(core::setupsTable(core::setupResults(merged))).c_str());
}

} // namespace

void addMergeVerb(CLI::App& program) {
    auto folders = std::make_shared<std::vector<std::string>>();
    auto out = std::make_shared<std::string>();
    CLI::App* verb = program.add_subcommand("merge", "Bring the results of all shards of a benchmark together");
    verb->add_option("folders", *folders, "The folders of the shards")->required();
    verb->add_option("--out", *out, "The folder for the merged results")->required();
    verb->callback([folders, out] { merge(*folders, *out); });
}

} // namespace app
