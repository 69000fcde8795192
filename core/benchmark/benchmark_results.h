// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/benchmark/pairs.h"

namespace core {

/// What one method made of one pair. Lengths in mm, rounded to 1e-6 mm (so that a written result reads back equal).
struct PairResult {
    FramePair pair;
    std::string method;        ///< as asked for, or the name of an external tracker
    double initialErrorMm = 0; ///< mean joint distance of the start pose
    double errorMm = 0;        ///< mean joint distance of the estimate
    int iterations = 0;
    int costRises = 0;                 ///< iterations that ended with a higher cost than the one before
    double seconds = 0;                ///< from masks in memory to the final pose; 0 for external trackers
    std::vector<double> jointErrorsMm; ///< parallel to BenchmarkResults::joints; NaN where there is no reference
    bool operator==(const PairResult&) const = default;
};

/// All that a benchmark found: plain data, from which every table and figure is made.
struct BenchmarkResults {
    std::vector<JointId> joints;
    std::vector<FramePair> pairs;      ///< all pairs, also those of other shards
    std::vector<std::string> methods;  ///< in the order of the tables
    std::vector<PairResult> rows;      ///< in the order of pairs, then methods
    std::vector<std::string> external; ///< those of `methods` that were not run here: other trackers' estimates
    bool stopped = false;              ///< true if the run was stopped before its end
    bool papersHands = false; ///< true if the hands are those of the paper, so that its numbers may stand beside ours
};

/// Brings rows into the order of `pairs`, then `methods`.
void sortRows(BenchmarkResults& results);

/// Those of the rows whose pair is among `pairs`.
std::vector<PairResult> rowsOfPairs(const std::vector<PairResult>& rows, const std::vector<FramePair>& pairs);

/// Adds other trackers and their rows to finished results.
void addExternalRows(BenchmarkResults& results, const std::vector<std::string>& names,
                     const std::vector<PairResult>& rows);

} // namespace core
