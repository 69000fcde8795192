// SPDX-License-Identifier: MIT
#include "core/io/store/annotation_tables.h"

#include <cmath>

#include "core/error.h"
#include "core/io/store/row_reader.h"

namespace core {

namespace {

void bindKey(SQLite::Statement& statement, int first, const MarkKey& key) {
    statement.bind(first, key.frame);
    statement.bind(first + 1, key.rater);
    statement.bind(first + 2, std::string(sideName(key.joint.hand)));
    statement.bind(first + 3, key.joint.joint);
    statement.bind(first + 4, key.camera);
}

constexpr int kMarkColumns = 5;

/// x, y, placement, state, likelihood; NULLs for no mark.
void bindMark(SQLite::Statement& statement, int first, const std::optional<Mark>& mark) {
    if (mark) {
        statement.bind(first, mark->px.x());
        statement.bind(first + 1, mark->px.y());
        statement.bind(first + 2, std::string(placementName(mark->placement)));
        statement.bind(first + 3, std::string(stateName(mark->state)));
        mark->likelihood ? statement.bind(first + 4, *mark->likelihood) : statement.bind(first + 4);
    } else {
        for (int i = 0; i < kMarkColumns; ++i)
            statement.bind(first + i);
    }
}

bool readKey(const RowReader& row, int first, MarkKey& key) {
    const auto hand = sideFromName(row.text(first + 2));
    key.frame = row.integer(first);
    key.rater = row.text(first + 1);
    key.joint.hand = hand.value_or(Side::Left);
    key.joint.joint = row.text(first + 3);
    key.camera = row.text(first + 4);
    return hand.has_value();
}

/// False if the columns contradict each other; NULLs mean no mark.
bool readMark(const RowReader& row, int first, std::optional<Mark>& mark) {
    mark.reset();
    if (row.isNull(first + 3))
        return row.isNull(first);
    const auto placement = placementFromName(row.text(first + 2));
    const auto state = stateFromName(row.text(first + 3));
    const Eigen::Vector2d px(row.real(first), row.real(first + 1));
    if (!placement || !state || !px.allFinite())
        return false;
    mark = Mark{px, *placement, *state, row.isNull(first + 4) ? std::nullopt : std::optional(row.real(first + 4))};
    return true;
}

/// Runs a statement that is used again later.
struct Run {
    explicit Run(SQLite::Statement& statement)
        : m_statement(statement) {}
    ~Run() {
        m_statement.tryReset();
        try {
            m_statement.clearBindings();
        } catch (const SQLite::Exception&) {
            // bindings are overwritten at the next use
        }
    }
    SQLite::Statement& m_statement;
};

} // namespace

AnnotationTables::AnnotationTables(SQLite::Database& database, std::string fileName)
    : m_database(database)
    , m_fileName(std::move(fileName)) {}

std::string AnnotationTables::likelihoodColumn(const std::string& suffix) {
    if (!m_hasLikelihoods) {
        m_hasLikelihoods =
            m_database.execAndGet("SELECT count(*) FROM pragma_table_info('mark') WHERE name = 'likelihood'").getInt() >
            0;
    }
    return *m_hasLikelihoods ? "likelihood" + suffix : "NULL";
}

SQLite::Statement& AnnotationTables::prepared(const char* sql) {
    const auto found = m_statements.find(sql);
    return found != m_statements.end() ? found->second
                                       : m_statements.emplace(sql, SQLite::Statement(m_database, sql)).first->second;
}

void AnnotationTables::refuse(const std::string& field, const std::string& detail) const {
    throw Error(ErrorCode::BadInput, m_fileName, field, detail);
}

AnnotationSet AnnotationTables::readSet() {
    AnnotationSet set;
    const std::string select = "SELECT frame, rater, hand, joint, camera, x, y, placement, state, " +
                               likelihoodColumn("") + " FROM mark ORDER BY frame, rater, hand, joint, camera";
    RowReader marks(m_database.getHandle(), select.c_str());
    while (marks.next()) {
        MarkKey key;
        std::optional<Mark> mark;
        if (!readKey(marks, 0, key) || !readMark(marks, 5, mark) || !mark)
            refuse("mark of frame " + std::to_string(key.frame), "makes no sense");
        set.marks.emplace_hint(set.marks.end(), std::move(key), *mark);
    }
    RowReader notes(m_database.getHandle(), "SELECT frame, text FROM note");
    while (notes.next())
        set.notes[notes.integer(0)] = notes.text(1);
    return set;
}

namespace {

void bindRange(RowReader& rows, EntryState state, std::int64_t first, std::int64_t last) {
    rows.bind(1, static_cast<int>(state));
    rows.bind(2, first);
    rows.bind(3, last);
}

/// The entry of that id; ids ascend from one call to the next, so the search starts where the last one ended.
Edit& editOf(std::vector<JournalEntry>& entries, std::size_t& place, std::int64_t id) {
    while (entries.at(place).id != id)
        ++place;
    return entries[place].edit;
}

} // namespace

std::vector<JournalEntry> AnnotationTables::readEntries(EntryState state, std::int64_t first, std::int64_t last) {
    std::vector<JournalEntry> entries;
    RowReader journal(m_database.getHandle(),
                      "SELECT id, rater, time, label FROM journal WHERE state = ? AND id BETWEEN ? AND ? ORDER BY id");
    bindRange(journal, state, first, last);
    while (journal.next()) {
        entries.push_back({journal.integer64(0),
                           std::string(journal.text(1)),
                           std::string(journal.text(2)),
                           {parseEditLabel(journal.text(3)), {}, {}}});
    }
    const std::string select =
        "SELECT c.entry, c.frame, c.rater, c.hand, c.joint, c.camera, x_before, y_before, placement_before, "
        "state_before, " +
        likelihoodColumn("_before") + ", x_after, y_after, placement_after, state_after, " +
        likelihoodColumn("_after") +
        " FROM journal j CROSS JOIN mark_change c ON c.entry = j.id WHERE j.state = ? AND j.id BETWEEN ? AND ? "
        "ORDER BY j.id, c.position";
    RowReader marks(m_database.getHandle(), select.c_str());
    bindRange(marks, state, first, last);
    for (std::size_t place = 0; marks.next();) {
        MarkChange& change = editOf(entries, place, marks.integer64(0)).marks.emplace_back();
        if (!readKey(marks, 1, change.key) || !readMark(marks, 6, change.before) ||
            !readMark(marks, 6 + kMarkColumns, change.after))
            refuse("journal entry " + std::to_string(marks.integer64(0)), "makes no sense");
    }
    RowReader notes(
        m_database.getHandle(),
        "SELECT c.entry, c.frame, text_before, text_after FROM journal j CROSS JOIN note_change c ON c.entry = j.id "
        "WHERE j.state = ? AND j.id BETWEEN ? AND ? ORDER BY j.id, c.position");
    bindRange(notes, state, first, last);
    for (std::size_t place = 0; notes.next();) {
        editOf(entries, place, notes.integer64(0))
            .notes.push_back({notes.integer(1), std::string(notes.text(2)), std::string(notes.text(3))});
    }
    return entries;
}

std::optional<std::int64_t> AnnotationTables::newestEntry(EntryState state, int n) {
    const Run run(prepared("SELECT id FROM journal WHERE state = ? ORDER BY id DESC LIMIT 1 OFFSET ?"));
    run.m_statement.bind(1, static_cast<int>(state));
    run.m_statement.bind(2, n);
    return run.m_statement.executeStep() ? std::optional(run.m_statement.getColumn(0).getInt64()) : std::nullopt;
}

std::optional<std::int64_t> AnnotationTables::oldestEntry(EntryState state) {
    const Run run(prepared("SELECT id FROM journal WHERE state = ? ORDER BY id LIMIT 1"));
    run.m_statement.bind(1, static_cast<int>(state));
    return run.m_statement.executeStep() ? std::optional(run.m_statement.getColumn(0).getInt64()) : std::nullopt;
}

void AnnotationTables::applyEdit(const Edit& edit, const std::string& rater, const std::string& time) {
    for (const MarkChange& change : edit.marks) {
        applyMark(change, rater, time, edit);
        if (m_markWritten)
            m_markWritten();
    }
    for (const NoteChange& change : edit.notes)
        applyNote(change, rater, time, edit);
}

void AnnotationTables::applyMark(const MarkChange& change, const std::string& rater, const std::string& time,
                                 const Edit& edit) {
    if (change.after && !change.after->px.allFinite())
        refuse("edit \"" + editLabel(edit.description) + "\"", "a pixel position is not finite");
    int changed = 0;
    if (change.before) {
        constexpr const char* kUpdate = "UPDATE mark SET x = ?, y = ?, placement = ?, state = ?, likelihood = ?, "
                                        "author = ?, time = ? WHERE frame = ? "
                                        "AND rater = ? AND hand = ? AND joint = ? AND camera = ? AND x = ? AND y = ? "
                                        "AND placement = ? AND state = ? "
                                        "AND likelihood IS ?";
        constexpr const char* kDelete =
            "DELETE FROM mark WHERE frame = ? AND rater = ? AND hand = ? AND joint = ? AND camera = ? AND x = ? "
            "AND y = ? AND placement = ? AND state = ? AND likelihood IS ?";
        const Run run(prepared(change.after ? kUpdate : kDelete));
        int next = 1;
        if (change.after) {
            bindMark(run.m_statement, 1, change.after);
            run.m_statement.bind(kMarkColumns + 1, rater);
            run.m_statement.bind(kMarkColumns + 2, time);
            next = kMarkColumns + 3;
        }
        bindKey(run.m_statement, next, change.key);
        bindMark(run.m_statement, next + 5, change.before);
        changed = run.m_statement.exec();
    } else if (change.after) {
        const Run run(prepared("INSERT OR IGNORE INTO mark(frame, rater, hand, joint, camera, x, y, placement, state, "
                               "likelihood, author, time) "
                               "VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"));
        bindKey(run.m_statement, 1, change.key);
        bindMark(run.m_statement, 6, change.after);
        run.m_statement.bind(6 + kMarkColumns, rater);
        run.m_statement.bind(7 + kMarkColumns, time);
        changed = run.m_statement.exec();
    } else {
        changed = 1; // nothing before, nothing after
    }
    if (changed != 1) {
        refuse("edit \"" + editLabel(edit.description) + "\"",
               jointLabel(change.key.joint) + " in " + change.key.camera + ", frame " +
                   std::to_string(change.key.frame) + " is not in the state that the edit starts from");
    }
}

void AnnotationTables::applyNote(const NoteChange& change, const std::string& rater, const std::string& time,
                                 const Edit& edit) {
    const Run current(prepared("SELECT text FROM note WHERE frame = ?"));
    current.m_statement.bind(1, change.frame);
    const std::string before =
        current.m_statement.executeStep() ? current.m_statement.getColumn(0).getString() : std::string();
    if (before != change.before)
        refuse("edit \"" + editLabel(edit.description) + "\"",
               "the note of frame " + std::to_string(change.frame) + " is another one");
    const Run run(prepared(change.after.empty() ? "DELETE FROM note WHERE frame = ?"
                                                : "INSERT OR REPLACE INTO note VALUES(?, ?, ?, ?)"));
    run.m_statement.bind(1, change.frame);
    if (!change.after.empty()) {
        run.m_statement.bind(2, change.after);
        run.m_statement.bind(3, rater);
        run.m_statement.bind(4, time);
    }
    run.m_statement.exec();
}

void AnnotationTables::addEntry(const Edit& edit, const std::string& rater, const std::string& time) {
    const Run run(prepared("INSERT INTO journal(label, rater, time, state) VALUES(?, ?, ?, 0)"));
    run.m_statement.bind(1, editLabel(edit.description));
    run.m_statement.bind(2, rater);
    run.m_statement.bind(3, time);
    run.m_statement.exec();
    addChanges(m_database.getLastInsertRowid(), edit);
}

void AnnotationTables::addChanges(std::int64_t id, const Edit& edit) {
    int position = 0;
    for (const MarkChange& change : edit.marks) {
        const Run run(prepared("INSERT INTO mark_change(entry, position, frame, rater, hand, joint, camera, x_before, "
                               "y_before, placement_before, state_before, "
                               "likelihood_before, x_after, y_after, placement_after, state_after, likelihood_after) "
                               "VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"));
        run.m_statement.bind(1, id);
        run.m_statement.bind(2, position++);
        bindKey(run.m_statement, 3, change.key);
        bindMark(run.m_statement, 8, change.before);
        bindMark(run.m_statement, 8 + kMarkColumns, change.after);
        run.m_statement.exec();
        if (m_markWritten)
            m_markWritten();
    }
    for (const NoteChange& change : edit.notes) {
        const Run run(prepared("INSERT INTO note_change VALUES(?, ?, ?, ?, ?)"));
        run.m_statement.bind(1, id);
        run.m_statement.bind(2, position++);
        run.m_statement.bind(3, change.frame);
        run.m_statement.bind(4, change.before);
        run.m_statement.bind(5, change.after);
        run.m_statement.exec();
    }
}

void AnnotationTables::replaceEntry(std::int64_t id, const Edit& edit, const std::string& time) {
    for (const char* sql : {"DELETE FROM mark_change WHERE entry = ?", "DELETE FROM note_change WHERE entry = ?"}) {
        const Run run(prepared(sql));
        run.m_statement.bind(1, id);
        run.m_statement.exec();
    }
    const Run run(prepared("UPDATE journal SET time = ? WHERE id = ?"));
    run.m_statement.bind(1, time);
    run.m_statement.bind(2, id);
    run.m_statement.exec();
    addChanges(id, edit);
}

void AnnotationTables::removeEntry(std::int64_t id) {
    replaceEntry(id, {}, {});
    const Run run(prepared("DELETE FROM journal WHERE id = ?"));
    run.m_statement.bind(1, id);
    run.m_statement.exec();
}

void AnnotationTables::setEntryState(std::int64_t id, EntryState state) {
    const Run run(prepared("UPDATE journal SET state = ? WHERE id = ?"));
    run.m_statement.bind(1, static_cast<int>(state));
    run.m_statement.bind(2, id);
    run.m_statement.exec();
}

void AnnotationTables::abandonUndone() {
    const Run run(prepared("UPDATE journal SET state = 2 WHERE state = 1"));
    run.m_statement.exec();
}

std::optional<std::string> AnnotationTables::setting(const std::string& key) {
    const Run run(prepared("SELECT value FROM setting WHERE key = ?"));
    run.m_statement.bind(1, key);
    return run.m_statement.executeStep() ? std::optional(run.m_statement.getColumn(0).getString()) : std::nullopt;
}

void AnnotationTables::setSetting(const std::string& key, const std::string& value) {
    const Run run(prepared("INSERT OR REPLACE INTO setting VALUES(?, ?)"));
    run.m_statement.bind(1, key);
    run.m_statement.bind(2, value);
    run.m_statement.exec();
}

std::int64_t AnnotationTables::changeCount() {
    const Run run(prepared("SELECT value FROM counter WHERE name = 'changes'"));
    return run.m_statement.executeStep() ? run.m_statement.getColumn(0).getInt64() : 0;
}

void AnnotationTables::countChange() {
    const Run run(prepared("UPDATE counter SET value = value + 1 WHERE name = 'changes'"));
    run.m_statement.exec();
}

} // namespace core
