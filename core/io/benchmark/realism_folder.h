// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/benchmark/realism_report.h"

namespace core {

/// Where the finished fits of one setting are kept.
std::filesystem::path realismSettingFolder(const std::filesystem::path& folder, const RealismSetting& setting);

/// Writes realism.csv, table.md, table.tex and report.html of a sweep. Throws Error(Io).
void writeRealismTables(const std::filesystem::path& folder, const std::string& dataset,
                        std::vector<RealismResult> results, const std::vector<std::string>& methods);

} // namespace core
