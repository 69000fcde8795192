// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QUndoCommand>

#include "core/annotation/edit.h"

namespace widgets {

class EditTarget;

/// The one undo command: an edit of the annotations, whatever it does.
class EditCommand : public QUndoCommand {
public:
    /// Commands of the same non-negative `joins` that follow each other become one step.
    EditCommand(EditTarget& target, core::Edit edit, int joins = -1, bool amends = false);

    void undo() override;
    void redo() override;
    int id() const override { return m_joins; }
    bool mergeWith(const QUndoCommand* other) override;

    const core::Edit& edit() const { return *m_edit; }

private:
    EditTarget& m_target;
    std::shared_ptr<const core::Edit> m_edit; ///< shared with what is being written and applied: it may be large
    int m_joins;
    bool m_amends;
    bool m_isFirst = true;
};

} // namespace widgets
