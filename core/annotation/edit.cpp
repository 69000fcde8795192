// SPDX-License-Identifier: MIT
#include "core/annotation/edit.h"

#include <map>
#include <set>

#include "core/error.h"

namespace core {

namespace {

[[noreturn]] void refuse(const Edit& edit, const std::string& where) {
    throw Error(ErrorCode::BadInput, "", "edit \"" + editLabel(edit.description) + "\"",
                where + " is not in the state that the edit starts from");
}

std::string placeName(const MarkKey& key) {
    return jointLabel(key.joint) + " in " + key.camera + ", frame " + std::to_string(key.frame) + ", rater " +
           key.rater;
}

void check(const AnnotationSet& set, const Edit& edit) {
    std::set<MarkKey> keys;
    for (const MarkChange& change : edit.marks)
        if (!keys.insert(change.key).second || markAt(set, change.key) != change.before)
            refuse(edit, placeName(change.key));
    std::set<int> frames;
    for (const NoteChange& change : edit.notes)
        if (!frames.insert(change.frame).second || noteAt(set, change.frame) != change.before)
            refuse(edit, "the note of frame " + std::to_string(change.frame));
}

} // namespace

void apply(AnnotationSet& set, const Edit& edit) {
    check(set, edit);
    for (const MarkChange& change : edit.marks)
        if (change.after)
            set.marks.insert_or_assign(change.key, *change.after);
        else
            set.marks.erase(change.key);
    for (const NoteChange& change : edit.notes)
        if (change.after.empty())
            set.notes.erase(change.frame);
        else
            set.notes[change.frame] = change.after;
}

Edit inverse(const Edit& edit) {
    Edit back = edit;
    for (MarkChange& change : back.marks)
        std::swap(change.before, change.after);
    for (NoteChange& change : back.notes)
        std::swap(change.before, change.after);
    return back;
}

namespace {

/// Joins changes of the same key; Key and Change as in Edit.
template <typename Key, typename Change>
std::vector<Change> joined(const std::vector<Change>& first, const std::vector<Change>& second, Key Change::*key,
                           const Edit& edit) {
    std::map<Key, Change> changes;
    for (const Change& change : first)
        changes.emplace(change.*key, change);
    for (const Change& change : second) {
        const auto [place, isNew] = changes.emplace(change.*key, change);
        if (!isNew) {
            if (!(place->second.after == change.before))
                refuse(edit, "a joined edit");
            place->second.after = change.after;
        }
    }
    std::vector<Change> result;
    for (const auto& [unused, change] : changes)
        if (!(change.before == change.after))
            result.push_back(change);
    return result;
}

} // namespace

Edit merged(const Edit& first, const Edit& second) {
    return {first.description, joined(first.marks, second.marks, &MarkChange::key, second),
            joined(first.notes, second.notes, &NoteChange::frame, second)};
}

} // namespace core
