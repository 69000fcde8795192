// SPDX-License-Identifier: MIT
#include "core/benchmark/setups_report.h"

#include <algorithm>
#include <cmath>

#include "core/benchmark/metrics.h"
#include "core/benchmark/paper_results.h"
#include "core/text/html_text.h"
#include "core/text/number_text.h"

namespace core {

namespace {

using Row = ResultTable::Row;

std::string setupName(BenchmarkSetup setup) {
    return setup == BenchmarkSetup::Synthetic ? "synthetic" : "realistic";
}

/// The paper's rows that belong to no method of ours.
void addOtherPublishedRows(ResultTable& table, const SetupResults& setup) {
    if (!setup.results->papersHands)
        return;
    const std::vector<int> differences = differencesOf(*setup.results);
    for (const PublishedRow& published : publishedRows(setup.setup)) {
        if (!published.method.empty())
            continue;
        Row row{published.name + " (paper)", std::vector<ResultTable::Cell>(table.columns.size()), true};
        for (std::size_t i = 0; i < differences.size(); ++i) {
            const auto* at =
                std::find(std::begin(kPublishedDifferences), std::end(kPublishedDifferences), differences[i]);
            if (at == std::end(kPublishedDifferences))
                continue;
            const auto& error = published.byDifference[static_cast<std::size_t>(at - kPublishedDifferences)];
            if (error)
                row.cells[i] = {fixedText(error->meanMm, 1), fixedText(error->stdMm, 1)};
        }
        table.rows.push_back(std::move(row));
    }
}

/// Where the row of that name is; a new one, after the row `previous`, if there is none.
std::size_t rowNamed(ResultTable& table, const Row& like, std::size_t previous) {
    const auto found =
        std::find_if(table.rows.begin(), table.rows.end(), [&](const Row& row) { return row.name == like.name; });
    if (found != table.rows.end())
        return static_cast<std::size_t>(found - table.rows.begin());
    const std::size_t at = std::min(previous + 1, table.rows.size());
    table.rows.insert(table.rows.begin() + static_cast<std::ptrdiff_t>(at), Row{like.name, {}, like.published});
    return at;
}

/// The methods of ours that all setups have.
std::vector<std::string> commonMethods(const std::vector<SetupResults>& setups) {
    std::vector<std::string> methods = setups.front().results->methods;
    for (const SetupResults& setup : setups) {
        std::erase_if(
            methods, [&](const std::string& method) { return errorStatistics(*setup.results, method).pairs == 0; });
    }
    return methods;
}

/// Figures of several setups stand in one page: what their SVGs name must differ.
std::vector<Figure> namedApart(std::vector<Figure> figures, const std::string& prefix) {
    for (Figure& figure : figures)
        figure.id = prefix + "-" + figure.id;
    return figures;
}

} // namespace

ResultTable setupsTable(const std::vector<SetupResults>& setups) {
    ResultTable all;
    for (const SetupResults& setup : setups) {
        ResultTable table = resultTable(*setup.results, setup.setup);
        addOtherPublishedRows(table, setup);
        const std::size_t before = all.columns.size();
        for (const std::string& column : table.columns)
            all.columns.push_back(setupName(setup.setup) + " " + column);
        std::size_t previous = all.rows.size();
        for (const Row& row : table.rows) {
            previous = rowNamed(all, row, previous);
            Row& target = all.rows[previous];
            target.cells.resize(before);
            target.cells.insert(target.cells.end(), row.cells.begin(), row.cells.end());
        }
    }
    for (Row& row : all.rows)
        row.cells.resize(all.columns.size());
    return all;
}

std::optional<RankAgreement> setupsRankAgreement(const std::vector<SetupResults>& setups) {
    const bool areFew = std::any_of(setups.begin(), setups.end(), [](const SetupResults& setup) {
        return setup.results->pairs.size() < kLeastRankedPairs;
    });
    if (setups.size() < 2 || areFew)
        return std::nullopt;
    const std::vector<std::string> methods = commonMethods(setups);
    if (methods.size() < 2)
        return std::nullopt;
    const RankAgreement agreement = rankAgreement(*setups[0].results, *setups[1].results, methods);
    return std::isnan(agreement.tau) ? std::nullopt : std::optional(agreement);
}

std::string setupsAgreement(const std::vector<SetupResults>& setups) {
    const std::vector<std::string> methods = setups.size() < 2 ? std::vector<std::string>{} : commonMethods(setups);
    if (methods.size() < 2)
        return "";
    const auto found = setupsRankAgreement(setups);
    if (!found) {
        return "Whether the order on " + setupName(setups[0].setup) + " data predicts the order on " +
               setupName(setups[1].setup) + " data cannot be told from " +
               std::to_string(setups[0].results->pairs.size()) + " and " +
               std::to_string(setups[1].results->pairs.size()) + " pairs.";
    }
    const RankAgreement& agreement = *found;
    std::string text = "Does the order on " + setupName(setups[0].setup) + " data predict the order on " +
                       setupName(setups[1].setup) + " data? Kendall's tau is " + fixedText(agreement.tau, 2) +
                       " (95 % of it between " + fixedText(agreement.low, 2) + " and " + fixedText(agreement.high, 2) +
                       "; 1 is the same order, 0 says nothing).";
    for (const SetupResults& setup : setups)
        text += " " + setupName(setup.setup) + ": " + orderText(*setup.results, methods) + ".";
    return text;
}

std::string setupsReportHtml(const std::vector<ReportContent>& setups) {
    std::vector<SetupResults> results;
    for (const ReportContent& content : setups)
        results.push_back({content.setup, content.results});
    std::string text = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<title>Handlens benchmark</title>\n<style>\n" +
                       std::string(kReportStyle) +
                       "</style>\n</head>\n<body>\n<h1>Hand pose from silhouettes: comparison of methods</h1>\n"
                       "<p>Mean ± standard deviation in mm. Each setup draws its test frames among its own, and takes "
                       "its errors over its own joints: compare methods within a setup.</p>\n";
    text += htmlTable(setupsTable(results));
    if (const std::string agreement = setupsAgreement(results); !agreement.empty())
        text += "<p>" + htmlEscaped(agreement) + "</p>\n";
    for (const ReportContent& content : setups) {
        ReportContent part = content;
        part.figures = namedApart(content.figures, setupName(content.setup));
        text += "<h1>" + std::string(content.setup == BenchmarkSetup::Synthetic ? "Synthetic" : "Realistic") +
                " setup</h1>\n" + reportBodyHtml(part);
    }
    return text + "</body>\n</html>\n";
}

} // namespace core
