// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace core {

/// The whole content of a file. Throws Error: NotFound if there is none, Io if it cannot be read, BadInput if it is
/// larger than `maxBytes` (a video given for a text file must not fill the memory).
std::string readTextFile(const std::filesystem::path& file, std::size_t maxBytes = std::size_t(1) << 30);

/// Walks through a text file line by line. Line ends may be LF or CRLF; empty lines are skipped.
class LineReader {
public:
    explicit LineReader(const std::filesystem::path& file);
    LineReader(std::string name, std::string content);

    bool atEnd();
    /// The next line, trimmed. Throws Error at the end of the file, naming what was expected.
    std::string_view next(std::string_view expected);
    /// The next line as exactly `count` finite numbers.
    std::vector<double> nextNumbers(std::size_t count, std::string_view expected);
    /// The next line as one whole number within [least, most].
    int nextInteger(int least, int most, std::string_view expected);
    /// Bad input at the line that was read last.
    Error errorHere(const std::string& detail) const;
    const std::string& name() const { return m_name; }

private:
    void skipEmptyLines();

    std::string m_name;
    std::string m_content;
    std::size_t m_position = 0;
    int m_line = 0;     ///< number of the line at m_position, from 0
    int m_lineRead = 0; ///< number of the line read last, from 1
};

/// True if a name can be that of a file: not empty, no slash, no control characters, not "." or "..".
bool isFileName(std::string_view name);
/// Splits at blanks and tabs (and commas if `commas`).
std::vector<std::string_view> splitWords(std::string_view line, bool commas = false);

} // namespace core
