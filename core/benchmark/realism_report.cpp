// SPDX-License-Identifier: MIT
#include "core/benchmark/realism_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/benchmark/figures.h"
#include "core/benchmark/metrics.h"
#include "core/benchmark/report.h"
#include "core/benchmark/result_table.h"
#include "core/text/csv_line.h"
#include "core/text/html_text.h"
#include "core/text/number_text.h"

namespace core {

namespace {

constexpr std::size_t kWorstPairsOfSetting = 3; ///< listed per setting, of the last method

const RealismResult* cleanOf(const std::vector<RealismResult>& results) {
    const auto found = std::find_if(results.begin(), results.end(),
                                    [](const RealismResult& one) { return one.setting.axis == "clean"; });
    return found == results.end() ? nullptr : &*found;
}

std::string tauText(const std::optional<RankAgreement>& agreement) {
    if (!agreement || std::isnan(agreement->tau))
        return "";
    return fixedText(agreement->tau, 2) + " (" + fixedText(agreement->low, 2) + " to " + fixedText(agreement->high, 2) +
           ")";
}

/// Settings as a table: the "method" column holds the setting's title.
ResultTable tableOf(const std::vector<RealismResult>& results, const std::vector<std::string>& methods) {
    ResultTable table;
    table.columns = methods;
    table.columns.insert(table.columns.end(),
                         {"s/pair of " + (methods.empty() ? std::string("none") : methods.back()), "tau (95 %)"});
    for (const RealismResult& one : results) {
        ResultTable::Row row{one.setting.title, {}, false};
        for (const std::string& method : methods) {
            const ErrorStatistics statistics = errorStatistics(one.results, method);
            row.cells.push_back(statistics.pairs == 0 ? ResultTable::Cell{}
                                                      : ResultTable::Cell{fixedText(statistics.meanMm, 2),
                                                                          fixedText(statistics.stdMm, 2)});
        }
        const ErrorStatistics last = methods.empty() ? ErrorStatistics{} : errorStatistics(one.results, methods.back());
        row.cells.push_back(last.pairs == 0 ? ResultTable::Cell{}
                                            : ResultTable::Cell{fixedText(last.meanSeconds, 3), ""});
        row.cells.push_back({tauText(one.agreement), ""});
        table.rows.push_back(std::move(row));
    }
    return table;
}

Figure axisFigure(const std::vector<RealismResult>& results, const std::vector<std::string>& methods,
                  const std::string& axis) {
    std::vector<PlotLine> lines;
    for (const std::string& method : methods) {
        PlotLine line{method, methodColour(results.front().results, method), {}};
        for (const RealismResult& one : results) {
            const ErrorStatistics statistics = errorStatistics(one.results, method);
            if ((one.setting.axis == axis || one.setting.axis == "clean") && statistics.pairs > 0)
                line.points.push_back({one.setting.value, statistics.meanMm});
        }
        lines.push_back(std::move(line));
    }
    return {"realism-" + axis, "Error over " + realismAxisLabel(axis),
            "Mean joint error over all pairs; everything else is perfect. Against the true joints.",
            gnuplotPreamble("realism-" + axis, realismAxisLabel(axis), "mean error (mm)") +
                "set yrange [0:*]\nset xrange [0:*]\n" + gnuplotPlot(lines)};
}

Figure agreementFigure(const std::vector<RealismResult>& results) {
    std::array<PlotLine, 3> lines{PlotLine{"tau", "#0072B2", {}, "points pt 7 ps 0.9"},
                                  PlotLine{"95 % from", "#9AA0A6", {}, "points pt 9 ps 0.6"},
                                  PlotLine{"95 % to", "#9AA0A6", {}, "points pt 11 ps 0.6"}};
    std::vector<std::string> names;
    for (const RealismResult& one : results) {
        if (!one.agreement || std::isnan(one.agreement->tau))
            continue;
        const auto x = static_cast<double>(names.size());
        lines[0].points.push_back({x, one.agreement->tau});
        lines[1].points.push_back({x, one.agreement->low});
        lines[2].points.push_back({x, one.agreement->high});
        names.push_back(one.setting.id);
    }
    return {"realism-order", "Does the order on synthetic data predict the order here?",
            "Kendall's tau between the order of the methods on clean synthetic data and in each setting: 1 is the same "
            "order, 0 says nothing, -1 is the reverse. The interval comes from drawing the frame pairs again.",
            gnuplotPreamble("realism-order", "", "Kendall's tau") +
                "set yrange [-1.05:1.05]\nset offsets 0.5, 0.5, 0, "
                "0\n" +
                gnuplotNamedTics(names) + gnuplotPlot({lines.begin(), lines.end()})};
}

std::string ordersHtml(const std::vector<RealismResult>& results, const std::vector<std::string>& methods) {
    std::string text = "<h2>Orders of the methods</h2>\n<table>\n<thead><tr><th>setting</th><th>from the smallest mean "
                       "error</th><th>tau (95 %)</th></tr></thead>\n<tbody>\n";
    for (const RealismResult& one : results) {
        text += "<tr>" + htmlTextCell(one.setting.title) + htmlTextCell(orderText(one.results, methods)) +
                htmlTextCell(tauText(one.agreement)) + "</tr>\n";
    }
    return text + "</tbody>\n</table>\n";
}

std::string worstHtml(const std::string& dataset, const std::vector<RealismResult>& results,
                      const std::string& method) {
    std::string text = "<h2>Worst pairs of " + htmlEscaped(method) +
                       "</h2>\n<table>\n<thead><tr><th>setting</th><th>sequence</th><th>start</th><th>test</th>"
                       "<th>before, mm</th><th>after, mm</th><th>open it</th></tr></thead>\n<tbody>\n";
    for (const RealismResult& one : results) {
        for (const PairResult& row : worstPairs(one.results, method, kWorstPairsOfSetting)) {
            text += "<tr>" + htmlTextCell(one.setting.title) + htmlTextCell(row.pair.sequence) + "<td>" +
                    std::to_string(row.pair.start) + "</td><td>" + std::to_string(row.pair.test) + "</td>" +
                    htmlNumberCell(row.initialErrorMm, 2) + htmlNumberCell(row.errorMm, 2) +
                    "<td class=\"text\"><code>" + htmlEscaped(openCommand(dataset, row.pair)) + "</code></td></tr>\n";
        }
    }
    return text + "</tbody>\n</table>\n";
}

std::string valueOrEmpty(double value, int digits) {
    return std::isnan(value) ? std::string() : fixedText(value, digits);
}

} // namespace

void addAgreements(std::vector<RealismResult>& results, const std::vector<std::string>& methods) {
    const RealismResult* clean = cleanOf(results);
    for (RealismResult& one : results)
        if (clean != nullptr && &one != clean && methods.size() > 1)
            one.agreement = rankAgreement(clean->results, one.results, methods);
}

std::string realismCsv(const std::vector<RealismResult>& results, const std::vector<std::string>& methods) {
    std::string text = "setting,axis,value,clicked,adapted,method,pairs,mean_error_mm,std_mm,worst_mm,seconds,tau,"
                       "tau_low,tau_high\n";
    for (const RealismResult& one : results) {
        for (const std::string& method : methods) {
            const ErrorStatistics statistics = errorStatistics(one.results, method);
            if (statistics.pairs == 0)
                continue;
            const RankAgreement tau = one.agreement.value_or(RankAgreement{NAN, NAN, NAN});
            text += csvLine({one.setting.id, one.setting.axis, exactText(one.setting.value),
                             one.setting.isClicked ? "1" : "0", one.setting.isAdapted ? "1" : "0", method,
                             std::to_string(statistics.pairs), fixedText(statistics.meanMm, 6),
                             fixedText(statistics.stdMm, 6), fixedText(statistics.worstMm, 6),
                             fixedText(statistics.meanSeconds, 6), valueOrEmpty(tau.tau, 4), valueOrEmpty(tau.low, 4),
                             valueOrEmpty(tau.high, 4)});
        }
    }
    return text;
}

std::string realismMarkdown(const std::vector<RealismResult>& results, const std::vector<std::string>& methods) {
    std::string text = markdownTable(tableOf(results, methods));
    return "| setting |" + text.substr(std::string("| method |").size());
}

std::string realismLatex(const std::vector<RealismResult>& results, const std::vector<std::string>& methods) {
    return latexTable(tableOf(results, methods));
}

std::vector<Figure> realismFigures(const std::vector<RealismResult>& results, const std::vector<std::string>& methods) {
    std::vector<Figure> figures;
    for (const char* axis : {"contour", "rig", "hand"}) {
        const bool isMeasured = std::any_of(results.begin(), results.end(), [&](const RealismResult& one) {
            return one.setting.axis == axis && !one.results.rows.empty();
        });
        if (isMeasured)
            figures.push_back(axisFigure(results, methods, axis));
    }
    const bool anyOrder = std::any_of(results.begin(), results.end(), [](const RealismResult& one) {
        return one.agreement && !std::isnan(one.agreement->tau);
    });
    if (anyOrder)
        figures.push_back(agreementFigure(results));
    return figures;
}

std::string realismReportHtml(const std::string& dataset, const std::vector<RealismResult>& results,
                              const std::vector<std::string>& methods, const std::vector<Figure>& figures,
                              const std::optional<std::vector<std::string>>& pictures) {
    std::string text = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<title>Handlens benchmark: realism</title>\n<style>\n" +
                       std::string(kReportStyle) +
                       "</style>\n</head>\n<body>\n<h1>What realism does to the methods (simulated)</h1>\n";
    text +=
        "<p>" + std::to_string(results.empty() ? 0 : results.front().results.pairs.size()) +
        " frame pairs in every setting; errors are over the joints that people can click, mean ± standard deviation "
        "in mm. Silhouettes are simulated from the recorded motion: another hand than the model, seen by other "
        "cameras than the calibration says, with noise along the outline and a forearm. On the ladder (noise, "
        "forearm, other hand, casual rig) errors are against triangulated clicks with 1 px of noise, which alone "
        "are 0.4 mm; elsewhere against the true joints. Adapted: the rig was refined and the hands were measured "
        "from five annotated frames first. tau compares the order of the methods with that on clean synthetic "
        "data.</p>\n";
    std::string table = htmlTable(tableOf(results, methods));
    const std::string head = "<th>method</th>";
    table.replace(table.find(head), head.size(), "<th>setting</th>");
    text += table + ordersHtml(results, methods);
    text += figuresHtml(figures, pictures ? &*pictures : nullptr, "nothing is computed twice");
    if (!methods.empty())
        text += worstHtml(dataset, results, methods.back());
    return text + "</body>\n</html>\n";
}

} // namespace core
