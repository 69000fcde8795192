// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <QString>

namespace app {

class MainWindow;

/// A filter of a file dialog, and the ending that a name without one gets; empty for folders.
struct FileKind {
    QString filter, suffix;
};

/// Shows a file dialog that does not block, to save a file if a name is proposed; `chosen` gets the path and which of
/// the kinds it is.
void askForFile(MainWindow& window, const QString& title, const std::vector<FileKind>& kinds,
                const QString& proposedName, const std::function<void(const QString& path, std::size_t kind)>& chosen);

} // namespace app
