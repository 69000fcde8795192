// SPDX-License-Identifier: MIT
#include "widgets/jobs/footage_gatherer.h"

#include <QCollator>
#include <QDir>
#include <QDirIterator>
#include <QFileInfo>

#include "core/error.h"
#include "core/io/calibration/calibration.h"

namespace widgets {

namespace {

constexpr qint64 kMostCalibrationBytes = 50'000'000;

bool hasEnding(const QFileInfo& file, const char* endings) {
    return QString::fromLatin1(endings).split(QLatin1Char(' ')).contains(file.suffix().toLower());
}

bool isVideo(const QFileInfo& file) {
    return hasEnding(file, "mp4 mov m4v avi mkv webm ts mts m2ts mpg mpeg wmv mjpeg mjpg h264 h265 hevc 264 265 mxf");
}

bool isImage(const QFileInfo& file) {
    return hasEnding(file, "png jpg jpeg tif tiff bmp pgm ppm jp2 webp exr");
}

bool isCalibration(const QFileInfo& file) {
    const std::string path = file.absoluteFilePath().toStdString();
    if (!file.isFile() || file.size() > kMostCalibrationBytes || !core::mayBeCalibration(path))
        return false;
    try {
        core::sniffCalibration(path);
        return true;
    } catch (const core::Error&) {
        return false;
    }
}

bool holdsImages(const QString& folder) {
    QDirIterator files(folder, QDir::Files);
    for (int looked = 0; files.hasNext() && looked < 100; ++looked) {
        files.next();
        if (isImage(files.fileInfo()))
            return true;
    }
    return false;
}

void add(GatheredFootage& gathered, const QFileInfo& file, int depth) {
    if (file.isDir() && holdsImages(file.absoluteFilePath())) {
        gathered.footage << file.absoluteFilePath();
    } else if (file.isDir() && depth > 0) {
        QFileInfoList inside = QDir(file.absoluteFilePath()).entryInfoList(QDir::AllEntries | QDir::NoDotAndDotDot);
        QCollator order;
        order.setNumericMode(true);
        std::sort(inside.begin(), inside.end(), [&](const QFileInfo& a, const QFileInfo& b) {
            return order.compare(a.fileName(), b.fileName()) < 0;
        });
        for (const QFileInfo& one : inside)
            add(gathered, one, depth - 1);
    } else if (isVideo(file)) {
        gathered.footage << file.absoluteFilePath();
    } else if (gathered.calibration.isEmpty() && isCalibration(file)) {
        gathered.calibration = file.absoluteFilePath();
    }
}

} // namespace

GatheredFootage gatherFootage(const QStringList& paths) {
    constexpr int kDepth = 2; // a folder of folders of images
    GatheredFootage gathered;
    for (const QString& path : paths)
        add(gathered, QFileInfo(path), kDepth);
    return gathered;
}

} // namespace widgets
