// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/benchmark/benchmark_results.h"
#include "core/text/gnuplot_text.h"

namespace core {

/// The methods that overview figures show, in the order of the tables: those without options if there are any, at most
/// `most`; other trackers are always among them.
std::vector<std::string> headlineMethods(const BenchmarkResults& results, std::size_t most = 9);

/// A method's colour (#rrggbb) in every figure of these results.
std::string methodColour(const BenchmarkResults& results, const std::string& method);

/// Error curves, error over the difference, error per joint, and error against seconds; `methods` chooses the lines.
std::vector<Figure> overviewFigures(const BenchmarkResults& results, const std::vector<std::string>& methods);

/// The paper's sweeps under both schedules, as far as their methods were run, and the error curves of the best of each.
std::vector<Figure> sweepResultFigures(const BenchmarkResults& results);

} // namespace core
