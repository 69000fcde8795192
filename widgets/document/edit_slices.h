// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <set>

#include "core/annotation/edit.h"
#include "widgets/document/edit_target.h"

namespace widgets {

/// A large edit, or the way back from it, in parts: each change comes once, notes first.
class EditSlices {
public:
    EditSlices(std::shared_ptr<const core::Edit> edit, EditDirection direction)
        : m_edit(std::move(edit))
        , m_direction(direction) {}

    /// The next part of at most so many marks; empty when all has come.
    core::Edit next(std::size_t marks);
    /// What has not come yet of the marks and notes that another edit changes: it comes now.
    core::Edit ahead(const core::Edit& other);
    /// How much of it has come, 0 to 1.
    double share() const {
        return m_edit->marks.empty() ? 1 : static_cast<double>(m_at) / static_cast<double>(m_edit->marks.size());
    }
    bool isAtEnd() const { return m_at == m_edit->marks.size() && m_notesCame; }

private:
    core::Edit part() const;
    core::Edit directed(core::Edit slice) const;
    void addNotes(core::Edit& part);

    std::shared_ptr<const core::Edit> m_edit;
    EditDirection m_direction;
    std::size_t m_at = 0; ///< of the next mark
    bool m_notesCame = false;
    std::set<core::MarkKey> m_came; ///< beyond m_at
};

} // namespace widgets
