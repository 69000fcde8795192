// SPDX-License-Identifier: MIT
#pragma once

#include <QJsonObject>

namespace widgets {
class CameraView;
}

namespace app {

class MainWindow;

// Steps about the columns of the Inspect workspace. Each throws core::Error(Usage) naming the field if it cannot be
// done.

/// {"show":["ch","start","dch-thres:tau=45"],"cameras":["cam0","cam3"],"trackers":[{"name","file"}]}, each if it is
/// there: exactly these columns from left to right, and these rows. Answers as print columns does.
QJsonObject chooseColumns(MainWindow& window, const QJsonObject& step);
/// {"columns":[{"id","errorMm"}],"cameras":[names],"matchBytes"}: the last is what the recorded matches take.
QJsonObject printColumns(MainWindow& window);
/// The view that a step's "column" (an id) and "camera" mean.
widgets::CameraView& inspectedView(MainWindow& window, const QJsonObject& step);
/// {"method":"ch","set":"tau","to":30}: drags an option of a column's method; "outlines" (px) is the silhouettes'
/// noise, {"camera":"cam0","on":false} a camera. Answers {"points":{method:[[x,errorMm]]}} once all has been fitted.
QJsonObject tryWhatIf(MainWindow& window, const QJsonObject& step);

} // namespace app
