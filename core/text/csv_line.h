// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace core {

using CsvRow = std::vector<std::string>;

/// A cell as it stands in a CSV text (RFC 4180): quoted only where it holds a comma, a quote or a line break.
std::string csvCell(const std::string& cell);
/// One line with its line end.
std::string csvLine(const CsvRow& row);

} // namespace core
