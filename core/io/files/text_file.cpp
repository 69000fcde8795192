// SPDX-License-Identifier: MIT
#include "core/io/files/text_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/text/number_text.h"

namespace core {

namespace fs = std::filesystem;

std::string readTextFile(const fs::path& file, std::size_t maxBytes) {
    std::error_code failure;
    const fs::file_status status = fs::status(file, failure);
    if (!fs::exists(status))
        throw Error(ErrorCode::NotFound, file.string(), "", "no such file");
    if (fs::is_directory(status))
        throw Error(ErrorCode::BadInput, file.string(), "", "is a folder, not a file");
    std::ifstream in(file, std::ios::binary);
    if (!in)
        throw Error(ErrorCode::Io, file.string(), "", "cannot be read (permission denied?)");
    std::string content;
    std::vector<char> chunk(1 << 16);
    while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0) {
        content.append(chunk.data(), static_cast<std::size_t>(in.gcount()));
        if (content.size() > maxBytes)
            throw Error(ErrorCode::BadInput, file.string(), "", "is too large to be a file of this kind");
    }
    return content;
}

std::vector<std::string_view> splitWords(std::string_view line, bool commas) {
    const std::string_view separators = commas ? " \t\r," : " \t\r";
    std::vector<std::string_view> words;
    std::size_t start = line.find_first_not_of(separators);
    while (start != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(separators, start), line.size());
        words.push_back(line.substr(start, end - start));
        start = line.find_first_not_of(separators, end);
    }
    return words;
}

bool isFileName(std::string_view name) {
    return !name.empty() && name.size() <= 200 && name != "." && name != ".." &&
           std::none_of(
               name.begin(), name.end(), [](char c) { return c == '/' || static_cast<unsigned char>(c) < 32; });
}

LineReader::LineReader(const fs::path& file)
    : LineReader(file.string(), readTextFile(file)) {}

LineReader::LineReader(std::string name, std::string content)
    : m_name(std::move(name))
    , m_content(std::move(content)) {}

void LineReader::skipEmptyLines() {
    while (m_position < m_content.size()) {
        const std::size_t end = m_content.find('\n', m_position);
        const std::size_t length = (end == std::string::npos ? m_content.size() : end) - m_position;
        if (std::string_view(m_content).substr(m_position, length).find_first_not_of(" \t\r") != std::string_view::npos)
            return;
        m_position += std::min(length + 1, m_content.size() - m_position);
        ++m_line;
    }
}

bool LineReader::atEnd() {
    skipEmptyLines();
    return m_position >= m_content.size();
}

std::string_view LineReader::next(std::string_view expected) {
    if (atEnd())
        throw Error(ErrorCode::BadInput, m_name, "", "ends where " + std::string(expected) + " is expected");
    const std::size_t end = std::min(m_content.find('\n', m_position), m_content.size());
    std::string_view line = std::string_view(m_content).substr(m_position, end - m_position);
    m_position = std::min(end + 1, m_content.size());
    m_lineRead = ++m_line;
    const std::size_t first = line.find_first_not_of(" \t\r");
    return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

std::vector<double> LineReader::nextNumbers(std::size_t count, std::string_view expected) {
    const std::vector<std::string_view> words = splitWords(next(expected));
    if (words.size() != count) {
        throw errorHere(std::to_string(count) + " numbers expected (" + std::string(expected) + "), not " +
                        std::to_string(words.size()));
    }
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i)
        if (!parseNumber(words[i], values[i]))
            throw errorHere("'" + std::string(words[i].substr(0, 40)) + "' is not a finite number");
    return values;
}

int LineReader::nextInteger(int least, int most, std::string_view expected) {
    const double value = nextNumbers(1, expected).front();
    if (value != std::floor(value) || value < least || value > most) {
        throw errorHere(std::string(expected) + " must be a whole number from " + std::to_string(least) + " to " +
                        std::to_string(most));
    }
    return static_cast<int>(value);
}

Error LineReader::errorHere(const std::string& detail) const {
    return Error(ErrorCode::BadInput, m_name, "line " + std::to_string(m_lineRead), detail);
}

} // namespace core
