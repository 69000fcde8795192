// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>

#include "app/batch/interrupt.h"
#include "app/batch/progress.h"
#include "app/batch/verbs.h"
#include "core/error.h"
#include "core/io/demo/demo_dataset.h"
#include "core/io/demo/realistic_demo.h"

namespace app {

namespace {

struct DemoArguments {
    std::string out, level = "casual";
    std::uint64_t seed = 1;
    bool realistic = false;
};

void writeDemo(const std::string& out) {
    const core::NewDataset demo = core::makeDemoDataset();
    core::writeDataset(demo.dataset, demo.motions, out);
    std::printf("%s: %zu hands, %zu sequences, %zu cameras\n", out.c_str(), demo.dataset.hands.size(),
                demo.dataset.sequences.size(), demo.dataset.cameras.size());
}

void writeRealistic(const DemoArguments& arguments) {
    core::RealisticDemoOptions options;
    options.level = arguments.level == "studio" ? core::RealismLevel::Studio : core::RealismLevel::Casual;
    options.seed = arguments.seed;
    options.threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 16U));
    Progress bar("pictures");
    const core::RealisticDemoSummary summary = core::writeRealisticDemo(
        arguments.out, options, [&](int finished, int total) { bar.show(finished, total); }, interruptToken());
    if (summary.stopped)
        throw Interrupted(arguments.out + ": stopped; nothing was written");
    std::printf("%s: simulated, %s; %d frames, %d pictures and masks, %d clicks by rater \"sim\", %d of them wrong\n",
                arguments.out.c_str(), arguments.level.c_str(), summary.frames, summary.pictures, summary.clicks,
                summary.wrongClicks);
    std::printf("%s/truth: the true cameras, hands and joints\n", arguments.out.c_str());
}

void demo(const DemoArguments& arguments, const CLI::App& verb) {
    for (const char* option : {"--level", "--seed"})
        if (!arguments.realistic && verb.count(option) > 0)
            throw core::Error(core::ErrorCode::Usage, option, "", "is for --realistic");
    if (arguments.realistic)
        writeRealistic(arguments);
    else
        writeDemo(arguments.out);
}

} // namespace

void addDemoVerb(CLI::App& program) {
    auto arguments = std::make_shared<DemoArguments>();
    CLI::App* verb =
        program.add_subcommand("demo", "Write the demo dataset: two hands, four choreographies, eight views");
    verb->add_option("--out", arguments->out, "The dataset folder to create")->required();
    verb->add_flag("--realistic", arguments->realistic,
                   "As a real rig would give it (simulated): pictures, masks and clicks of another person's hands "
                   "before cameras that are not quite where the calibration has them; the truth is kept beside");
    verb->add_option("--level", arguments->level, "How far from perfect: casual or studio (casual)")
        ->check(CLI::IsMember({"casual", "studio"}));
    verb->add_option("--seed", arguments->seed, "Seed of everything that is drawn (1)");
    verb->callback([arguments, verb] { demo(*arguments, *verb); });
}

} // namespace app
