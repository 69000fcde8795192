// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/interrupt.h"
#include "app/batch/verbs.h"
#include "core/error.h"
#include "core/io/dataset/relink.h"

namespace app {

namespace {

std::string whatOf(const core::RelinkFinding& finding) {
    const std::string masks = finding.camera.empty() ? "masks" : finding.camera + " (masks)";
    return finding.sequence + ", " + (finding.isMask ? masks : finding.camera);
}

void printFindings(const std::vector<core::RelinkFinding>& findings, const char* what) {
    for (const core::RelinkFinding& finding : findings) {
        const bool hasMoved = !finding.to.empty() && finding.to != finding.from;
        std::printf("%s: %s: %s%s\n", whatOf(finding).c_str(), what, finding.from.c_str(),
                    hasMoved ? (" -> " + finding.to).c_str() : "");
        if (const std::string note = core::relinkNoteText(finding); !note.empty())
            std::printf("note: %s: %s\n", whatOf(finding).c_str(), note.c_str());
    }
}

void relink(const std::string& folder, const std::string& root) {
    core::Dataset dataset = core::readDataset(folder);
    const core::RelinkResult result = core::relinkFootage(dataset, root, interruptToken());
    if (interruptToken().stop_requested())
        throw core::Error(core::ErrorCode::Io, folder, "", "stopped; nothing is changed");
    if (!result.found.empty())
        core::rewriteDatasetFile(dataset);
    printFindings(result.unchanged, "unchanged");
    printFindings(result.found, "found");
    printFindings(result.notFound, "not found");
    if (!result.notFound.empty()) {
        throw core::Error(core::ErrorCode::NotFound, folder, "footage",
                          std::to_string(result.notFound.size()) + " of " +
                              std::to_string(result.notFound.size() + result.found.size() + result.unchanged.size()) +
                              " not found below " + root);
    }
}

} // namespace

void addRelinkVerb(CLI::App& program) {
    auto dataset = std::make_shared<std::string>();
    auto root = std::make_shared<std::string>();
    CLI::App* verb = program.add_subcommand(
        "relink", "Find footage and masks that have moved, and write their new places into the dataset");
    verb->add_option("dataset", *dataset, "The dataset folder")->required();
    verb->add_option("--root", *root, "The folder to search, with all folders in it")->required();
    verb->callback([dataset, root] { relink(*dataset, *root); });
}

} // namespace app
