// SPDX-License-Identifier: MIT
#include "widgets/document/edit_slices.h"

#include <utility>

namespace widgets {

core::Edit EditSlices::part() const {
    return {m_edit->description, {}, {}};
}

core::MarkChange EditSlices::directed(core::MarkChange change) const {
    if (m_direction == EditDirection::Back)
        std::swap(change.before, change.after);
    return change;
}

void EditSlices::addNotes(core::Edit& part) {
    if (std::exchange(m_notesCame, true))
        return;
    part.notes = m_edit->notes;
    if (m_direction == EditDirection::Back)
        for (core::NoteChange& change : part.notes)
            std::swap(change.before, change.after);
}

core::Edit EditSlices::next(std::size_t marks) {
    core::Edit slice = part();
    addNotes(slice);
    for (; m_at < m_edit->marks.size() && slice.marks.size() < marks; ++m_at)
        if (m_came.erase(m_edit->marks[m_at].key) == 0)
            slice.marks.push_back(directed(m_edit->marks[m_at]));
    return slice;
}

core::Edit EditSlices::ahead(const core::Edit& other) {
    core::Edit slice = part();
    std::set<core::MarkKey> wanted;
    for (const core::MarkChange& change : other.marks)
        wanted.insert(change.key);
    for (std::size_t i = m_at; i < m_edit->marks.size() && !wanted.empty(); ++i)
        if (wanted.erase(m_edit->marks[i].key) > 0 && m_came.insert(m_edit->marks[i].key).second)
            slice.marks.push_back(directed(m_edit->marks[i]));
    if (!other.notes.empty())
        addNotes(slice);
    return slice;
}

} // namespace widgets
