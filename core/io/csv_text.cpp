// SPDX-License-Identifier: MIT
#include "core/io/csv_text.h"

#include <algorithm>

#include "core/error.h"
#include "core/io/text_file.h"
#include "core/text/number_text.h"

namespace core {

namespace {

/// Takes a text apart, cell by cell.
class CsvParser {
public:
    CsvParser(std::string_view text, const std::string& file) : m_text(text), m_file(file) {
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        if (m_text.starts_with(kByteOrderMark)) {
            m_text.remove_prefix(kByteOrderMark.size());
        }
    }

    std::vector<CsvRow> parse() {
        while (m_at < m_text.size()) {
            CsvRow row{cell()};
            while (m_at < m_text.size() && m_text[m_at] == ',') {
                ++m_at;
                row.push_back(cell());
            }
            skipLineEnd();
            if (row.size() > 1 || !row[0].empty()) {
                m_rows.push_back(std::move(row));
            }
        }
        return std::move(m_rows);
    }

private:
    std::string cell() {
        if (m_at < m_text.size() && m_text[m_at] == '"') {
            return quotedCell();
        }
        const std::size_t end = std::min(m_text.find_first_of(",\r\n", m_at), m_text.size());
        const std::string_view content = m_text.substr(m_at, end - m_at);
        m_at = end;
        return std::string(content);
    }

    std::string quotedCell() {
        const int firstLine = m_line;
        std::string content;
        for (++m_at; m_at < m_text.size(); ++m_at) {
            const char c = m_text[m_at];
            if (c == '"') {
                ++m_at;
                if (m_at >= m_text.size() || m_text[m_at] != '"') {
                    return content;
                }
            }
            m_line += c == '\n';
            content += c;
        }
        throw Error(ErrorCode::BadInput, m_file, "line " + std::to_string(firstLine), "a quote is never closed");
    }

    void skipLineEnd() {
        if (m_at < m_text.size() && m_text[m_at] == '\r') {
            ++m_at;
        }
        if (m_at < m_text.size() && m_text[m_at] == '\n') {
            ++m_at;
            ++m_line;
        } else if (m_at < m_text.size() && m_text[m_at - 1] != '\r') {
            throw Error(ErrorCode::BadInput, m_file, "line " + std::to_string(m_line), "something follows a quoted cell");
        }
    }

    std::string_view m_text;
    const std::string& m_file;
    std::size_t m_at = 0;
    int m_line = 1;
    std::vector<CsvRow> m_rows;
};

} // namespace

std::vector<CsvRow> parseCsv(std::string_view text, const std::string& file) { return CsvParser(text, file).parse(); }

std::vector<CsvRow> readCsv(const std::filesystem::path& file) { return parseCsv(readTextFile(file), file.string()); }

std::optional<double> cellNumber(std::string_view cell, const std::string& file, const std::string& field) {
    const std::size_t first = std::min(cell.find_first_not_of(" \t"), cell.size());
    cell = cell.substr(first, cell.find_last_not_of(" \t") + 1 - first);
    constexpr std::string_view kMissing[] = {"", "NaN", "nan", "NAN", "null", "NA", "None"};
    if (std::find(std::begin(kMissing), std::end(kMissing), cell) != std::end(kMissing)) {
        return std::nullopt;
    }
    double value = 0;
    if (!parseNumber(cell, value)) {
        throw Error(ErrorCode::BadInput, file, field, "\"" + std::string(cell) + "\" is not a number");
    }
    return value;
}

} // namespace core
