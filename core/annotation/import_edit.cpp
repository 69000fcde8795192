// SPDX-License-Identifier: MIT
#include "core/annotation/import_edit.h"

#include <algorithm>

namespace core {

namespace {

bool hasSettled(const MarkRange& marks) {
    return std::any_of(
        marks.begin(), marks.end(), [](const auto& item) { return item.second.isSettled(); });
}

/// One rater's marks of one joint in one frame: what is there and what comes.
struct JointImport {
    MarkRange before;
    MarkRange after;

    /// Settled marks that would be changed or taken away if the imported ones took the joint over.
    int replaced(const AnnotationSet& imported) const {
        if (!hasSettled(after))
            return 0;
        return static_cast<int>(std::count_if(before.begin(), before.end(), [&](const auto& item) {
            return item.second.isSettled() && markAt(imported, item.first) != item.second;
        }));
    }
};

/// Calls `visit` with every joint of the import.
template <typename Visit>
void forEachJoint(const AnnotationSet& set, const AnnotationSet& imported, Visit&& visit) {
    for (auto mark = imported.marks.begin(); mark != imported.marks.end();) {
        const MarkKey& key = mark->first;
        const JointImport joint{marksOfJoint(set, key.frame, key.rater, key.joint),
                                marksOfJoint(imported, key.frame, key.rater, key.joint)};
        visit(joint);
        mark = joint.after.last;
    }
}

void change(Edit& edit, const MarkKey& key, const std::optional<Mark>& before, const std::optional<Mark>& after) {
    if (before != after)
        edit.marks.push_back({key, before, after});
}

/// Takes the joint over as a whole.
void replaceJoint(Edit& edit, const AnnotationSet& set, const AnnotationSet& imported, const JointImport& joint) {
    for (const auto& [key, mark] : joint.before)
        if (!markAt(imported, key))
            change(edit, key, mark, std::nullopt);
    for (const auto& [key, mark] : joint.after)
        change(edit, key, markAt(set, key), mark);
}

/// Marks only views in which nothing is settled.
void addViews(Edit& edit, const AnnotationSet& set, const JointImport& joint) {
    for (const auto& [key, mark] : joint.after) {
        const auto before = markAt(set, key);
        if (!before || !before->isSettled())
            change(edit, key, before, mark);
    }
}

bool isNoteInTheWay(const AnnotationSet& set, int frame, const std::string& text) {
    const std::string before = noteAt(set, frame);
    return !before.empty() && before != text;
}

std::string counted(int count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

} // namespace

ImportConflicts importConflicts(const AnnotationSet& set, const AnnotationSet& imported) {
    ImportConflicts conflicts;
    forEachJoint(set, imported, [&](const JointImport& joint) {
        if (const int replaced = joint.replaced(imported); replaced > 0) {
            conflicts.marks += replaced;
            conflicts.raters.insert(joint.after.first->first.rater);
            conflicts.frames.insert(joint.after.first->first.frame);
        }
    });
    for (const auto& [frame, text] : imported.notes) {
        if (isNoteInTheWay(set, frame, text)) {
            ++conflicts.notes;
            conflicts.frames.insert(frame);
        }
    }
    return conflicts;
}

std::string conflictText(const ImportConflicts& conflicts) {
    std::string text;
    if (conflicts.marks > 0) {
        text = counted(conflicts.marks, "mark") + " of ";
        for (const std::string& rater : conflicts.raters)
            text += (rater == *conflicts.raters.begin() ? "" : " and ") + rater;
    }
    if (conflicts.notes > 0)
        text += (text.empty() ? "" : " and ") + counted(conflicts.notes, "note");
    return text + " in " + counted(static_cast<int>(conflicts.frames.size()), "frame");
}

Edit importEdit(const AnnotationSet& set, const AnnotationSet& imported, const std::string& source, ImportMode mode) {
    Edit edit{{.kind = EditKind::Import, .text = source}, {}, {}};
    forEachJoint(set, imported, [&](const JointImport& joint) {
        const bool isInTheWay = joint.replaced(imported) > 0;
        if (!isInTheWay || mode == ImportMode::Add)
            addViews(edit, set, joint);
        else if (mode == ImportMode::Replace)
            replaceJoint(edit, set, imported, joint);
    });
    for (const auto& [frame, text] : imported.notes)
        if ((mode == ImportMode::Replace || !isNoteInTheWay(set, frame, text)) && noteAt(set, frame) != text)
            edit.notes.push_back({frame, noteAt(set, frame), text});
    return edit;
}

} // namespace core
