// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/benchmark/rank_agreement.h"
#include "core/benchmark/report.h"
#include "core/benchmark/result_table.h"

namespace core {

/// The results of one setup, among others.
struct SetupResults {
    BenchmarkSetup setup = BenchmarkSetup::Synthetic;
    const BenchmarkResults* results = nullptr;
};

/// The tables of several setups side by side: a row per name, a column per setup and difference. A method's row of the
/// paper stands below it; the paper's full tracker, which has no method of ours, last, and only for the paper's hands.
ResultTable setupsTable(const std::vector<SetupResults>& setups);

/// With fewer pairs in a setup, drawing them again says nothing of how certain an order is.
inline constexpr std::size_t kLeastRankedPairs = 10;
/// How far the order of the methods in the first setup is that of the second. No value with fewer than two setups, two
/// methods that both have, or kLeastRankedPairs pairs in each.
std::optional<RankAgreement> setupsRankAgreement(const std::vector<SetupResults>& setups);
/// Whether the order of the methods in the first setup predicts that of the second: one sentence with Kendall's tau, or
/// that there are too few pairs to tell. Empty with fewer than two setups or two methods.
std::string setupsAgreement(const std::vector<SetupResults>& setups);

/// One page for all of them: the table, the agreement, then every setup's own part.
std::string setupsReportHtml(const std::vector<ReportContent>& setups);

} // namespace core
