// SPDX-License-Identifier: MIT
#include "core/io/annotation_formats.h"

#include <algorithm>
#include <map>

#include "core/error.h"
#include "core/io/ground_truth_file.h"

namespace core {

namespace fs = std::filesystem;

const std::vector<AnnotationFormat>& annotationFormats() {
    static const std::vector<AnnotationFormat> formats{
        {"handlens", "Handlens ground truth (JSON)", true, false},
    };
    return formats;
}

namespace {

const AnnotationFormat& formatOf(std::string_view kind) {
    const auto& formats = annotationFormats();
    const auto found = std::find_if(formats.begin(), formats.end(), [kind](const AnnotationFormat& format) { return format.kind == kind; });
    if (found == formats.end()) {
        std::string known;
        for (const AnnotationFormat& format : formats) {
            known += (known.empty() ? "" : ", ") + std::string(format.kind);
        }
        throw Error(ErrorCode::Usage, "", std::string(kind), "is no kind of annotations; known are " + known);
    }
    return *found;
}

} // namespace

void exportAnnotations(const Dataset& dataset, const Sequence& sequence, const AnnotationSet& set, std::string_view kind,
                       const fs::path& path, const AnnotationExportOptions& options) {
    formatOf(kind);
    if (options.rater) {
        const auto raters = ratersOf(set);
        if (std::find(raters.begin(), raters.end(), *options.rater) == raters.end()) {
            throw Error(ErrorCode::NotFound, sequence.annotations, "rater", "\"" + *options.rater + "\" has made no marks");
        }
    }
    writeGroundTruth(path, dataset, sequence, set, options);
}

ImportedAnnotations importAnnotations(const Dataset& dataset, const Sequence& sequence, std::string_view kind, const fs::path& path,
                                      const AnnotationImportOptions&) {
    if (!formatOf(kind).canImport) {
        throw Error(ErrorCode::Unsupported, "", std::string(kind), "can be written, not read");
    }
    return readGroundTruth(path, dataset, sequence);
}

} // namespace core
