// SPDX-License-Identifier: MIT
#pragma once

#include <QLineEdit>
#include <QWidget>

namespace app {

enum class PathKind { FileOrFolder, Folder };

/// A field for a path with a button beside it that asks for one.
QWidget* withChooser(QLineEdit* field, const QString& title, PathKind kind, QWidget* parent);

} // namespace app
