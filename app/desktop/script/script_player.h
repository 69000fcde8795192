// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>

#include <QString>

namespace app {

class MainWindow;

/// Plays a script in a window: one JSON object a line; empty lines are skipped. Every step is answered with one JSON
/// line on `answers`; the first step that cannot be done ends the run, with one line on `errors` too. Returns the exit
/// status.
int playScript(MainWindow& window, const QString& script, const QString& outFolder, std::ostream& answers,
               std::ostream& errors);

} // namespace app
