// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace core {

/// `pattern` with {camera}, {frame} and {frame:06} replaced.
std::string fillPattern(const std::string& pattern, const std::string& camera, int frame);

/// The number that makes `pattern` (with {frame} or {frame:06}) into `name`; -1 if they are the same without one,
/// empty if no number does.
std::optional<int> numberIn(const std::string& pattern, const std::string& name);

/// The parts of a path, folders first, without "." and "..".
std::vector<std::string> pathParts(const std::filesystem::path& path);

/// parts[from] to the last, with slashes between.
std::string joinParts(const std::vector<std::string>& parts, std::size_t from);

} // namespace core
