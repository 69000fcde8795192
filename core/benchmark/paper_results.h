// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/benchmark/benchmark_setup.h"
#include "core/hand/hand_model.h"

namespace core {

/// A published number: mean and standard deviation, mm.
struct PublishedError {
    double meanMm;
    double stdMm;
};

/// One row of the tables of Tzionas and Gall (GCPR 2013).
struct PublishedRow {
    std::string name;                                        ///< as printed there, such as "DCH-Thres"
    std::string method;                                      ///< our name of it, empty if we have none
    std::vector<std::optional<PublishedError>> byDifference; ///< 1, 5, 10, 15 frames
    std::optional<PublishedError> all;
    std::optional<double> seconds; ///< per pair
};

inline constexpr int kPublishedDifferences[] = {1, 5, 10, 15};

/// True if both hands have exactly the bones of the paper's hands: a forearm, and four (thumb: three) per finger.
bool isPapersHands(const std::vector<HandModel>& hands);
/// True if the paper's hands have a joint of this name.
bool isPapersJoint(const std::string& joint);

/// The rows of the paper for a setup, in its order.
std::vector<PublishedRow> publishedRows(BenchmarkSetup setup);

} // namespace core
