// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace app {

class MainWindow;

/// What the Inspect workspace shows, as a file that people share: small JSON (format "handlens-workspace").
struct Workspace {
    std::string sequence;
    int start = 0;
    int test = 0;
    std::string target; ///< "recorded" or "masks"
    std::vector<std::string> methods;
    int iteration = 0;
    std::string camera; ///< of the first row; empty: the current one
    int rows = 2;
    std::vector<std::string> layers; ///< ids of InspectLayer
    double fieldDirectionDeg = 0;
};

/// Of the fit that is shown. Throws core::Error(Usage) if nothing was fitted.
Workspace currentWorkspace(MainWindow& window);

/// Throws core::Error(BadInput, Io) naming file and field.
Workspace readWorkspace(const std::filesystem::path& file);
void writeWorkspace(const std::filesystem::path& file, const Workspace& workspace);

} // namespace app
