// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/verbs.h"
#include "core/error.h"
#include "core/io/dataset/dataset_check.h"

namespace app {

namespace {

void check(const std::string& path) {
    const std::vector<core::CheckFinding> findings = core::checkPath(path);
    for (const core::CheckFinding& finding : findings)
        std::printf("%s%s\n", finding.isNote ? "note: " : "", finding.text.c_str());
    const auto problems = std::count_if(findings.begin(), findings.end(),
                                        [](const core::CheckFinding& finding) { return !finding.isNote; });
    if (problems > 0) {
        throw core::Error(core::ErrorCode::BadInput, path, "",
                          std::to_string(problems) + (problems == 1 ? " problem" : " problems"));
    }
    std::printf("%s: no problems\n", path.c_str());
}

} // namespace

void addCheckVerb(CLI::App& program) {
    auto path = std::make_shared<std::string>();
    CLI::App* verb = program.add_subcommand(
        "check", "List every problem of a dataset or of one file; exit status 1 if there is any");
    verb->add_option("path", *path, "A dataset folder or a file")->required();
    verb->callback([path] { check(*path); });
}

} // namespace app
