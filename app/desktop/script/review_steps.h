// SPDX-License-Identifier: MIT
#pragma once

#include <QJsonObject>

namespace app {

class MainWindow;

// Steps about the first pass and the review of what it proposed. Each throws core::Error if it cannot be done.

/// {"first":0,"last":590,"step":10}: labels these frames of the open sequence, all of it in steps of one where they are
/// left out; answers with the number of frames with hands and of proposed marks.
QJsonObject runFirstPass(MainWindow& window, const QJsonObject& step);
/// The frames that wait for a look, in their order.
QJsonObject printReview(MainWindow& window);

} // namespace app
