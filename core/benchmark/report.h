// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/benchmark/benchmark_results.h"
#include "core/benchmark/benchmark_run.h"
#include "core/benchmark/figures.h"

namespace core {

/// Everything that a report shows.
struct ReportContent {
    std::string dataset; ///< folder, as given: part of the commands that open the worst pairs
    BenchmarkSetup setup = BenchmarkSetup::Synthetic;
    bool sweep = false; ///< with findings and open options
    const BenchmarkResults* results = nullptr;
    std::vector<Figure> figures;
    std::optional<std::vector<std::string>> pictures; ///< SVG per figure; empty if they could not be drawn
};

/// The figures of a report.
std::vector<Figure> reportFigures(const BenchmarkResults& results, bool sweep);

/// One HTML page that needs no network: tables with the paper's rows beside ours, figures, findings, the sensitivity of
/// every open option, and the worst pairs with the command that opens each in the window.
std::string reportHtml(const ReportContent& content);

/// The parts of that page for one setup, from its introduction to its worst pairs, without head and title.
std::string reportBodyHtml(const ReportContent& content);

/// The command that opens a pair's test frame in the window.
std::string openCommand(const std::string& dataset, const FramePair& pair);

} // namespace core
