// SPDX-License-Identifier: MIT
#include "core/benchmark/result_table.h"

#include <algorithm>
#include <string_view>

#include "core/benchmark/metrics.h"
#include "core/benchmark/paper_results.h"
#include "core/text/html_text.h"
#include "core/text/number_text.h"

namespace core {

namespace {

using Cell = ResultTable::Cell;
using Row = ResultTable::Row;

Cell errorCell(const ErrorStatistics& statistics) {
    return statistics.pairs == 0 ? Cell{} : Cell{fixedText(statistics.meanMm, 2), fixedText(statistics.stdMm, 2)};
}

Cell errorCell(const std::optional<PublishedError>& error) {
    return error ? Cell{fixedText(error->meanMm, 1), fixedText(error->stdMm, 1)} : Cell{};
}

Row initialRow(const BenchmarkResults& results, const std::vector<int>& differences) {
    Row row{"initial", {}, false};
    for (const int difference : differences)
        row.cells.push_back(errorCell(initialStatistics(results, difference)));
    row.cells.push_back(errorCell(initialStatistics(results)));
    row.cells.push_back({});
    return row;
}

Row methodRow(const BenchmarkResults& results, const std::string& method, const std::vector<int>& differences) {
    Row row{method, {}, false};
    for (const int difference : differences)
        row.cells.push_back(errorCell(errorStatistics(results, method, difference)));
    const ErrorStatistics all = errorStatistics(results, method);
    const bool isExternal =
        std::find(results.external.begin(), results.external.end(), method) != results.external.end();
    row.cells.push_back(errorCell(all));
    row.cells.push_back(isExternal || all.pairs == 0 ? Cell{} : Cell{fixedText(all.meanSeconds, 3), ""});
    return row;
}

Row publishedRow(const PublishedRow& published, const std::vector<int>& differences) {
    Row row{published.name + " (paper)", {}, true};
    for (const int difference : differences) {
        const auto* at = std::find(std::begin(kPublishedDifferences), std::end(kPublishedDifferences), difference);
        const auto index = static_cast<std::size_t>(at - std::begin(kPublishedDifferences));
        row.cells.push_back(at == std::end(kPublishedDifferences) ? Cell{} : errorCell(published.byDifference[index]));
    }
    // The paper's mean over all pairs is one over its own differences.
    const bool isSame = std::equal(differences.begin(), differences.end(), std::begin(kPublishedDifferences),
                                   std::end(kPublishedDifferences));
    row.cells.push_back(isSame ? errorCell(published.all) : Cell{});
    row.cells.push_back(published.seconds ? Cell{fixedText(*published.seconds, 0), ""} : Cell{});
    return row;
}

/// The method whose row of the paper belongs here: options other than the schedule make it another one.
std::string publishedName(const std::string& method) {
    constexpr std::string_view kSchedule = ":schedule=paper";
    return method.ends_with(kSchedule) ? method.substr(0, method.size() - kSchedule.size()) : method;
}

std::string plain(const Cell& cell, const std::string& plusMinus) {
    return cell.std.empty() ? cell.mean : cell.mean + plusMinus + cell.std;
}

std::string latexEscaped(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (std::string_view("#$%&_{}").find(c) != std::string_view::npos)
            escaped += '\\';
        escaped += c;
    }
    return escaped;
}

} // namespace

ResultTable resultTable(const BenchmarkResults& results, BenchmarkSetup setup) {
    const std::vector<int> differences = differencesOf(results);
    ResultTable table;
    for (const int difference : differences)
        table.columns.push_back(std::to_string(difference));
    table.columns.insert(table.columns.end(), {"All", "s/pair"});
    std::vector<PublishedRow> published = results.papersHands ? publishedRows(setup) : std::vector<PublishedRow>{};
    const auto addPublished = [&](const std::string& method) {
        for (const PublishedRow& row : published)
            if (row.method == publishedName(method))
                table.rows.push_back(publishedRow(row, differences));
        std::erase_if(published, [&](const PublishedRow& row) { return row.method == publishedName(method); });
    };
    table.rows.push_back(initialRow(results, differences));
    addPublished("initial");
    for (const std::string& method : results.methods) {
        table.rows.push_back(methodRow(results, method, differences));
        addPublished(method);
    }
    return table;
}

std::string markdownTable(const ResultTable& table) {
    std::string text = "| method |";
    std::string rule = "|---|";
    for (const std::string& column : table.columns) {
        text += " " + column + " |";
        rule += "---:|";
    }
    text += "\n" + rule + "\n";
    for (const Row& row : table.rows) {
        text += "| " + row.name + " |";
        for (const Cell& cell : row.cells)
            text += " " + plain(cell, " ± ") + " |";
        text += "\n";
    }
    return text;
}

std::string latexTable(const ResultTable& table) {
    std::string text = "\\begin{tabular}{l" + std::string(table.columns.size(), 'r') + "}\n\\hline\nmethod";
    for (const std::string& column : table.columns)
        text += " & " + latexEscaped(column);
    text += " \\\\\n\\hline\n";
    for (const Row& row : table.rows) {
        text += row.published ? "\\emph{" + latexEscaped(row.name) + "}" : latexEscaped(row.name);
        for (const Cell& cell : row.cells)
            text += cell.mean.empty() ? " & " : " & $" + plain(cell, " \\pm ") + "$";
        text += " \\\\\n";
    }
    return text + "\\hline\n\\end{tabular}\n";
}

std::string htmlTable(const ResultTable& table) {
    std::string text = "<table>\n<thead><tr><th>method</th>";
    for (const std::string& column : table.columns)
        text += "<th>" + htmlEscaped(column) + "</th>";
    text += "</tr></thead>\n<tbody>\n";
    for (const Row& row : table.rows) {
        text += row.published ? "<tr class=\"paper\"><th>" : "<tr><th>";
        text += htmlEscaped(row.name) + "</th>";
        for (const Cell& cell : row.cells)
            text += "<td>" + plain(cell, " ± ") + "</td>";
        text += "</tr>\n";
    }
    return text + "</tbody>\n</table>\n";
}

} // namespace core
