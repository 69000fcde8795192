// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>

#include "app/batch/benchmark_arguments.h"
#include "app/batch/interrupt.h"
#include "app/batch/progress.h"
#include "core/benchmark/realism_scene.h"
#include "core/error.h"
#include "core/io/benchmark/benchmark_journal.h"
#include "core/io/benchmark/benchmark_scene.h"
#include "core/io/benchmark/pairs_file.h"
#include "core/io/benchmark/realism_folder.h"
#include "core/io/dataset/dataset.h"

namespace app {

namespace {

/// The settings that are asked for, in their own order; all if none is named.
std::vector<core::RealismSetting> chosenSettings(const std::vector<std::string>& names) {
    std::vector<core::RealismSetting> settings = core::realismSettings();
    for (const std::string& name : names) {
        const bool isKnown = std::any_of(settings.begin(), settings.end(),
                                         [&](const core::RealismSetting& setting) { return setting.id == name; });
        if (isKnown)
            continue;
        std::string known;
        for (const core::RealismSetting& setting : settings)
            known += (known.empty() ? "" : ", ") + setting.id;
        throw core::Error(core::ErrorCode::Usage, "", "--settings",
                          "unknown setting " + name + " (there are: " + known + ")");
    }
    if (!names.empty()) {
        std::erase_if(
            settings,
            [&](const core::RealismSetting& setting) {
                return std::find(names.begin(), names.end(), setting.id) == names.end();
            });
    }
    return settings;
}

core::RealismResult runSetting(const BenchmarkArguments& arguments, const core::BenchmarkScene& clean,
                               const std::vector<core::FramePair>& pairs, const core::RealismSetting& setting) {
    core::BenchmarkOptions options;
    options.setup = core::BenchmarkSetup::Realistic;
    options.methods = arguments.methods;
    options.threads = arguments.threads;
    const core::BenchmarkScene scene = core::realismScene(clean, setting, pairs, arguments.draw.seed, interruptToken());
    core::BenchmarkJournal journal(core::realismSettingFolder(arguments.out, setting),
                                   core::describeRun(arguments.dataset, scene, options, pairs));
    Progress bar(setting.id);
    const auto progress = [&](const core::BenchmarkProgress& state) {
        if (state.latest != nullptr)
            journal.append(*state.latest);
        bar.show(state.finished, state.total);
    };
    return {setting,
            core::runBenchmark(scene, pairs, options, core::poseEstimatorOf(scene), progress, interruptToken(),
                               journal.finished()),
            {}};
}

} // namespace

void runRealismSweep(const BenchmarkArguments& arguments) {
    if (!arguments.external.empty() || !arguments.shard.empty()) {
        throw core::Error(core::ErrorCode::Usage, "", "--sweep realism",
                          "has no shards and no external estimates: split it by --settings");
    }
    const std::vector<core::RealismSetting> settings = chosenSettings(arguments.settings);
    const core::Dataset dataset = core::readDataset(arguments.dataset);
    const core::BenchmarkScene clean =
        core::readBenchmarkScene(dataset, arguments.sequences, core::BenchmarkSetup::Synthetic);
    const std::vector<core::FramePair> pairs =
        arguments.pairs.empty()
            ? core::drawPairs(core::pairFrames(clean, core::BenchmarkSetup::Synthetic), arguments.draw)
            : core::readPairs(arguments.pairs);
    core::BenchmarkOptions options;
    options.methods = arguments.methods;
    core::requireRunnable(clean, pairs, options);
    std::vector<core::RealismResult> results;
    for (const core::RealismSetting& setting : settings) {
        results.push_back(runSetting(arguments, clean, pairs, setting));
        if (results.back().results.stopped)
            break;
    }
    core::writeRealismTables(arguments.out, arguments.dataset, results, arguments.methods);
    core::addAgreements(results, arguments.methods);
    std::printf("%s", core::realismMarkdown(results, arguments.methods).c_str());
    if (results.back().results.stopped) {
        throw Interrupted(arguments.out +
                          ": stopped; what is finished is kept, and the same command continues from there");
    }
}

} // namespace app
