// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "app/batch/interrupt.h"
#include "app/batch/progress.h"
#include "app/batch/verbs.h"
#include "core/io/dataset/dataset_paths.h"
#include "core/io/formats/annotation_report.h"

namespace app {

namespace {

struct ReportArguments {
    std::string dataset, out;
    double badPx = 2;
    std::optional<double> sigmaPx;
};

void report(const ReportArguments& arguments) {
    const core::Dataset dataset = core::readDataset(arguments.dataset);
    const std::filesystem::path out = arguments.out.empty()
                                          ? core::pathInside(dataset.folder, "report.html", "report.html")
                                          : std::filesystem::path(arguments.out);
    core::AnnotationReportOptions options;
    options.badRmsPx = arguments.badPx;
    options.estimateSigmas = !arguments.sigmaPx;
    if (arguments.sigmaPx)
        options.quality.triangulation.sigmaPx = *arguments.sigmaPx;
    bool isWritten = false;
    {
        Progress progress("report");
        isWritten = core::writeAnnotationReport(dataset, out, options, interruptToken(),
                                                [&](int done, int total) { progress.show(done, total); });
    }
    if (!isWritten)
        throw Interrupted(out.string() + ": stopped; nothing was written");
    std::printf("%s\n", out.string().c_str());
}

} // namespace

void addReportVerb(CLI::App& program) {
    auto arguments = std::make_shared<ReportArguments>();
    CLI::App* verb = program.add_subcommand(
        "report", "Write a page on the annotations of a dataset: progress, raters, worst joints, findings, figures");
    verb->add_option("dataset", arguments->dataset, "The dataset folder")->required();
    verb->add_option("--bad-px", arguments->badPx, "Joints with a larger reprojection error count as bad, px")
        ->capture_default_str()
        ->check(CLI::Range(1e-6, 1e6));
    verb->add_option("--sigma-px", arguments->sigmaPx,
                     "Standard deviation of a click per axis, px (estimated from all clicks)")
        ->check(CLI::Range(1e-6, 1e6));
    verb->add_option("--out", arguments->out, "The HTML file to write (report.html in the dataset)");
    verb->callback([arguments] { report(*arguments); });
}

} // namespace app
