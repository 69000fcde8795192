// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/benchmark/benchmark_results.h"

namespace core {

// Tables for other programs: comma-separated, one header line, LF, a point in numbers; a value that does not exist is
// empty.

/// sequence,start,test,difference,method,initial_error_mm,error_mm,iterations,seconds
std::string resultsCsv(const BenchmarkResults& results);
/// sequence,start,test,difference,method,hand,joint,error_mm: a line per joint of every row
std::string jointsCsv(const BenchmarkResults& results);
/// method,threshold_mm,share: share of the pairs below the threshold; "initial" are the start poses
std::string curvesCsv(const BenchmarkResults& results);

} // namespace core
