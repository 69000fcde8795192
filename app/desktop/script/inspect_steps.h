// SPDX-License-Identifier: MIT
#pragma once

#include <QJsonObject>
#include <QString>

namespace app {

class MainWindow;

// Steps about the fitted pair in the Inspect workspace. Each throws core::Error(Usage) naming the field if it cannot be
// done.

/// {"to":5}: shows the poses after that many iterations.
QJsonObject showIteration(MainWindow& window, const QJsonObject& step);
/// {"id":"matches","on":true}: draws a layer over the inspected views, or takes it away.
QJsonObject showLayer(MainWindow& window, const QJsonObject& step);
/// {"method":"ch","camera":"cam0"}: what the method matched there, at the iteration that is shown.
QJsonObject printMatches(MainWindow& window, const QJsonObject& step);
/// {"camera":"cam0","px":[x,y],"method":"dch-thres"}: what the method would match a rim point there with that has the
/// direction of the nearest rim point.
QJsonObject probeAt(MainWindow& window, const QJsonObject& step);

/// Writes the page about the comparison and its workspace file.
QJsonObject saveReport(MainWindow& window, const QString& path);
/// Writes the iterations as a film (.mp4, .avi).
QJsonObject saveFilm(MainWindow& window, const QString& path);
/// Writes the comparison as a figure (.png, .svg, .pdf).
QJsonObject saveComparison(MainWindow& window, const QString& path);

} // namespace app
