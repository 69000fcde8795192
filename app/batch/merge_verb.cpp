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

void merge(const std::vector<std::string>& folders, const std::string& out) {
    const std::vector<std::filesystem::path> paths(folders.begin(), folders.end());
    if (!std::all_of(paths.begin(), paths.end(), core::holdsBothSetups)) {
        const core::BenchmarkFolder merged = core::mergedBenchmarkFolders(paths);
        core::writeBenchmarkFolder(out, merged);
        std::printf("%s", core::markdownTable(core::resultTable(merged.results, merged.info.setup)).c_str());
        return;
    }
    std::vector<core::BenchmarkFolder> merged;
    for (const core::BenchmarkSetup setup : {core::BenchmarkSetup::Synthetic, core::BenchmarkSetup::Realistic}) {
        std::vector<std::filesystem::path> parts;
        for (const std::filesystem::path& path : paths)
            parts.push_back(core::setupFolder(path, setup));
        merged.push_back(core::mergedBenchmarkFolders(parts));
        core::writeBenchmarkFolder(core::setupFolder(out, setup), merged.back());
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
