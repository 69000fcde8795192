// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "app/batch/interrupt.h"
#include "app/batch/option_text.h"
#include "app/batch/progress.h"
#include "app/batch/verbs.h"
#include "core/error.h"
#include "core/io/tzionas_import.h"

namespace app {

namespace {

struct TzionasArguments {
    core::TzionasImportOptions options;
    std::string size;
    std::string out;
};

void importTzionas(const TzionasArguments& arguments) {
    core::TzionasImportOptions options = arguments.options;
    if (!arguments.size.empty()) {
        options.imageSize = parseImageSize(arguments.size, "--size");
    }
    core::ImportedDataset imported;
    {
        Progress progress("fitting poses");
        imported = core::importTzionas(options, interruptToken(), [&](int done, int total) { progress.show(done, total); });
    }
    imported.dataset.name = std::filesystem::path(arguments.out).filename().string();
    core::writeDataset(imported.dataset, imported.motions, arguments.out);
    std::printf("%s: %zu hands, %zu sequences, %zu cameras\n", arguments.out.c_str(), imported.dataset.hands.size(),
                imported.dataset.sequences.size(), imported.dataset.cameras.size());
    std::printf("recorded bone origins are reproduced within %.3f mm on average, %.3f mm at most\n", imported.meanErrorMm, imported.maxErrorMm);
}

void addTzionas(CLI::App& import) {
    auto arguments = std::make_shared<TzionasArguments>();
    CLI::App* verb = import.add_subcommand("tzionas", "Hands and motions of the method's authors (OFF, SKEL, SKIN, LIMITS, MOTION)");
    verb->add_option("--models", arguments->options.sequenceFolders, "Folder of a sequence; can be repeated")->required();
    verb->add_option("--model-files", arguments->options.modelFiles, "Folder of the files that all sequences share");
    CLI::Option* cameras = verb->add_option("--cameras", arguments->options.camerasFile, "Cameras.txt");
    verb->add_option("--size", arguments->size, "Image size WxH of Cameras.txt")->needs(cameras);
    verb->add_option("--ring", arguments->options.ringCameras, "Number of cameras on a ring (8)")->check(CLI::Range(1, 64))->excludes(cameras);
    verb->add_option("--out", arguments->out, "The dataset folder to create")->required();
    verb->callback([arguments] { importTzionas(*arguments); });
}

} // namespace

void addImportVerb(CLI::App& program) {
    CLI::App* import = program.add_subcommand("import", "Make a dataset from other programs' files");
    import->require_subcommand(1);
    addTzionas(*import);
}

} // namespace app
