// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QString>
#include <QStringList>

#include "core/io/dataset/attach_masks.h"
#include "core/io/dataset/relink.h"
#include "core/io/footage/footage_note.h"

namespace widgets {

/// What a person should know about footage, one sentence a note. Notes that a dataset of before holds as text stay as
/// they are.
QString footageNoteInWords(const core::FootageNote& note);
QStringList footageNotesInWords(const std::vector<core::FootageNote>& notes);

/// What a person should know about the masks of one camera.
QString maskNoteInWords(const core::MaskNote& note);
/// What keeps footage that was found from being what its sequence needs; empty if nothing does.
QString footageProblemInWords(const core::FootageProblem& problem);
/// Why footage was not found, or what is wrong with what was; empty if nothing is to be said.
QString relinkNoteInWords(const core::RelinkFinding& finding);

} // namespace widgets
