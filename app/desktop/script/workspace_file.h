// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <QDir>
#include <QJsonObject>
#include <QStringList>

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

/// Goes to the sequence, fits the pair, and shows it as the workspace says. Returns when all of it is shown. Throws
/// core::Error naming the field that cannot be had in the open dataset.
void restoreWorkspace(MainWindow& window, const Workspace& workspace);

/// Saves every view (<method>_<camera>.png), all of them (compare.png) and both curves (error.png, cost.png). Equal
/// workspaces give equal files. Returns their names. Throws core::Error(Io).
QStringList saveWorkspacePictures(MainWindow& window, const QDir& folder);

/// Restores the workspace of a file and saves its pictures; what fails is said on stderr. Returns the exit status.
int renderWorkspace(MainWindow& window, const std::string& file, const std::string& outFolder);

/// Restores the workspace of a file in a window that a person looks at, once the dataset is open; what fails is shown.
void openWorkspace(MainWindow& window, const std::string& file);

} // namespace app
