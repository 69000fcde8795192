// SPDX-License-Identifier: MIT
#pragma once

#include <QDir>
#include <QJsonObject>

namespace app {

class MainWindow;

// Steps about results of a benchmark. Each throws core::Error(Usage) naming the field if it cannot be done.

/// {"open":"DIR"}: shows the results of a folder; answers what they hold.
QJsonObject openResults(MainWindow& window, const QDir& out, const QJsonObject& step);
/// {"filter":"A-B>1","a":"dch-dt3","b":"ch","sort":"A-B","ascending":false,"select":[0,1],"inspect":0}: what the table
/// of pairs shows, all fields optional; `select` and `inspect` are its rows from 0. Answers how many pairs are shown.
QJsonObject showPairs(MainWindow& window, const QJsonObject& step);
/// {"most":20}: the first rows of the table of pairs as they are shown, with the error of every method.
QJsonObject printPairs(MainWindow& window, const QJsonObject& step);

} // namespace app
