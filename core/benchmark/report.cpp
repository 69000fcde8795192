// SPDX-License-Identifier: MIT
#include "core/benchmark/report.h"

#include <algorithm>

#include "core/benchmark/findings.h"
#include "core/benchmark/metrics.h"
#include "core/benchmark/result_table.h"
#include "core/benchmark/sweep.h"
#include "core/fitting/method_name.h"
#include "core/text/html_text.h"
#include "core/text/number_text.h"
#include "core/text/shell_text.h"

namespace core {

namespace {

constexpr std::size_t kWorstPairsOfMethod = 5; ///< listed per method

std::string introduction(const ReportContent& content) {
    const BenchmarkResults& results = *content.results;
    std::string text = "<p>" + std::to_string(results.pairs.size()) + " frame pairs, " +
                       std::to_string(results.methods.size()) + " methods, " + std::to_string(results.joints.size()) +
                       " joints. ";
    text += content.setup == BenchmarkSetup::Synthetic
                ? "Synthetic setup: targets are rendered from the recorded pose of the test frame; errors are over all "
                  "named joints."
                : "Realistic setup: targets come from the pictures; errors are over the annotated joints.";
    text +=
        " Mean ± standard deviation in mm for start poses that many frames away; seconds per pair run from masks in "
        "memory to the final pose on one thread.</p>\n";
    if (results.stopped) {
        text += "<p class=\"no\">This run was stopped before its end: " + std::to_string(results.rows.size()) +
                " rows are in.</p>\n";
    }
    return text;
}

std::string findingCell(const Finding& finding) {
    const char* kind = finding.verdict == Verdict::Reproduced      ? "yes"
                       : finding.verdict == Verdict::NotReproduced ? "no"
                                                                   : "open";
    return "<td class=\"text\"><b class=\"" + std::string(kind) + "\">" + std::string(verdictName(finding.verdict)) +
           "</b><br>" + htmlEscaped(finding.numbers) + "</td>";
}

std::string findingsHtml(const ReportContent& content) {
    const auto paper = findings(*content.results, content.setup, Schedule::Paper);
    const auto ours = findings(*content.results, content.setup, Schedule::RigidFirst);
    std::string text =
        "<h2>Findings of the paper</h2>\n<p>Mean errors over all pairs, mm.</p>\n<table>\n<thead><tr><th>claim</th>"
        "<th>the paper's schedule</th><th>rigid phase first (default)</th></tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < paper.size(); ++i)
        text += "<tr>" + htmlTextCell(paper[i].claim) + findingCell(paper[i]) + findingCell(ours[i]) + "</tr>\n";
    return text + "</tbody>\n</table>\n";
}

std::string optionRow(const BenchmarkResults& results, const OpenOption& option, const std::string& variant) {
    const ErrorStatistics base = errorStatistics(results, option.method);
    const ErrorStatistics other = errorStatistics(results, variant);
    std::string row = "<tr>" + htmlTextCell(option.name) + htmlTextCell(option.what) +
                      htmlTextCell(option.defaultValue) + htmlTextCell(option.source) + htmlTextCell(variant);
    if (base.pairs == 0 || other.pairs == 0)
        return row + "<td></td><td></td><td></td><td></td></tr>\n";
    return row + htmlNumberCell(other.meanMm, 2) + htmlNumberCell(other.meanMm - base.meanMm, 2) +
           htmlNumberCell(other.meanSeconds, 3) + htmlNumberCell(1000 * (other.meanSeconds - base.meanSeconds), 0) +
           "</tr>\n";
}

std::string optionsHtml(const BenchmarkResults& results) {
    std::string text =
        "<h2>Options that the paper leaves open</h2>\n<p>What each changes against its default, over all pairs.</p>\n"
        "<table>\n<thead><tr><th>option</th><th>what it decides</th><th>default</th><th>source</th><th>tried</th>"
        "<th>mm</th><th>± mm</th><th>s/pair</th><th>± ms</th></tr></thead>\n<tbody>\n";
    for (const OpenOption& option : openOptions())
        for (const std::string& variant : option.variants)
            text += optionRow(results, option, withOptions(variant, {}));
    return text + "</tbody>\n</table>\n";
}

/// What an option of `best` gains and costs: with it against without it.
std::string variantRow(const BenchmarkResults& results, const BestVariant& tried) {
    const ErrorStatistics best = errorStatistics(results, "best");
    const ErrorStatistics variant = errorStatistics(results, tried.variant);
    std::string row = "<tr>" + htmlTextCell(tried.what) + htmlTextCell(tried.kept ? "part of best" : "left out") +
                      htmlTextCell(tried.variant);
    if (best.pairs == 0 || variant.pairs == 0)
        return row + "<td></td><td></td><td></td><td></td></tr>\n";
    const ErrorStatistics& with = tried.kept ? best : variant;
    const ErrorStatistics& without = tried.kept ? variant : best;
    return row + htmlNumberCell(variant.meanMm, 3) + htmlNumberCell(variant.worstMm, 2) +
           htmlNumberCell(without.meanMm - with.meanMm, 3) +
           htmlNumberCell(1000 * (with.meanSeconds - without.meanSeconds), 0) + "</tr>\n";
}

std::string bestVariantsHtml(const BenchmarkResults& results) {
    const ErrorStatistics best = errorStatistics(results, "best");
    std::string text = "<h2>What best is made of</h2>\n<p>Each option switched the other way, alone. Gain: how much "
                       "lower the mean error is "
                       "with it than without it; cost: how much longer a pair takes with it.";
    if (best.pairs > 0) {
        text += " best itself: " + fixedText(best.meanMm, 3) + " mm, worst pair " + fixedText(best.worstMm, 2) +
                " mm, " + fixedText(best.meanSeconds, 3) + " s.";
    }
    text += "</p>\n<table>\n<thead><tr><th>option</th><th>verdict</th><th>tried</th><th>mm</th><th>worst, "
            "mm</th><th>gain, mm</th>"
            "<th>cost, ms</th></tr></thead>\n<tbody>\n";
    for (const BestVariant& tried : bestVariants())
        text += variantRow(results, tried);
    return text + "</tbody>\n</table>\n";
}

std::string worstHtml(const ReportContent& content) {
    std::string text =
        "<h2>Worst pairs</h2>\n<table>\n<thead><tr><th>method</th><th>sequence</th><th>start</th><th>test</th>"
        "<th>before, mm</th><th>after, mm</th><th>open it</th></tr></thead>\n<tbody>\n";
    for (const std::string& method : headlineMethods(*content.results)) {
        for (const PairResult& row : worstPairs(*content.results, method, kWorstPairsOfMethod)) {
            text += "<tr>" + htmlTextCell(method) + htmlTextCell(row.pair.sequence) + "<td>" +
                    std::to_string(row.pair.start) + "</td><td>" + std::to_string(row.pair.test) + "</td>" +
                    htmlNumberCell(row.initialErrorMm, 2) + htmlNumberCell(row.errorMm, 2) +
                    "<td class=\"text\"><code>" + htmlEscaped(openCommand(content.dataset, row.pair)) +
                    "</code></td></tr>\n";
        }
    }
    return text + "</tbody>\n</table>\n";
}

/// The part of the results under one schedule, for a table of its own. `best` stands in both for comparison, its
/// variants only in ours.
BenchmarkResults underScheduleOnly(const BenchmarkResults& results, Schedule schedule) {
    BenchmarkResults part = results;
    std::erase_if(part.methods, [&](const std::string& method) {
        const auto& external = results.external;
        const bool isExternal = std::find(external.begin(), external.end(), method) != external.end();
        if (isExternal)
            return false;
        const Method m = parseMethod(method);
        const bool isPlainBest = m.best && (*m.best == BestOptions{} || *m.best == BestOptions{.live = true});
        return m.best ? schedule == Schedule::Paper && !isPlainBest : m.schedule != schedule;
    });
    return part;
}

bool hasPaperSchedule(const BenchmarkResults& results) {
    const BenchmarkResults ours =
        underScheduleOnly(results, Schedule::RigidFirst); // holds whatever has no schedule, too
    return ours.methods.size() < results.methods.size();
}

std::string tablesHtml(const ReportContent& content) {
    const BenchmarkResults& results = *content.results;
    if (!hasPaperSchedule(results))
        return htmlTable(resultTable(results, content.setup));
    return "<h2>Rigid phase first (default)</h2>\n" +
           htmlTable(resultTable(underScheduleOnly(results, Schedule::RigidFirst), content.setup)) +
           "<h2>The paper's schedule</h2>\n" +
           htmlTable(resultTable(underScheduleOnly(results, Schedule::Paper), content.setup));
}

} // namespace

std::vector<Figure> reportFigures(const BenchmarkResults& results, bool sweep) {
    std::vector<Figure> figures = overviewFigures(results, headlineMethods(results));
    if (sweep) {
        const std::vector<Figure> more = sweepResultFigures(results);
        figures.insert(figures.end(), more.begin(), more.end());
    }
    return figures;
}

std::string openCommand(const std::string& dataset, const FramePair& pair) {
    return "handlens " + shellWord(dataset) + " --sequence " + shellWord(pair.sequence) + " --frame " +
           std::to_string(pair.test);
}

std::string reportBodyHtml(const ReportContent& content) {
    std::string text = introduction(content) + tablesHtml(content);
    if (content.sweep)
        text += findingsHtml(content);
    text += figuresHtml(content.figures, content.pictures ? &*content.pictures : nullptr, "nothing is computed twice");
    if (content.sweep)
        text += optionsHtml(*content.results) + bestVariantsHtml(*content.results);
    return text + worstHtml(content);
}

std::string reportHtml(const ReportContent& content) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<title>Handlens benchmark</title>\n<style>\n" +
           std::string(kReportStyle) +
           "</style>\n</head>\n<body>\n<h1>Hand pose from silhouettes: comparison of methods</h1>\n" +
           reportBodyHtml(content) + "</body>\n</html>\n";
}

} // namespace core
