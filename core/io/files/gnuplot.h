// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace core {

/// The SVG documents that gnuplot makes of the programs, each ready to stand inside an HTML page, in order; empty if
/// gnuplot is not installed. Throws Error(Io) if gnuplot fails on one of them, with what it said.
std::optional<std::vector<std::string>> drawWithGnuplot(const std::vector<std::string>& programs);

} // namespace core
