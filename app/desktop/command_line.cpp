// SPDX-License-Identifier: MIT
#include "app/desktop/command_line.h"

#include <filesystem>
#include <iostream>

#include <CLI/CLI.hpp>

namespace app {

namespace {

/// A file manager passes the file of a dataset that was double-clicked; the dataset is its folder.
std::string datasetFolder(const std::string& path) {
    const std::filesystem::path file(path);
    return file.filename() == "dataset.json" && std::filesystem::is_regular_file(file)
               ? std::filesystem::absolute(file).parent_path().string()
               : path;
}

} // namespace

ParsedCommandLine parseCommandLine(int argc, char** argv) {
    CommandLine line;
    CLI::App parser("Make and inspect 3D hand ground truth in calibrated multi-camera footage.", "handlens");
    parser.add_option("dataset", line.dataset, "Dataset to open: its folder, or its dataset.json");
    parser.add_option("--sequence", line.sequence, "Sequence to open (default: the first one)");
    parser.add_option("--frame", line.frame, "Frame to show, from 0")->check(CLI::NonNegativeNumber);
    parser.add_option("--language", line.language, "Language of the window: en, de, ... (default: the system's)");
    parser.add_option("--rater", line.rater, "Name under which marks are made");
    auto* offscreen =
        parser.add_flag("--offscreen", line.offscreen, "Run without a display (needs --script or --workspace)");
    auto* script = parser.add_option("--script", line.script, "File with one step (a JSON object) a line");
    auto* workspace = parser.add_option(
        "--workspace", line.workspace, "Workspace file to show; with --offscreen, its views and plots become pictures");
    auto* out = parser.add_option("--out", line.out, "Folder for what the script or the workspace writes");
    script->needs(offscreen)->needs(out)->excludes(workspace);
    parser.set_version_flag("--version", std::string("handlens ") + HANDLENS_VERSION);
    try {
        parser.parse(argc, argv);
        if (*offscreen && !*script && !*workspace)
            throw CLI::RequiresError("--offscreen", "--script or --workspace");
        if (*offscreen && !*out)
            throw CLI::RequiresError("--offscreen", "--out");
    } catch (const CLI::Success& request) {
        parser.exit(request);
        return {std::nullopt, 0};
    } catch (const CLI::ParseError& error) {
        std::cerr << "handlens: " << error.what() << '\n';
        return {std::nullopt, 2};
    }
    line.dataset = datasetFolder(line.dataset);
    return {line, 0};
}

} // namespace app
