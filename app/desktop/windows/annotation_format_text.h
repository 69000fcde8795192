// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include <QString>

#include "core/io/formats/annotation_formats.h"

namespace app {

/// What people are told of a kind of annotation file, in their language.
struct AnnotationFormatText {
    QString name;
    QString holds;  ///< one sentence: what a file of this kind contains
    QString readBy; ///< the programs that read it
    QString lost;   ///< what the annotations have and the file has not
    QString suffix; ///< of the files that are written; empty for folders
};
/// Throws std::out_of_range for a kind that core does not have.
AnnotationFormatText annotationFormatText(std::string_view kind);

/// A filter of a file dialog, such as "COCO keypoints (*.json)"; folders have none.
QString fileFilter(const core::AnnotationFormat& format);

} // namespace app
