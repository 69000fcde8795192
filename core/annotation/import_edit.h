// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>

#include "core/annotation/edit.h"

namespace core {

/// What an import does with a joint that the same rater has marked already in that frame, differently. Always with the
/// joint as a whole, so that the marks of two people never end up in one joint.
enum class ImportMode {
    Replace, ///< the joint's marks of that rater make way for the imported ones; notes, too
    Keep,    ///< the joint is left as it is; notes, too
    Add      ///< only views that the rater has not settled get marks: for files of one view each
};

/// What is in the way of an import.
struct ImportConflicts {
    int marks = 0;                ///< settled marks that Replace would change or take away
    int notes = 0;                ///< notes with another text
    std::set<std::string> raters; ///< whose marks these are
    std::set<int> frames;         ///< in which these marks and notes are

    bool empty() const { return marks == 0 && notes == 0; }
};
ImportConflicts importConflicts(const AnnotationSet& set, const AnnotationSet& imported);
/// "12 marks of anna and 1 note in 3 frames"; English.
std::string conflictText(const ImportConflicts& conflicts);

/// Writes the marks and notes of `imported` into the set. A proposal never displaces a settled mark; settled marks
/// displace proposals. An empty edit if nothing would change. `source` is the name of the file, for the description.
Edit importEdit(const AnnotationSet& set, const AnnotationSet& imported, const std::string& source,
                ImportMode mode = ImportMode::Replace);

} // namespace core
