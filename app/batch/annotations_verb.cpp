// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/verbs.h"
#include "core/annotation/import_edit.h"
#include "core/annotation/reconstruction.h"
#include "core/error.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/files/login_name.h"
#include "core/io/formats/annotation_formats.h"
#include "core/io/store/annotation_store.h"

namespace app {

namespace {

struct AnnotationsArguments {
    std::string dataset, sequence, kind, file, camera;
    core::AnnotationImportOptions options;
    std::string map;
    double minLikelihood = 0;
    bool replace = false, keep = false, add = false;

    std::optional<core::ImportMode> mode() const {
        return replace ? std::optional(core::ImportMode::Replace)
               : keep  ? std::optional(core::ImportMode::Keep)
               : add   ? std::optional(core::ImportMode::Add)
                       : std::nullopt;
    }
};

/// Mean distance between imported marks and what their own points reproject to: a wrong convention shows here at once.
void printCheck(const core::Dataset& dataset, const core::AnnotationSet& set) {
    double sum = 0;
    int joints = 0, without = 0;
    for (const int frame : core::annotatedFrames(set)) {
        for (const std::string& rater : core::ratersOf(set, frame)) {
            for (const auto& [id, joint] :
                 core::reconstructFrame(set, dataset.cameras, frame, rater, {{}, false, std::nullopt})) {
                if (joint.hasPoint() && !joint.isAccepted) {
                    sum += joint.result.point->rmsPx;
                    ++joints;
                } else if (joint.manualViews >= 2) {
                    ++without;
                }
            }
        }
    }
    if (joints > 0)
        std::printf("check: %d joints have a 3D point, mean reprojection error %.2f px\n", joints, sum / joints);
    if (without > 0) {
        std::printf("check: %d joints have two or more views that do not agree: are cameras and conventions right?\n",
                    without);
    }
}

/// Refuses a file from which nothing would be taken.
void requireSomething(const AnnotationsArguments& arguments, const core::ImportedAnnotations& imported) {
    if (!imported.set.marks.empty() || !imported.set.notes.empty())
        return;
    if (!imported.otherVideos.empty() && imported.unknownParts.empty()) {
        std::string names;
        for (const std::string& video : imported.otherVideos)
            names += (names.empty() ? "" : ", ") + video;
        throw core::Error(core::ErrorCode::BadInput, arguments.file, "",
                          "has labels of " + names + ", but none of sequence " + arguments.sequence +
                              ": if they belong there, say --video " + imported.otherVideos.front());
    }
    if (!imported.warnings.empty()) {
        throw core::Error(core::ErrorCode::BadInput, arguments.file, "",
                          "has nothing that fits the sequence: " + core::importNoteText(imported.warnings.front()));
    }
}

core::ImportMode requiredMode(const AnnotationsArguments& arguments, const core::ImportConflicts& conflicts) {
    if (!conflicts.empty() && !arguments.mode()) {
        throw core::Error(core::ErrorCode::BadInput, arguments.file, "",
                          "would replace " + core::conflictText(conflicts) + ": choose --replace or --keep" +
                              (conflicts.marks > 0 ? " (or another --rater)" : "") + "; nothing was imported");
    }
    return arguments.mode().value_or(core::ImportMode::Replace);
}

/// Marks of the file that are not in the sequence after the import: proposals give way to settled marks.
int leftOut(const core::AnnotationSet& imported, const core::AnnotationSet& after) {
    return static_cast<int>(std::count_if(
        imported.marks.begin(), imported.marks.end(),
        [&](const auto& entry) {
            const auto found = after.marks.find(entry.first);
            return found == after.marks.end() || found->second != entry.second;
        }));
}

void printResult(const core::ImportedAnnotations& imported, const core::Edit& edit,
                 const core::ImportConflicts& conflicts, core::ImportMode mode) {
    for (const core::ImportNote& warning : imported.warnings)
        std::printf("note: %s\n", core::importNoteText(warning).c_str());
    if (!conflicts.empty()) {
        std::printf("note: %s: %s\n", mode == core::ImportMode::Replace ? "replaced" : "kept",
                    core::conflictText(conflicts).c_str());
    }
    std::printf("%zu marks read, %zu changed\n", imported.set.marks.size(), edit.marks.size());
    if (!imported.set.notes.empty())
        std::printf("%zu notes read, %zu changed\n", imported.set.notes.size(), edit.notes.size());
}

void importFile(const AnnotationsArguments& arguments, core::AnnotationImportOptions options) {
    const core::Dataset dataset = core::readDataset(arguments.dataset);
    const core::Sequence& sequence = dataset.sequence(arguments.sequence);
    options.jointMap = arguments.map;
    options.camera = arguments.camera;
    const core::ImportedAnnotations imported =
        core::importAnnotations(dataset, sequence, arguments.kind, arguments.file, options);
    requireSomething(arguments, imported);
    const core::ImportConflicts conflicts =
        core::importConflicts(core::readAnnotations(dataset, sequence), imported.set);
    const core::ImportMode mode = requiredMode(arguments, conflicts);
    auto store = core::AnnotationStore::open(core::annotationFile(dataset, sequence));
    if (store.isReadOnly())
        throw core::Error(core::ErrorCode::Io, store.file().string(), "",
                          "is read-only: " + core::readOnlyText(store.readOnlyReason()));
    const std::string name = std::filesystem::path(arguments.file).filename().string();
    const core::Edit edit = core::importEdit(store.annotations(), imported.set, name, mode);
    store.commit(edit, options.rater);
    printResult(imported, edit, conflicts, mode);
    const int out = leftOut(imported.set, store.annotations());
    if (out > 0 && conflicts.empty())
        std::printf("note: %d of them left out: settled marks of the same rater stand there\n", out);
    printCheck(dataset, imported.set);
}

std::string kindList() {
    std::string kinds;
    for (const core::AnnotationFormat& format : core::annotationFormats())
        if (format.canImport)
            kinds += (kinds.empty() ? "" : ", ") + std::string(format.kind);
    return kinds;
}

/// What happens to joints that the same rater has marked already.
void addModeOptions(CLI::App& verb, AnnotationsArguments& arguments) {
    CLI::Option* replace =
        verb.add_flag("--replace", arguments.replace,
                      "Joints that the same rater has marked otherwise are replaced as a whole, notes too");
    CLI::Option* keep = verb.add_flag("--keep", arguments.keep,
                                      "Joints that the same rater has marked otherwise stay as they are, notes too");
    CLI::Option* add =
        verb.add_flag("--add", arguments.add,
                      "Only views that the rater has not marked get marks: for one file per view after another");
    replace->excludes(keep)->excludes(add);
    keep->excludes(add);
}

} // namespace

void addAnnotationsVerb(CLI::App& program) {
    auto arguments = std::make_shared<AnnotationsArguments>();
    arguments->options.rater = core::loginName();
    CLI::App* verb = program.add_subcommand(
        "annotations", "Import annotations of another program into a sequence, as one step of its history");
    verb->add_option("dataset", arguments->dataset, "Dataset folder")->required();
    verb->add_option("--sequence", arguments->sequence, "Name of the sequence")->required();
    verb->add_option("--from", arguments->kind, "Kind: " + kindList())->required();
    verb->add_option("file", arguments->file, "The file (or folder) to read")->required();
    verb->add_option("--map", arguments->map, "JSON file with the joint of each name there");
    CLI::Option* rater = verb->add_option("--rater", arguments->options.rater,
                                          "Rater of the marks (default: the file's, else your login name)")
                             ->check([](const std::string& name) {
                                 return name.empty() ? std::string("must not be empty") : std::string();
                             });
    verb->add_option("--camera", arguments->camera, "Which camera they are for, for kinds with one view per file");
    verb->add_option("--video", arguments->options.videos,
                     "Take the labels of this video (or sequence) though it is called otherwise; may be repeated")
        ->allow_extra_args(false);
    CLI::Option* least = verb->add_option("--min-likelihood", arguments->minLikelihood,
                                          "Leave out guesses of a program that are less likely");
    addModeOptions(*verb, *arguments);
    verb->callback([arguments, rater, least] {
        core::AnnotationImportOptions options = arguments->options;
        options.raterForAll = rater->count() > 0;
        if (least->count() > 0)
            options.minLikelihood = arguments->minLikelihood;
        importFile(*arguments, options);
    });
}

} // namespace app
