// SPDX-License-Identifier: MIT
#include "widgets/document/edit_slices.h"

#include <utility>

namespace widgets {

core::Edit EditSlices::part() const {
    return {m_edit->description, {}, {}};
}

core::Edit EditSlices::directed(core::Edit slice) const {
    return m_direction == EditDirection::Back ? core::inverse(slice) : slice;
}

void EditSlices::addNotes(core::Edit& part) {
    if (!std::exchange(m_notesCame, true))
        part.notes = m_edit->notes;
}

core::Edit EditSlices::next(std::size_t marks) {
    core::Edit slice = part();
    addNotes(slice);
    for (; m_at < m_edit->marks.size() && slice.marks.size() < marks; ++m_at)
        if (m_came.erase(m_edit->marks[m_at].key) == 0)
            slice.marks.push_back(m_edit->marks[m_at]);
    return directed(std::move(slice));
}

core::Edit EditSlices::ahead(const core::Edit& other) {
    core::Edit slice = part();
    std::set<core::MarkKey> wanted;
    for (const core::MarkChange& change : other.marks)
        wanted.insert(change.key);
    for (std::size_t i = m_at; i < m_edit->marks.size() && !wanted.empty(); ++i)
        if (wanted.erase(m_edit->marks[i].key) > 0 && m_came.insert(m_edit->marks[i].key).second)
            slice.marks.push_back(m_edit->marks[i]);
    if (!other.notes.empty())
        addNotes(slice);
    return directed(std::move(slice));
}

} // namespace widgets
