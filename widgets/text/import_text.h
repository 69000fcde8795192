// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QString>
#include <QStringList>

#include "core/io/formats/import_notes.h"

namespace widgets {

/// What a person should know about an import, one sentence a note.
QString importNoteInWords(const core::ImportNote& note);
QStringList importNotesInWords(const std::vector<core::ImportNote>& notes);

} // namespace widgets
