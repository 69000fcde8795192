// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/verbs.h"
#include "core/annotation/edits.h"
#include "core/error.h"
#include "core/io/annotation_formats.h"
#include "core/io/annotation_store.h"
#include "core/io/dataset_annotations.h"

namespace app {

namespace {

struct AnnotationsArguments {
    std::string dataset, sequence, kind, file, camera;
    core::AnnotationImportOptions options;
    std::string map;
};

/// Mean distance between imported marks and what their own points reproject to: a wrong convention shows here at once.
void printCheck(const core::Dataset& dataset, const core::AnnotationSet& set) {
    double sum = 0;
    int joints = 0, without = 0;
    for (const int frame : core::annotatedFrames(set)) {
        for (const std::string& rater : core::ratersOf(set, frame)) {
            for (const auto& [id, joint] : core::reconstructFrame(set, dataset.cameras, frame, rater, {{}, false, std::nullopt})) {
                if (joint.hasPoint()) {
                    sum += joint.result.point->rmsPx;
                    ++joints;
                } else if (joint.manualViews >= 2) {
                    ++without;
                }
            }
        }
    }
    if (joints > 0) {
        std::printf("check: %d joints have a 3D point, mean reprojection error %.2f px\n", joints, sum / joints);
    }
    if (without > 0) {
        std::printf("check: %d joints have two or more views that do not agree: are cameras and conventions right?\n", without);
    }
}

void importFile(const AnnotationsArguments& arguments) {
    const core::Dataset dataset = core::readDataset(arguments.dataset);
    const core::Sequence& sequence = dataset.sequence(arguments.sequence);
    core::AnnotationImportOptions options = arguments.options;
    options.jointMap = arguments.map;
    options.camera = arguments.camera;
    const core::ImportedAnnotations imported = core::importAnnotations(dataset, sequence, arguments.kind, arguments.file, options);
    if (imported.set.marks.empty() && !imported.warnings.empty()) {
        throw core::Error(core::ErrorCode::BadInput, arguments.file, "", "holds nothing that fits the sequence: " + imported.warnings.front());
    }
    auto store = core::AnnotationStore::open(core::annotationFile(dataset, sequence));
    if (store.isReadOnly()) {
        throw core::Error(core::ErrorCode::Io, store.file().string(), "", "is read-only: " + store.readOnlyReason());
    }
    const std::string name = std::filesystem::path(arguments.file).filename().string();
    const core::Edit edit = core::importEdit(store.annotations(), imported.set, "import " + name);
    store.commit(edit, options.rater);
    for (const std::string& warning : imported.warnings) {
        std::printf("%s\n", warning.c_str());
    }
    std::printf("%zu marks read, %zu changed\n", imported.set.marks.size(), edit.marks.size());
    printCheck(dataset, imported.set);
}

std::string kindList() {
    std::string kinds;
    for (const core::AnnotationFormat& format : core::annotationFormats()) {
        if (format.canImport) {
            kinds += (kinds.empty() ? "" : ", ") + std::string(format.kind);
        }
    }
    return kinds;
}

} // namespace

void addAnnotationsVerb(CLI::App& program) {
    auto arguments = std::make_shared<AnnotationsArguments>();
    CLI::App* verb = program.add_subcommand("annotations", "Import annotations of another program into a sequence, as one step of its history");
    verb->add_option("dataset", arguments->dataset, "Dataset folder")->required();
    verb->add_option("--sequence", arguments->sequence, "Name of the sequence")->required();
    verb->add_option("--from", arguments->kind, "Kind: " + kindList())->required();
    verb->add_option("file", arguments->file, "The file (or folder) to read")->required();
    verb->add_option("--map", arguments->map, "JSON file that says which joint has which name there");
    verb->add_option("--rater", arguments->options.rater, "Whose marks they are, for kinds that do not say")->capture_default_str();
    verb->add_option("--camera", arguments->camera, "Which camera they are for, for kinds with one view per file");
    verb->callback([arguments] { importFile(*arguments); });
}

} // namespace app
