// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "app/batch/benchmark_arguments.h"
#include "app/batch/interrupt.h"
#include "app/batch/progress.h"
#include "app/batch/verbs.h"
#include "core/benchmark/benchmark_run.h"
#include "core/benchmark/result_table.h"
#include "core/benchmark/setups_report.h"
#include "core/benchmark/sweep.h"
#include "core/error.h"
#include "core/io/benchmark/benchmark_folder.h"
#include "core/io/benchmark/benchmark_journal.h"
#include "core/io/benchmark/benchmark_scene.h"
#include "core/io/benchmark/external_estimates.h"
#include "core/io/benchmark/pairs_file.h"
#include "core/io/dataset/dataset.h"

namespace app {

namespace {

core::Shard shardFrom(const std::string& text) {
    core::Shard shard;
    char rest = 0;
    if (!text.empty() && std::sscanf(text.c_str(), "%d/%d%c", &shard.index, &shard.count, &rest) != 2)
        throw core::Error(core::ErrorCode::Usage, "", "--shard", "'" + text + "' is not i/n, such as 0/4");
    return shard;
}

core::BenchmarkOptions optionsFrom(const BenchmarkArguments& arguments, const std::string& setup) {
    core::BenchmarkOptions options;
    options.setup = setup == "realistic" ? core::BenchmarkSetup::Realistic : core::BenchmarkSetup::Synthetic;
    options.methods = arguments.sweep.empty() ? arguments.methods : core::sweepMethods();
    options.threads = arguments.threads;
    options.shard = shardFrom(arguments.shard);
    return options;
}

std::vector<core::ExternalEstimates> externalFrom(const BenchmarkArguments& arguments, const core::Dataset& dataset) {
    std::vector<core::ExternalEstimates> external;
    for (const std::string& text : arguments.external) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos)
            throw core::Error(core::ErrorCode::Usage, "", "--external", "'" + text + "' is not NAME=FILE");
        external.push_back(core::readExternalEstimates(text.substr(0, equals), text.substr(equals + 1), dataset.hands));
    }
    return external;
}

core::BenchmarkRunInfo runInfo(const BenchmarkArguments& arguments, const core::BenchmarkOptions& options,
                               const core::BenchmarkScene& scene) {
    const std::vector<core::FramePair> pairs =
        arguments.pairs.empty() ? core::drawPairs(core::pairFrames(scene, options.setup), arguments.draw)
                                : core::readPairs(arguments.pairs);
    core::BenchmarkRunInfo info = core::describeRun(arguments.dataset, scene, options, pairs);
    info.sweep = !arguments.sweep.empty();
    return info;
}

/// The rows of all other trackers in this shard; adds their names to the run.
std::vector<core::PairResult> externalRows(const std::vector<core::ExternalEstimates>& external,
                                           const core::BenchmarkScene& scene, const core::BenchmarkOptions& options,
                                           core::BenchmarkRunInfo& info) {
    std::vector<core::PairResult> rows;
    for (const core::ExternalEstimates& estimates : external) {
        const std::vector<core::PairResult> all = core::externalRows(scene, options.setup, info.pairs, estimates);
        for (const core::PairResult& row : core::rowsOfPairs(all, core::pairsOfShard(info.pairs, options.shard)))
            rows.push_back(row);
        info.methods.push_back(estimates.name);
        info.external.push_back(estimates.name);
    }
    return rows;
}

core::BenchmarkResults run(const core::BenchmarkScene& scene, const core::BenchmarkRunInfo& info,
                           const core::BenchmarkOptions& options, core::BenchmarkJournal& journal) {
    Progress bar("benchmark");
    const auto progress = [&](const core::BenchmarkProgress& state) {
        if (state.latest != nullptr)
            journal.append(*state.latest);
        bar.show(state.finished, state.total);
    };
    return core::runBenchmark(scene, info.pairs, options, core::poseEstimatorOf(scene), progress, interruptToken(),
                              journal.finished());
}

/// One setup into a folder of its own: all files of a single run.
core::BenchmarkFolder runSetup(const BenchmarkArguments& arguments, const std::string& setup, const std::string& out) {
    const core::BenchmarkOptions options = optionsFrom(arguments, setup);
    const core::Dataset dataset = core::readDataset(arguments.dataset);
    const core::BenchmarkScene scene = core::readBenchmarkScene(dataset, arguments.sequences, options.setup);
    core::BenchmarkFolder folder{runInfo(arguments, options, scene), {}};
    core::requireRunnable(scene, folder.info.pairs, options);
    const std::vector<core::PairResult> external =
        externalRows(externalFrom(arguments, dataset), scene, options, folder.info);
    core::BenchmarkJournal journal(out, folder.info);
    folder.results = run(scene, folder.info, options, journal);
    for (const core::PairResult& row : external)
        journal.append(row);
    core::addExternalRows(folder.results, folder.info.external, external);
    core::writeBenchmarkTables(out, folder);
    return folder;
}

