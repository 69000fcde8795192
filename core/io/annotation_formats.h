// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/annotation/reconstruction.h"
#include "core/io/dataset.h"

namespace core {

/// A kind of annotation file, by the name that the command line uses.
struct AnnotationFormat {
    std::string_view kind;        ///< such as "handlens"
    std::string_view description; ///< English, for lists
    bool canImport = false;
    bool isFolder = false;        ///< the export is a folder with one file per view or frame
    bool namesRaters = false;     ///< it holds everybody's annotations, with their names
};
/// All formats: handlens, tzionas, coco, anipose2d, anipose3d, deeplabcut, trc, interhand, freihand, csv, csv-marks.
const std::vector<AnnotationFormat>& annotationFormats();
/// The format of that kind. Throws Error(Usage), naming those that there are, for another.
const AnnotationFormat& annotationFormat(std::string_view kind);

struct AnnotationExportOptions {
    TriangulationOptions triangulation;
    std::optional<std::string> rater; ///< only this one; formats that name no raters take the one with most marks otherwise
    std::filesystem::path jointMap;   ///< JSON that renames joints; empty = the format's own
};
/// Writes the annotations of one sequence: beside `path`, then renamed; never half a file. Returns whose they are, "" for
/// everybody's. Throws Error(Usage) for an unknown kind, Error(Io) if it cannot be written.
std::string exportAnnotations(const Dataset& dataset, const Sequence& sequence, const AnnotationSet& set, std::string_view kind,
                              const std::filesystem::path& path, const AnnotationExportOptions& options = {});

struct AnnotationImportOptions {
    std::string rater = "import";   ///< for formats that name no rater
    std::filesystem::path jointMap; ///< JSON that renames joints; empty = the format's own
    std::string camera;             ///< for formats of one view per file, if the file name does not tell
};
struct ImportedAnnotations {
    AnnotationSet set;
    std::vector<std::string> warnings; ///< what was left out, for people
};
/// Reads annotations of another program. Cameras are matched by name. Throws Error(BadInput) naming file and field.
ImportedAnnotations importAnnotations(const Dataset& dataset, const Sequence& sequence, std::string_view kind,
                                      const std::filesystem::path& path, const AnnotationImportOptions& options = {});

} // namespace core
