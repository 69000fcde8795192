// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/csv_line.h"

namespace core {

/// Cells of a CSV text (RFC 4180: quotes, doubled quotes, line breaks inside them; LF or CRLF). A byte order mark and
/// empty lines are skipped. Semicolons separate the cells if the first line has more of them than commas (or says
/// "sep=;"); numbers with a decimal comma then get a point. Throws Error(BadInput) naming the line of a quote that is
/// never closed. A table with semicolons that has both decimal commas and points is refused.
std::vector<CsvRow> parseCsv(std::string_view text, const std::string& file);
std::vector<CsvRow> readCsv(const std::filesystem::path& file);

/// The number in a cell; empty for a missing value (empty, NaN, nan, null, NA). Throws Error(BadInput) naming file
/// and `field` for anything else.
std::optional<double> cellNumber(std::string_view cell, const std::string& file, const std::string& field);

} // namespace core
