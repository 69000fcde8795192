// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

namespace widgets {

/// What lies in the files and folders that a person dropped.
struct GatheredFootage {
    QStringList footage; ///< videos, and folders of images, in the order of their names
    QString calibration; ///< the first that is one; empty if none is
};

/// Looks at files by their endings and into folders, one level deep: a folder of images is footage, one of videos or of
/// such folders stands for all of them. A file that is neither a video nor an image is looked into: it may be the
/// calibration. Takes a while: for a job.
GatheredFootage gatherFootage(const QStringList& paths);

} // namespace widgets
