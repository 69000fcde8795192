// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/annotation/click_sigmas.h"
#include "core/geometry/triangulation.h"
#include "core/io/formats/import_notes.h"

namespace core {

/// What an export is to hold.
struct AnnotationExportOptions {
    TriangulationOptions triangulation;
    /// What clicks are worth, per rater and camera; without them all count as triangulation.sigmaPx says.
    std::optional<ClickSigmas> sigmas{};
    std::optional<std::string>
        rater; ///< only this one; formats that name no raters take the one with most marks otherwise
    std::filesystem::path jointMap; ///< JSON that renames joints; empty = the format's own

    TriangulationOptions triangulationOf(const std::string& ofRater) const {
        return sigmas ? sigmas->optionsFor(ofRater, triangulation) : triangulation;
    }
};
/// How an import is to be read.
struct AnnotationImportOptions {
    std::string rater = "import";        ///< for formats that name no rater
    std::filesystem::path jointMap;      ///< JSON that renames joints; empty = the format's own
    std::string camera;                  ///< for formats of one view per file, if the file name does not tell
    bool raterForAll = false;            ///< `rater` gets the marks of those whom the file names, too
    std::optional<double> minLikelihood; ///< guesses below it are left out
    std::vector<std::string> videos;     ///< only labels of pictures of these videos, whatever the sequence is called;
                                         ///< empty: those of the sequence
};
/// What an import brought.
struct ImportedAnnotations {
    AnnotationSet set;
    std::vector<ImportNote> warnings;      ///< what was left out, and what is odd
    std::vector<std::string> unknownParts; ///< body parts of this sequence's labels that stand for no joint
    std::vector<std::string> otherVideos;  ///< whose labels were left out because they are not this sequence's
};

} // namespace core
