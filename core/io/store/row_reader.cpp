// SPDX-License-Identifier: MIT
#include "core/io/store/row_reader.h"

#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>

namespace core {

RowReader::RowReader(sqlite3* database, const char* sql)
    : m_database(database) {
    const int code = sqlite3_prepare_v2(database, sql, -1, &m_statement, nullptr);
    if (code != SQLITE_OK)
        fail(code);
}

RowReader::~RowReader() {
    sqlite3_finalize(m_statement);
}

void RowReader::fail(int code) const {
    throw SQLite::Exception(sqlite3_errmsg(m_database), code);
}

void RowReader::bind(int index, std::int64_t value) {
    const int code = sqlite3_bind_int64(m_statement, index, value);
    if (code != SQLITE_OK)
        fail(code);
}

bool RowReader::next() {
    const int code = sqlite3_step(m_statement);
    if (code != SQLITE_ROW && code != SQLITE_DONE)
        fail(code);
    return code == SQLITE_ROW;
}

bool RowReader::isNull(int column) const {
    return sqlite3_column_type(m_statement, column) == SQLITE_NULL;
}
int RowReader::integer(int column) const {
    return sqlite3_column_int(m_statement, column);
}
std::int64_t RowReader::integer64(int column) const {
    return sqlite3_column_int64(m_statement, column);
}
double RowReader::real(int column) const {
    return sqlite3_column_double(m_statement, column);
}

std::string_view RowReader::text(int column) const {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(m_statement, column));
    return text ? std::string_view(text, static_cast<std::size_t>(sqlite3_column_bytes(m_statement, column)))
                : std::string_view();
}

} // namespace core
