// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

namespace core {

/// Reads any JSON file. Throws Error(BadInput) with line and column if it is not JSON, holds a number that is not
/// finite, or is nested more than 64 deep.
nlohmann::json readJsonFile(const std::filesystem::path& file);

/// The same for text that is at hand; `file` is named in errors.
nlohmann::json parseJson(std::string_view text, const std::string& file);

/// Reads a file of one of our own formats, `handlens-<kind>`: format and version are looked at first (Newer if the
/// version is not known), then the whole is checked against the schema of that kind
/// (resources/schemas/<kind>.schema.json).
nlohmann::json readOwnFile(const std::filesystem::path& file, const std::string& kind);
/// The same checks of a file that is already parsed; `file` is named in errors.
void checkOwnDocument(const nlohmann::json& value, const std::string& kind, const std::string& file);

/// How deep lists and objects are nested in JSON-like text, found without parsing: a hostile file must not reach
/// recursive code.
int nestingDepth(std::string_view text);

/// Throws Error(BadInput) naming the field that breaks the schema of that kind.
void checkSchema(const nlohmann::json& value, std::string_view kind, const std::string& file);

/// Text with one member a line, and lists of numbers kept on one line.
std::string formatJson(const nlohmann::ordered_json& value);
/// formatJson, written atomically.
void writeJsonFile(const std::filesystem::path& file, const nlohmann::ordered_json& value);

/// Values out of a list of numbers, checked: that many, all of them finite. `field` names it in the error.
std::vector<double> jsonNumbers(const nlohmann::json& list, std::size_t count, const std::string& file,
                                const std::string& field);
/// The same for whole numbers within [least, most].
std::vector<int> jsonIntegers(const nlohmann::json& list, std::size_t count, int least, int most,
                              const std::string& file, const std::string& field);
/// Three rows of three numbers.
Eigen::Matrix3d jsonMatrix(const nlohmann::json& rows, const std::string& file, const std::string& field);
Eigen::Vector3d jsonVector(const nlohmann::json& list, const std::string& file, const std::string& field);

nlohmann::ordered_json jsonOf(const Eigen::Matrix3d& matrix); ///< three rows
nlohmann::ordered_json jsonOf(const Eigen::Vector3d& vector);

} // namespace core
