// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace app {

class MainWindow;

/// The compared pair as one HTML page that needs no network: what was compared, errors of every method, the pictures of
/// every method in every view that is shown, the curves, the errors joint by joint, the methods' settings, and the
/// command that makes the page again from the workspace file of that name and content. The same for the same
/// comparison: what took how long stays out. Throws core::Error(Usage) if nothing was fitted.
std::string comparisonReportHtml(MainWindow& window, const std::string& workspaceFile,
                                 const std::string& workspaceText);

/// Writes the page, and the workspace file beside it (the page's name, ending in .json). Throws core::Error(Usage, Io).
void saveComparisonReport(MainWindow& window, const std::filesystem::path& page);

} // namespace app
