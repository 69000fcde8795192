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
#include "core/io/hands/rig_file.h"
#include "core/io/import/gltf_import.h"
#include "core/io/import/tzionas_import.h"

namespace app {

namespace {

struct TzionasArguments {
    core::TzionasImportOptions options;
    std::string size;
    std::string out;
};

void importTzionas(const TzionasArguments& arguments) {
    core::TzionasImportOptions options = arguments.options;
    if (!arguments.size.empty())
        options.imageSize = parseImageSize(arguments.size, "--size");
    core::ImportedDataset imported;
    {
        Progress progress("fitting poses");
        imported =
            core::importTzionas(options, interruptToken(), [&](int done, int total) { progress.show(done, total); });
    }
    imported.dataset.name = std::filesystem::path(arguments.out).filename().string();
    core::writeDataset(imported.dataset, imported.motions, arguments.out);
    std::printf("%s: %zu hands, %zu sequences, %zu cameras\n", arguments.out.c_str(), imported.dataset.hands.size(),
                imported.dataset.sequences.size(), imported.dataset.cameras.size());
    std::printf("recorded bone origins are reproduced within %.3f mm on average, %.3f mm at most\n",
                imported.meanErrorMm, imported.maxErrorMm);
}

void addTzionas(CLI::App& import) {
    auto arguments = std::make_shared<TzionasArguments>();
    CLI::App* verb =
        import.add_subcommand("tzionas", "Hands and motions of the method's authors (OFF, SKEL, SKIN, LIMITS, MOTION)");
    verb->add_option("--models", arguments->options.sequenceFolders, "Folder of a sequence; can be repeated")
        ->required();
    verb->add_option("--model-files", arguments->options.modelFiles, "Folder of the files that all sequences share");
    CLI::Option* cameras = verb->add_option("--cameras", arguments->options.camerasFile, "Cameras.txt");
    verb->add_option("--size", arguments->size, "Image size WxH of Cameras.txt")->needs(cameras);
    verb->add_option("--ring", arguments->options.ringCameras, "Number of cameras on a ring (8)")
        ->check(CLI::Range(1, 64))
        ->excludes(cameras);
    verb->add_option("--out", arguments->out, "The dataset folder to create")->required();
    verb->callback([arguments] { importTzionas(*arguments); });
}

struct GltfArguments {
    std::string left, right, rig, out;
};

void importGltf(const GltfArguments& arguments) {
    const core::Rig rig = arguments.rig.empty() ? core::defaultRig("webxr") : core::readRig(arguments.rig);
    core::NewDataset imported = core::importGltf(arguments.left, arguments.right, rig);
    imported.dataset.name = std::filesystem::path(arguments.out).filename().string();
    core::writeDataset(imported.dataset, imported.motions, arguments.out);
    for (const core::HandModel& hand : imported.dataset.hands) {
        std::printf("%s hand: %zu vertices, %zu triangles, %d degrees of freedom\n", core::sideName(hand.side).data(),
                    hand.mesh.vertices.size(), hand.mesh.triangles.size(), hand.skeleton.poseSize());
    }
    std::printf("%s: %zu sequences, %zu cameras\n", arguments.out.c_str(), imported.dataset.sequences.size(),
                imported.dataset.cameras.size());
}

void addGltf(CLI::App& import) {
    auto arguments = std::make_shared<GltfArguments>();
    CLI::App* verb = import.add_subcommand("gltf", "Two skinned hands from glTF files (.gltf, .glb)");
    verb->add_option("--left", arguments->left, "The left hand's file")->required();
    verb->add_option("--right", arguments->right, "The right hand's file; it may be the same")->required();
    verb->add_option("--rig", arguments->rig, "Rig file: joint names, axes and limits (default: WebXR hands)");
    verb->add_option("--out", arguments->out, "The dataset folder to create")->required();
    verb->callback([arguments] { importGltf(*arguments); });
}

} // namespace

void addImportVerb(CLI::App& program) {
    CLI::App* import = program.add_subcommand("import", "Make a dataset from other programs' files");
    import->require_subcommand(1);
    addTzionas(*import);
    addGltf(*import);
}

} // namespace app
