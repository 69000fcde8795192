// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "app/batch/verbs.h"
#include "core/annotation/reconstruction.h"
#include "core/error.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/dataset/dataset_rig.h"
#include "core/io/formats/annotation_formats.h"

namespace app {

namespace {

struct ExportArguments {
    std::string dataset, sequence, kind, map, rater, out;
    std::optional<double> sigmaPx;
};

std::string exportKinds() {
    std::string kinds;
    for (const core::AnnotationFormat& format : core::annotationFormats())
        if (format.canExport)
            kinds += (kinds.empty() ? "" : ", ") + std::string(format.kind);
    return kinds;
}

void exportSequence(const ExportArguments& arguments) {
    const core::Dataset dataset = core::readDataset(arguments.dataset);
    const core::Sequence& sequence = dataset.sequence(arguments.sequence);
    core::AnnotationExportOptions options;
    if (arguments.sigmaPx)
        options.triangulation.sigmaPx = *arguments.sigmaPx;
    else
        options.sigmas = core::datasetClickSigmas(dataset);
    options.jointMap = arguments.map;
    if (!arguments.rater.empty())
        options.rater = arguments.rater;
    const core::AnnotationSet set = core::readAnnotations(dataset, sequence);
    const std::string written = core::exportAnnotations(dataset, sequence, set, arguments.kind, arguments.out, options);
    std::printf("%s%s%s\n", arguments.out.c_str(), written.empty() ? "" : ": marks of ", written.c_str());
    const std::vector<std::string> raters = core::ratersOf(set);
    if (raters.empty())
        std::printf("note: there are no marks in sequence %s\n", sequence.name.c_str());
    for (const std::string& other : raters)
        if (!written.empty() && other != written && arguments.rater.empty() && !core::settledFrames(set, other).empty())
            std::printf("note: the marks of %s are left out: choose with --rater\n", other.c_str());
}

} // namespace

void addExportVerb(CLI::App& program) {
    auto arguments = std::make_shared<ExportArguments>();
    CLI::App* verb = program.add_subcommand("export", "Write the annotations of a sequence for other programs");
    verb->add_option("dataset", arguments->dataset, "Dataset folder")->required();
    verb->add_option("--sequence", arguments->sequence, "Name of the sequence")->required();
    verb->add_option("--to", arguments->kind, "Kind: " + exportKinds())->required();
    verb->add_option("--map", arguments->map, "JSON file with the joint of each name there");
    verb->add_option(
        "--rater", arguments->rater,
        "Only the marks of this rater (default: all raters where the format names them, else the one with most marks)");
    verb->add_option("--sigma-px", arguments->sigmaPx,
                     "Standard deviation of a click per axis, px (default: estimated from all clicks)")
        ->check(CLI::Range(1e-6, 1e6));
    verb->add_option("--out", arguments->out, "The file (or folder) to write")->required();
    verb->callback([arguments] { exportSequence(*arguments); });
}

} // namespace app
