// SPDX-License-Identifier: MIT
#include "core/io/files/json_file.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/text_file.h"

namespace core {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

namespace {

constexpr int kMaxDepth = 64;
constexpr int kKnownVersion = 1;

std::string lineAndColumn(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t column = before.size() - (before.find_last_of('\n') + 1) + 1;
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

bool isFlat(const ordered_json& value) {
    return std::none_of(
        value.begin(), value.end(), [](const ordered_json& item) { return item.is_structured(); });
}

/// A list of numbers, or a short list of such lists (a matrix).
bool fitsOnOneLine(const ordered_json& value) {
    if (value.empty() || isFlat(value))
        return true;
    return value.is_array() && value.size() <= 4 &&
           std::all_of(value.begin(), value.end(),
                       [](const ordered_json& row) { return row.is_array() && isFlat(row); });
}

void append(std::string& text, const ordered_json& value, std::size_t indent) {
    if (!value.is_structured() || (value.is_array() && fitsOnOneLine(value))) {
        text += value.dump();
        return;
    }
    const std::string inner(indent + 1, ' ');
    text += value.is_object() ? "{\n" : "[\n";
    std::size_t left = value.size();
    for (const auto& item : value.items()) {
        text += inner;
        if (value.is_object())
            text += ordered_json(item.key()).dump() + ": ";
        append(text, item.value(), indent + 1);
        text += --left > 0 ? ",\n" : "\n";
    }
    text += std::string(indent, ' ') + (value.is_object() ? "}" : "]");
}

} // namespace

int nestingDepth(std::string_view text) {
    int depth = 0, deepest = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            i += c == '\\' ? 1 : 0;
            inString = c != '"';
        } else if (c == '"') {
            inString = true;
        } else if (c == '[' || c == '{') {
            deepest = std::max(deepest, ++depth);
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
    return deepest;
}

json parseJson(std::string_view text, const std::string& file) {
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        throw Error(ErrorCode::BadInput, file, "", "is empty");
    if (nestingDepth(text) > kMaxDepth)
        throw Error(ErrorCode::BadInput, file, "", "is nested more than 64 levels deep");
    try {
        return json::parse(text);
    } catch (const json::parse_error& failure) {
        const bool isCut = failure.byte >= text.size();
        throw Error(ErrorCode::BadInput, file, lineAndColumn(text, failure.byte),
                    isCut ? "the file ends too early: it is cut off or no JSON" : "not JSON");
    } catch (const json::out_of_range&) {
        throw Error(ErrorCode::BadInput, file, "", "holds a number that is too large");
    }
}

json readJsonFile(const fs::path& file) {
    return parseJson(readTextFile(file), file.string());
}

json readOwnFile(const fs::path& file, const std::string& kind) {
    json value = readJsonFile(file);
    checkOwnDocument(value, kind, file.string());
    return value;
}

void checkOwnDocument(const json& value, const std::string& kind, const std::string& file) {
    const std::string format = "handlens-" + kind;
    if (!value.is_object() || !value.contains("format") || value["format"] != format)
        throw Error(ErrorCode::BadInput, file, "format", "is not \"" + format + "\"");
    if (value.contains("version") && value["version"].is_number() && value["version"] > kKnownVersion) {
        throw Error(ErrorCode::Newer, file, "version",
                    value["version"].dump() + " was written by a newer Handlens; this one reads up to " +
                        std::to_string(kKnownVersion));
    }
    checkSchema(value, kind, file);
}

std::string formatJson(const ordered_json& value) {
    std::string text;
    append(text, value, 0);
    return text + "\n";
}

void writeJsonFile(const fs::path& file, const ordered_json& value) {
    writeFileAtomically(file, formatJson(value));
}

std::vector<double> jsonNumbers(const json& list, std::size_t count, const std::string& file,
                                const std::string& field) {
    if (!list.is_array() || list.size() != count) {
        throw Error(ErrorCode::BadInput, file, field,
                    "a list of " + std::to_string(count) + " numbers is expected" +
                        (list.is_array() ? ", not of " + std::to_string(list.size()) : ""));
    }
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (!list[i].is_number() || !std::isfinite(list[i].get<double>()))
            throw Error(ErrorCode::BadInput, file, field + "[" + std::to_string(i) + "]", "is not a finite number");
        values[i] = list[i].get<double>();
    }
    return values;
}

std::vector<int> jsonIntegers(const json& list, std::size_t count, int least, int most, const std::string& file,
                              const std::string& field) {
    const std::vector<double> numbers = jsonNumbers(list, count, file, field);
    std::vector<int> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (numbers[i] != std::floor(numbers[i]) || numbers[i] < least || numbers[i] > most) {
            throw Error(ErrorCode::BadInput, file, field + "[" + std::to_string(i) + "]",
                        "is not a whole number from " + std::to_string(least) + " to " + std::to_string(most));
        }
        values[i] = static_cast<int>(numbers[i]);
    }
    return values;
}

Eigen::Matrix3d jsonMatrix(const json& rows, const std::string& file, const std::string& field) {
    if (!rows.is_array() || rows.size() != 3)
        throw Error(ErrorCode::BadInput, file, field, "three rows of three numbers are expected");
    Eigen::Matrix3d matrix;
    for (int i = 0; i < 3; ++i) {
        matrix.row(i) =
            jsonVector(rows[static_cast<std::size_t>(i)], file, field + "[" + std::to_string(i) + "]").transpose();
    }
    return matrix;
}

Eigen::Vector3d jsonVector(const json& list, const std::string& file, const std::string& field) {
    const std::vector<double> values = jsonNumbers(list, 3, file, field);
    return {values[0], values[1], values[2]};
}

ordered_json jsonOf(const Eigen::Matrix3d& matrix) {
    ordered_json rows = ordered_json::array();
    for (int i = 0; i < 3; ++i)
        rows.push_back(jsonOf(Eigen::Vector3d(matrix.row(i).transpose())));
    return rows;
}

ordered_json jsonOf(const Eigen::Vector3d& vector) {
    return {vector.x(), vector.y(), vector.z()};
}

} // namespace core
