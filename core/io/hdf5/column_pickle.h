// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace core {

/// The names of columns as PyTables stores them in an attribute: a Python list of texts, or of tuples of texts, pickled
/// in protocol 0. Every column becomes its texts, level by level. Nothing is executed: anything but lists, tuples,
/// texts, whole numbers and None gives nothing.
std::optional<std::vector<std::vector<std::string>>> columnsOfPickle(std::string_view pickle);

} // namespace core
