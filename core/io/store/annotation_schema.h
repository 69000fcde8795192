// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace SQLite {
class Database;
}

namespace core {

/// Marks an annotation file in SQLite's header ("HLAN"), and the version of its tables.
inline constexpr int kAnnotationApplicationId = 0x484C414E;
inline constexpr int kAnnotationVersion = 3;

/// Creates all tables in an empty database.
void createAnnotationTables(SQLite::Database& database);
bool isOlderVersion(SQLite::Database& database);
/// Brings the tables of an older version up to date. Needs a connection that may write.
void upgradeAnnotationTables(SQLite::Database& database);
/// What must be true of every row of a table: (name, SQL condition). SQLite's own check leaves such tables' values out.
std::vector<std::pair<std::string, std::string>> annotationRowConditions();

} // namespace core
