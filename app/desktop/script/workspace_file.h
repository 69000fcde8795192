// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
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
    std::string matches = "distance"; ///< id of MatchChoice
    std::vector<std::string> columns; ///< ids of columns, from left to right; empty: the methods
    std::vector<std::string> cameras; ///< of the rows; empty: `rows` of them from `camera` on
    struct Hidden {
        std::string column, camera;
    };
    std::vector<Hidden> hidden; ///< columns that are switched off in a camera
    struct Tracker {
        std::string name, file;
    };
    std::vector<Tracker> trackers; ///< whose estimates are columns
    /// What was tried under "What if" in the places of the columns.
    struct Trial {
        double outlineNoisePx = 0;                   ///< standard deviation by which outlines move across themselves
        int draw = 0;                                ///< of that noise: equal draws are equal noise
        std::vector<std::string> without;            ///< cameras that are left out
        std::map<std::string, std::string> settings; ///< the method that is tried, by column
    };
    std::optional<Trial> trial; ///< none: everything as it was fitted
};

/// Of the fit that is shown. Throws core::Error(Usage) if nothing was fitted.
Workspace currentWorkspace(MainWindow& window);

/// Throws core::Error(BadInput, Io) naming file and field.
Workspace readWorkspace(const std::filesystem::path& file);
void writeWorkspace(const std::filesystem::path& file, const Workspace& workspace);

} // namespace app
