// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <SQLiteCpp/SQLiteCpp.h>

#include "core/annotation/annotation_set.h"
#include "core/annotation/edit.h"
#include "core/io/store/annotation_journal.h"

namespace core {

/// Whether an entry of the journal is part of the annotations now.
enum class EntryState {
    Done = 0,
    Undone = 1,   ///< can be redone
    Abandoned = 2 ///< was undone when another edit was made
};

/// The tables of an annotation file: every statement that is ever sent to it. Functions throw SQLite::Exception, or
/// Error(BadInput) for a row that makes no sense. Transactions are the caller's.
class AnnotationTables {
public:
    /// `fileName` is for error messages.
    AnnotationTables(SQLite::Database& database, std::string fileName);

    /// Called after every mark that applyEdit and addEntry have written.
    void setMarkWritten(std::function<void()> written) { m_markWritten = std::move(written); }

    AnnotationSet readSet();
    /// Entries in the given state with ids from `first` to `last`, ascending.
    std::vector<JournalEntry> readEntries(EntryState state, std::int64_t first, std::int64_t last);
    /// Id of the n-th newest (0 = newest) entry in that state; empty if there are fewer.
    std::optional<std::int64_t> newestEntry(EntryState state, int n = 0);
    std::optional<std::int64_t> oldestEntry(EntryState state);

    /// Writes marks and notes. Throws Error(BadInput) if `before` is not what is there.
    void applyEdit(const Edit& edit, const std::string& rater, const std::string& time);
    void addEntry(const Edit& edit, const std::string& rater, const std::string& time);
    /// Replaces what an entry did.
    void replaceEntry(std::int64_t id, const Edit& edit, const std::string& time);
    void removeEntry(std::int64_t id);
    void setEntryState(std::int64_t id, EntryState state);
    void abandonUndone();

    std::optional<std::string> setting(const std::string& key);
    void setSetting(const std::string& key, const std::string& value);

    /// How often the file was changed.
    std::int64_t changeCount();
    void countChange();

private:
    SQLite::Statement& prepared(const char* sql);
    /// The column of that name, or NULL in a file of a version without.
    std::string likelihoodColumn(const std::string& suffix);
    void applyMark(const MarkChange& change, const std::string& rater, const std::string& time, const Edit& edit);
    void applyNote(const NoteChange& change, const std::string& rater, const std::string& time, const Edit& edit);
    void addChanges(std::int64_t id, const Edit& edit);
    [[noreturn]] void refuse(const std::string& field, const std::string& detail) const;

    SQLite::Database& m_database;
    std::string m_fileName;
    std::map<std::string, SQLite::Statement> m_statements;
    std::optional<bool> m_hasLikelihoods;
    std::function<void()> m_markWritten;
};

} // namespace core
