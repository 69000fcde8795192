// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QImage>
#include <QString>

class QMenu;
class QWidget;

namespace widgets {

/// How a widget gives away what it shows.
struct PictureSource {
    std::function<QImage(double scale)> image;
    std::function<bool(const QString& path)> saveSvg;   ///< empty if the picture cannot be saved as vectors
    QString fileName;                                   ///< suggested, without suffix
    std::function<void(const QString& message)> failed; ///< told, in words, why a picture could not be saved
    std::function<bool(const QString& path)> savePdf{}; ///< empty if the picture cannot be saved as a page
};

/// Appends "Copy picture" and "Save picture..." to a menu. What was done is told to `parent`'s window, as a status tip.
void addPictureActions(QMenu& menu, QWidget* parent, const PictureSource& source);

/// Asks where to, then saves.
void askToSavePicture(QWidget* parent, const PictureSource& source);

/// Writes PNG, SVG or PDF by the path's suffix (none: PNG); beside it first, then renamed. False if that failed.
bool savePicture(const PictureSource& source, const QString& path);

} // namespace widgets