void endIfStopped(const core::BenchmarkFolder& folder, const std::string& out) {
    if (folder.results.stopped)
        throw Interrupted(out + ": stopped; what is finished is kept, and the same command continues from there");
}

void benchmark(BenchmarkArguments arguments) {
    if (arguments.sweep == "realism") {
        runRealismSweep(arguments);
        return;
    }
    std::sort(arguments.setups.begin(), arguments.setups.end(), std::greater<>()); // synthetic first
    arguments.setups.erase(std::unique(arguments.setups.begin(), arguments.setups.end()), arguments.setups.end());
    if (arguments.setups.size() == 1) {
        const core::BenchmarkFolder folder = runSetup(arguments, arguments.setups.front(), arguments.out);
        std::printf("%s", core::markdownTable(core::resultTable(folder.results, folder.info.setup)).c_str());
        endIfStopped(folder, arguments.out);
        return;
    }
    std::vector<core::BenchmarkFolder> folders;
    for (const std::string& setup : arguments.setups) {
        folders.push_back(runSetup(arguments, setup, arguments.out + "/" + setup));
        endIfStopped(folders.back(), arguments.out);
    }
    core::writeSetupTables(arguments.out, folders);
    std::printf("%s", core::markdownTable(core::setupsTable(core::setupResults(folders))).c_str());
}

/// A list of pairs leaves nothing to draw: an option that would draw them was meant to do something.
void requireOneSourceOfPairs(const CLI::App& verb, bool isRealism) {
    for (const char* option : {"--fraction", "--differences", "--seed"}) {
        if (isRealism && std::string_view(option) == "--seed")
            continue; // it seeds what is simulated, too
        if (verb.count("--pairs") > 0 && verb.count(option) > 0) {
            throw core::Error(core::ErrorCode::Usage, "", std::string("--pairs and ") + option,
                              std::string("--pairs names the frame pairs, so ") + option +
                                  " would change nothing; give one of them");
        }
    }
}

} // namespace

void addBenchmarkVerb(CLI::App& program) {
    auto arguments = std::make_shared<BenchmarkArguments>();
    CLI::App* verb =
        program.add_subcommand("benchmark", "Compare methods on seeded frame pairs: tables, curves and a report");
    verb->add_option("dataset", arguments->dataset, "The dataset folder")->required();
    verb->add_option("--sequences", arguments->sequences, "Names of the sequences (all with a recorded motion)")
        ->delimiter(',');
    verb->add_option("--setup", arguments->setups,
                     "synthetic: targets rendered from the recorded poses; realistic: from the masks; "
                     "synthetic,realistic: both, side by side")
        ->delimiter(',')
        ->check(CLI::IsMember({"synthetic", "realistic"}));
    verb->add_option("--fraction", arguments->draw.fraction, "Share of the frames that are test frames (0.1)");
    verb->add_option("--differences", arguments->draw.differences, "Frames between start and test (1,5,10,15)")
        ->delimiter(',');
    verb->add_option("--seed", arguments->draw.seed, "Seed of the draw (0)");
    verb->add_option("--methods", arguments->methods, "Methods with their options, such as ch,dch-thres:tau=45,best")
        ->delimiter(',');
    verb->add_option("--sweep", arguments->sweep,
                     "figures: the settings of the paper's figures and every open option, instead of --methods; "
                     "realism: silhouettes that get less and less perfect (simulated)")
        ->check(CLI::IsMember({"figures", "realism"}));
    verb->add_option("--settings", arguments->settings, "Only these settings of --sweep realism")->delimiter(',');
    verb->add_option(
        "--external", arguments->external,
        "NAME=FILE: another tracker's joints (CSV sequence,start,test,hand,name,x,y,z, or JSON), a row of their own");
    verb->add_option("--pairs", arguments->pairs, "A pairs.json to use instead of drawing pairs");
    verb->add_option("--threads", arguments->threads, "Pairs that are solved side by side (1)")
        ->check(CLI::Range(1, 256));
    verb->add_option("--shard", arguments->shard, "i/n: only the i-th of n parts of the work, counted from 0");
    verb->add_option("--out", arguments->out,
                     "The folder for the results; a second run goes on where the first one ended")
        ->required();
    verb->callback([arguments, verb] {
        requireOneSourceOfPairs(*verb, arguments->sweep == "realism");
        benchmark(*arguments);
    });
}

} // namespace app
