// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/annotation/edit.h"

namespace core {

/// One step of the history as it is kept in the file.
struct JournalEntry {
    std::int64_t id = 0; ///< ascending in the order of the edits
    std::string rater;   ///< who did it
    std::string time;    ///< when, UTC, ISO 8601 with milliseconds
    Edit edit;
};

/// The history of a file. An edit that was made after an undo makes the undone ones unreachable (they stay in the
/// file).
struct AnnotationHistory {
    std::vector<JournalEntry> done;   ///< can be undone, oldest first
    std::vector<JournalEntry> undone; ///< can be redone; the next one to redo is the last
};

/// Current time in UTC as it is written to files: 2026-01-31T12:34:56.789Z.
std::string utcTimestamp();

} // namespace core
