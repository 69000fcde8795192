// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/benchmark/benchmark_results.h"
#include "core/benchmark/rank_agreement.h"
#include "core/benchmark/realism_settings.h"
#include "core/text/gnuplot_text.h"

namespace core {

/// What the methods made of one setting, and how far their order is that of the clean setting.
struct RealismResult {
    RealismSetting setting;
    BenchmarkResults results;
    std::optional<RankAgreement> agreement; ///< none for the clean setting itself, or without it
};

/// Compares every setting's order of the methods with that of the clean setting.
void addAgreements(std::vector<RealismResult>& results, const std::vector<std::string>& methods);

/// setting,axis,value,clicked,adapted,method,pairs,mean_error_mm,std_mm,worst_mm,seconds,tau,tau_low,tau_high
std::string realismCsv(const std::vector<RealismResult>& results, const std::vector<std::string>& methods);

/// One row per setting: mean error of every method in mm, seconds per pair of the last one, tau with its interval.
std::string realismMarkdown(const std::vector<RealismResult>& results, const std::vector<std::string>& methods);
std::string realismLatex(const std::vector<RealismResult>& results, const std::vector<std::string>& methods);

/// Error over each axis, one line per method; and the agreement of the orders, setting by setting.
std::vector<Figure> realismFigures(const std::vector<RealismResult>& results, const std::vector<std::string>& methods);

/// One page that needs no network. `pictures` as in ReportContent.
std::string realismReportHtml(const std::string& dataset, const std::vector<RealismResult>& results,
                              const std::vector<std::string>& methods, const std::vector<Figure>& figures,
                              const std::optional<std::vector<std::string>>& pictures);

} // namespace core
