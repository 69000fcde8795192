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
    std::string column; ///< id of the current one
    struct Meshes {
        std::string style = "shaded"; ///< or "wireframe", "off"
        double opacity = 1;           ///< 0..1
        bool left = true, right = true;
        bool start = false;     ///< the start pose is drawn
        bool silhouette = true; ///< the observed silhouette is
    };
    std::optional<Meshes> meshes; ///< how they are drawn; none: as in the window
    /// What is seen of a row that was zoomed or moved; other rows show the hands.
    struct Region {
        std::string camera;
        double x = 0, y = 0; ///< in the middle of its views, image px
        double widthPx = 0;  ///< of the image
    };
    std::vector<Region> regions;
    struct Probe {
        std::string column, camera;
        double x = 0, y = 0; ///< image px
    };
    std::optional<Probe> probe; ///< that is pinned
    struct Wipe {
        std::string kind = "wipe"; ///< or "blink"
        double place = 0.5;        ///< of the line, as a share of the views' width
    };
    std::optional<Wipe> wipe;   ///< of the current column with the one beside it
    std::optional<Trial> trial; ///< none: everything as it was fitted
};

/// Of the fit that is shown. Throws core::Error(Usage) if nothing was fitted.
Workspace currentWorkspace(MainWindow& window);

/// Throws core::Error(BadInput, Io) naming file and field.
Workspace readWorkspace(const std::filesystem::path& file);
void writeWorkspace(const std::filesystem::path& file, const Workspace& workspace);

} // namespace app
