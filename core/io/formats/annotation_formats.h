// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/dataset/dataset.h"
#include "core/io/formats/annotation_exchange.h"

namespace core {

/// A kind of annotation file, by the name that the command line uses.
struct AnnotationFormat {
    std::string_view kind;        ///< such as "handlens"
    std::string_view description; ///< English, for lists
    bool canImport = false;
    bool isFolder = false;    ///< the export is a folder with one file per view or frame
    bool namesRaters = false; ///< it holds the annotations of all raters, with their names
    bool canExport = true;
};
/// All formats: handlens, tzionas, coco, anipose2d, anipose3d, deeplabcut, sleap, label3d, trc, interhand, freihand,
/// csv, csv-marks.
const std::vector<AnnotationFormat>& annotationFormats();
/// The format of that kind. Throws Error(Usage), naming those that there are, for another.
const AnnotationFormat& annotationFormat(std::string_view kind);

/// Writes the annotations of one sequence: beside `path`, then renamed; never half a file. Returns whose they are, ""
/// for those of all raters. Throws Error(Usage) for an unknown kind,
/// Error(Unsupported) for one that can only be read, Error(Io) if it cannot be written.
std::string exportAnnotations(const Dataset& dataset, const Sequence& sequence, const AnnotationSet& set,
                              std::string_view kind, const std::filesystem::path& path,
                              const AnnotationExportOptions& options = {});

/// Reads annotations of another program. Cameras are matched by name. What a program guessed (it says how likely it is)
/// comes as proposals, what a person labelled as manual marks. Throws Error(BadInput) naming file and field; also if
/// two raters of the file would become one and have marked the same joint.
ImportedAnnotations importAnnotations(const Dataset& dataset, const Sequence& sequence, std::string_view kind,
                                      const std::filesystem::path& path, const AnnotationImportOptions& options = {});

} // namespace core
