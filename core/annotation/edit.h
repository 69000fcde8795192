// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/annotation/edit_description.h"

namespace core {

/// One mark before and after; an absent value means that there is none.
struct MarkChange {
    MarkKey key;
    std::optional<Mark> before;
    std::optional<Mark> after;
    bool operator==(const MarkChange&) const = default;
};

/// The note of one frame before and after.
struct NoteChange {
    int frame = 0;
    std::string before;
    std::string after;
    bool operator==(const NoteChange&) const = default;
};

/// One invertible step of an annotator: everything that undo takes back at once.
struct Edit {
    EditDescription description;
    std::vector<MarkChange> marks;
    std::vector<NoteChange> notes;
    bool empty() const { return marks.empty() && notes.empty(); }
    bool operator==(const Edit&) const = default;
};

/// Applies an edit. Throws Error(BadInput) if `before` is not what the set holds or a key occurs twice; the set is then
/// unchanged.
void apply(AnnotationSet& set, const Edit& edit);
/// The edit that takes `edit` back; same description.
Edit inverse(const Edit& edit);
/// The edit that does `first`, then `second` (for one drag); changes that cancel are dropped.
/// Description of `first`, keys ascending. Throws Error(BadInput) if `second` does not start where `first` ends.
Edit merged(const Edit& first, const Edit& second);

} // namespace core
