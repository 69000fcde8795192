// SPDX-License-Identifier: MIT
#include "core/io/files/csv_text.h"

#include <algorithm>

#include "core/error.h"
#include "core/io/files/text_file.h"
#include "core/text/number_text.h"

namespace core {

namespace {

/// Takes a text apart, cell by cell.
class CsvParser {
public:
    CsvParser(std::string_view text, const std::string& file)
        : m_text(text)
        , m_file(file) {
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        if (m_text.starts_with(kByteOrderMark))
            m_text.remove_prefix(kByteOrderMark.size());
        takeSeparatorLine();
        if (!m_isSeparatorGiven)
            m_separator = mostLikelySeparator();
        m_cellEnds[0] = m_separator;
    }

    std::vector<CsvRow> parse() {
        while (m_at < m_text.size()) {
            CsvRow row{cell()};
            while (m_at < m_text.size() && m_text[m_at] == m_separator) {
                ++m_at;
                row.push_back(cell());
            }
            skipLineEnd();
            if (m_separator == ';')
                takeDecimalCommas(row);
            if (row.size() > 1 || !row[0].empty())
                m_rows.push_back(std::move(row));
        }
        return std::move(m_rows);
    }

private:
    /// Excel's own first line, "sep=;".
    void takeSeparatorLine() {
        constexpr std::string_view kName = "sep=";
        const std::size_t end = std::min(m_text.find_first_of("\r\n"), m_text.size());
        if (m_text.starts_with(kName) && end == kName.size() + 1 &&
            (m_text[kName.size()] == ',' || m_text[kName.size()] == ';')) {
            m_separator = m_text[kName.size()];
            m_isSeparatorGiven = true;
            m_at = end;
            skipLineEnd();
        }
    }

    /// A comma, unless the first line has more semicolons: so tables are written where the comma is the decimal sign.
    char mostLikelySeparator() const {
        int commas = 0, semicolons = 0;
        bool isQuoted = false;
        for (const char c : m_text.substr(0, m_text.find_first_of("\r\n"))) {
            isQuoted = isQuoted != (c == '"');
            commas += !isQuoted && c == ',';
            semicolons += !isQuoted && c == ';';
        }
        return semicolons > commas ? ';' : ',';
    }

    /// Writes "12,5" as 12.5. A table that has numbers of both kinds cannot be understood: 1.234 may be a thousand
    /// there.
    void takeDecimalCommas(CsvRow& row) {
        for (std::string& cell : row) {
            const std::size_t comma = cell.find(',');
            double value = 0;
            if (comma == std::string::npos) {
                m_hasPoints = m_hasPoints || (cell.find('.') != std::string::npos && parseNumber(cell, value));
                continue;
            }
            std::string number = cell;
            number[comma] = '.';
            if (number.find('.') == comma && parseNumber(number, value)) {
                cell = number;
                m_hasCommas = true;
            }
        }
        if (m_hasCommas && m_hasPoints) {
            throw Error(ErrorCode::BadInput, m_file, "line " + std::to_string(m_line - 1),
                        "the table has numbers with a decimal comma and numbers with a decimal point: use one of them");
        }
    }

    std::string cell() {
        if (m_at < m_text.size() && m_text[m_at] == '"')
            return quotedCell();
        const std::size_t end = std::min(m_text.find_first_of(m_cellEnds, m_at), m_text.size());
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
                if (m_at >= m_text.size() || m_text[m_at] != '"')
                    return content;
            }
            m_line += c == '\n';
            content += c;
        }
        throw Error(ErrorCode::BadInput, m_file, "line " + std::to_string(firstLine), "a quote is never closed");
    }

    void skipLineEnd() {
        if (m_at < m_text.size() && m_text[m_at] == '\r')
            ++m_at;
        if (m_at < m_text.size() && m_text[m_at] == '\n') {
            ++m_at;
            ++m_line;
        } else if (m_at < m_text.size() && m_text[m_at - 1] != '\r') {
            throw Error(ErrorCode::BadInput, m_file, "line " + std::to_string(m_line),
                        "something follows a quoted cell");
        }
    }

    std::string_view m_text;
    const std::string& m_file;
    std::size_t m_at = 0;
    int m_line = 1;
    char m_separator = ',';
    bool m_isSeparatorGiven = false;
    std::string m_cellEnds = ",\r\n";
    bool m_hasCommas = false, m_hasPoints = false; ///< decimal ones, in a table with semicolons
    std::vector<CsvRow> m_rows;
};

} // namespace

std::vector<CsvRow> parseCsv(std::string_view text, const std::string& file) {
    return CsvParser(text, file).parse();
}

std::vector<CsvRow> readCsv(const std::filesystem::path& file) {
    return parseCsv(readTextFile(file), file.string());
}

std::optional<double> cellNumber(std::string_view cell, const std::string& file, const std::string& field) {
    const std::size_t first = std::min(cell.find_first_not_of(" \t"), cell.size());
    cell = cell.substr(first, cell.find_last_not_of(" \t") + 1 - first);
    constexpr std::string_view kMissing[] = {"", "NaN", "nan", "NAN", "null", "NA", "None"};
    if (std::find(std::begin(kMissing), std::end(kMissing), cell) != std::end(kMissing))
        return std::nullopt;
    double value = 0;
    if (!parseNumber(cell, value))
        throw Error(ErrorCode::BadInput, file, field, "\"" + std::string(cell) + "\" is not a number");
    return value;
}

} // namespace core
