// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace app {

class MainWindow;

/// True for an action of the table that does nothing without an open dataset.
bool needsDataset(const QString& actionId);
/// Switches the actions that need a dataset off until one is open; binds the one that makes a dataset, and what finds
/// footage that moved.
void bindDatasetActions(MainWindow& window);

} // namespace app
