// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <QDir>
#include <QStringList>

#include "app/desktop/script/workspace_file.h"

namespace app {

/// Goes to the sequence, fits the pair, and shows it as the workspace says. Returns when all of it is shown. Throws
/// core::Error naming the field that cannot be had in the open dataset.
void restoreWorkspace(MainWindow& window, const Workspace& workspace);

/// Saves every view (<method>_<camera>.png), all of them (compare.png) and both curves (error.png, cost.png). Equal
/// workspaces give equal files. Returns their names. Throws core::Error(Io).
QStringList saveWorkspacePictures(MainWindow& window, const QDir& folder);

/// Restores the workspace of a file and saves its pictures and its report (report.html); what fails is said on stderr.
/// Returns the exit status.
int renderWorkspace(MainWindow& window, const std::string& file, const std::string& outFolder);

/// Restores the workspace of a file in a window that a person looks at, once the dataset is open; what fails is shown.
void openWorkspace(MainWindow& window, const std::string& file);

} // namespace app
