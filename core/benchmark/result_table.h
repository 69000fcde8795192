// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/benchmark/benchmark_results.h"
#include "core/benchmark/benchmark_run.h"

namespace core {

/// A table in the paper's layout, ready to be written in any form: a name, then mean and standard deviation in mm per
/// difference and over all, then seconds per pair. Cells without a value are empty.
struct ResultTable {
    struct Cell {
        std::string mean;
        std::string std; ///< empty for plain numbers
    };
    struct Row {
        std::string name;
        std::vector<Cell> cells; ///< parallel to columns
        bool published = false;  ///< a row of the paper
    };
    std::vector<std::string> columns;
    std::vector<Row> rows;
};

/// Start poses, every method and, where the hands are the paper's, its row below the method that it belongs to.
ResultTable resultTable(const BenchmarkResults& results, BenchmarkSetup setup);

std::string markdownTable(const ResultTable& table);
/// A LaTeX tabular, without any package.
std::string latexTable(const ResultTable& table);
std::string htmlTable(const ResultTable& table);

} // namespace core
