// SPDX-License-Identifier: MIT
#include "core/io/store/annotation_schema.h"

#include <SQLiteCpp/SQLiteCpp.h>

namespace core {

namespace {

constexpr const char* kSchema = R"sql(
CREATE TABLE mark(
  frame INTEGER NOT NULL CHECK(typeof(frame) = 'integer'),
  rater TEXT NOT NULL CHECK(typeof(rater) = 'text'),
  hand TEXT NOT NULL CHECK(hand IN ('left', 'right')),
  joint TEXT NOT NULL CHECK(typeof(joint) = 'text'),
  camera TEXT NOT NULL CHECK(typeof(camera) = 'text'),
  x REAL NOT NULL CHECK(typeof(x) = 'real'),
  y REAL NOT NULL CHECK(typeof(y) = 'real'),
  placement TEXT NOT NULL CHECK(placement IN ('manual', 'auto', 'proposed')),
  state TEXT NOT NULL CHECK(state IN ('visible', 'occluded', 'unplaceable')),
  author TEXT NOT NULL,
  time TEXT NOT NULL,
  likelihood REAL,
  PRIMARY KEY(frame, rater, hand, joint, camera)) WITHOUT ROWID;
CREATE TABLE note(
  frame INTEGER PRIMARY KEY,
  text TEXT NOT NULL,
  author TEXT NOT NULL,
  time TEXT NOT NULL);
CREATE TABLE journal(
  id INTEGER PRIMARY KEY,
  label TEXT NOT NULL,
  rater TEXT NOT NULL,
  time TEXT NOT NULL,
  state INTEGER NOT NULL CHECK(state IN (0, 1, 2)));
CREATE INDEX journal_by_state ON journal(state, id);
CREATE TABLE mark_change(
  entry INTEGER NOT NULL,
  position INTEGER NOT NULL,
  frame INTEGER NOT NULL,
  rater TEXT NOT NULL,
  hand TEXT NOT NULL CHECK(hand IN ('left', 'right')),
  joint TEXT NOT NULL,
  camera TEXT NOT NULL,
  x_before REAL, y_before REAL,
  placement_before TEXT CHECK(placement_before IN ('manual', 'auto', 'proposed')),
  state_before TEXT CHECK(state_before IN ('visible', 'occluded', 'unplaceable')),
  x_after REAL, y_after REAL,
  placement_after TEXT CHECK(placement_after IN ('manual', 'auto', 'proposed')),
  state_after TEXT CHECK(state_after IN ('visible', 'occluded', 'unplaceable')),
  likelihood_before REAL, likelihood_after REAL,
  PRIMARY KEY(entry, position)) WITHOUT ROWID;
CREATE TABLE note_change(
  entry INTEGER NOT NULL,
  position INTEGER NOT NULL,
  frame INTEGER NOT NULL,
  text_before TEXT NOT NULL,
  text_after TEXT NOT NULL,
  PRIMARY KEY(entry, position)) WITHOUT ROWID;
CREATE TABLE setting(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE counter(name TEXT PRIMARY KEY, value INTEGER NOT NULL) WITHOUT ROWID;
INSERT INTO counter VALUES('changes', 0);
)sql";

} // namespace

void createAnnotationTables(SQLite::Database& database) {
    database.exec("PRAGMA application_id = " + std::to_string(kAnnotationApplicationId));
    database.exec("PRAGMA user_version = " + std::to_string(kAnnotationVersion));
    database.exec(kSchema);
}

bool isOlderVersion(SQLite::Database& database) {
    return database.execAndGet("PRAGMA user_version").getInt() < kAnnotationVersion;
}

namespace {

/// Version 1 knew no proposed marks: only the tables' conditions differ.
void allowProposals(SQLite::Database& database) {
    database.exec("BEGIN IMMEDIATE");
    database.exec("PRAGMA writable_schema = ON");
    database.exec("UPDATE sqlite_master SET sql = replace(sql, 'IN (''manual'', ''auto'')', 'IN (''manual'', ''auto'', "
                  "''proposed'')') "
                  "WHERE type = 'table' AND name IN ('mark', 'mark_change')");
    database.exec("PRAGMA user_version = 2");
    database.exec("COMMIT");
    database.exec("PRAGMA writable_schema = RESET");
}

/// Version 2 knew no likelihoods.
void addLikelihoods(SQLite::Database& database) {
    database.exec("BEGIN IMMEDIATE");
    database.exec("ALTER TABLE mark ADD COLUMN likelihood REAL");
    database.exec("ALTER TABLE mark_change ADD COLUMN likelihood_before REAL");
    database.exec("ALTER TABLE mark_change ADD COLUMN likelihood_after REAL");
    database.exec("PRAGMA user_version = 3");
    database.exec("COMMIT");
}

} // namespace

void upgradeAnnotationTables(SQLite::Database& database) {
    if (database.execAndGet("PRAGMA user_version").getInt() < 2)
        allowProposals(database);
    if (database.execAndGet("PRAGMA user_version").getInt() < 3)
        addLikelihoods(database);
}

std::vector<std::pair<std::string, std::string>> annotationRowConditions() {
    const std::string keyIs = "typeof(frame) = 'integer' AND typeof(rater) = 'text' AND hand IN ('left', 'right') AND "
                              "typeof(joint) = 'text' AND typeof(camera) = 'text'";
    const auto markIs = [](const std::string& suffix) {
        return "typeof(x" + suffix + ") = 'real' AND typeof(y" + suffix + ") = 'real' AND placement" + suffix +
               " IN ('manual', 'auto', 'proposed') AND state" + suffix + " IN ('visible', 'occluded', 'unplaceable')";
    };
    const auto optionalMarkIs = [&markIs](const std::string& suffix) {
        return "(x" + suffix + " IS NULL AND state" + suffix + " IS NULL OR " + markIs(suffix) + ")";
    };
    return {{"mark", keyIs + " AND " + markIs("")},
            {"mark_change", keyIs + " AND " + optionalMarkIs("_before") + " AND " + optionalMarkIs("_after")},
            {"journal", "state IN (0, 1, 2)"}};
}

} // namespace core
