// SPDX-License-Identifier: MIT
#include "core/io/benchmark/benchmark_folder.h"

#include <algorithm>
#include <set>

#include "core/benchmark/report.h"
#include "core/benchmark/result_csv.h"
#include "core/benchmark/result_table.h"
#include "core/error.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/gnuplot.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// True if both are parts of one run.
bool sameRun(BenchmarkRunInfo a, const BenchmarkRunInfo& b) {
    a.shard.index = b.shard.index;
    a.dataset = b.dataset; // may be mounted elsewhere; the fingerprint says whether it is the same
    return a == b;
}

/// Fits that a shard still owes: with external estimates, those of the methods that are run.
std::size_t missingFits(const BenchmarkFolder& folder) {
    std::set<std::pair<FramePair, std::string>> finished;
    for (const PairResult& row : folder.results.rows)
        finished.emplace(row.pair, row.method);
    std::size_t missing = 0;
    for (const FramePair& pair : pairsOfShard(folder.info.pairs, folder.info.shard)) {
        for (const std::string& method : folder.info.methods) {
            const auto& external = folder.info.external;
            const bool isExternal = std::find(external.begin(), external.end(), method) != external.end();
            missing += isExternal || finished.contains({pair, method}) ? 0 : 1;
        }
    }
    return missing;
}

void requireAllShards(const std::vector<BenchmarkFolder>& parts, const std::vector<fs::path>& folders) {
    const int count = parts.front().info.shard.count;
    std::set<int> seen;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::string shard = std::to_string(parts[i].info.shard.index) + "/" + std::to_string(count);
        if (!sameRun(parts.front().info, parts[i].info)) {
            throw Error(ErrorCode::Usage, folders[i].string(), "run.json",
                        "belongs to another run than " + folders.front().string());
        }
        if (!seen.insert(parts[i].info.shard.index).second)
            throw Error(ErrorCode::Usage, folders[i].string(), "shard", shard + " is named twice");
        if (const std::size_t missing = missingFits(parts[i]); missing > 0) {
            throw Error(ErrorCode::Usage, folders[i].string(), "shard",
                        shard + " is not finished: " + std::to_string(missing) + " fits are missing; run it again");
        }
    }
    for (int i = 0; i < count; ++i)
        if (!seen.contains(i))
            throw Error(ErrorCode::Usage, "", "shard", std::to_string(i) + "/" + std::to_string(count) + " is missing");
}

/// The ids in an SVG follow its name: figures of several setups on one page need different ones.
std::string withPrefixedName(std::string gnuplot, const std::string& prefix) {
    const std::string name = "sans-serif,13' name '"; // as gnuplotPreamble writes it
    if (const std::size_t at = gnuplot.find(name); at != std::string::npos)
        gnuplot.insert(at + name.size(), prefix);
    return gnuplot;
}

ReportContent reportContent(const BenchmarkFolder& content, const std::string& prefix = {}) {
    ReportContent report{content.info.dataset, content.info.setup, content.info.sweep, &content.results, {}, {}};
    report.figures = reportFigures(content.results, content.info.sweep);
    std::vector<std::string> programs;
    for (const Figure& figure : report.figures)
        programs.push_back(withPrefixedName(figure.gnuplot, prefix));
    report.pictures = drawWithGnuplot(programs);
    return report;
}

} // namespace

BenchmarkFolder readBenchmarkFolder(const fs::path& folder) {
    BenchmarkFolder content;
    content.info = readRunInfo(folder);
    content.results.joints = content.info.joints;
    content.results.pairs = content.info.pairs;
    content.results.methods = content.info.methods;
    content.results.external = content.info.external;
    content.results.papersHands = content.info.papersHands;
    const std::set<std::string> methods(content.info.methods.begin(), content.info.methods.end());
    const std::set<FramePair> pairs(content.info.pairs.begin(), content.info.pairs.end());
    for (PairResult& row : readFinishedRows(folder, content.info.joints.size()))
        if (methods.contains(row.method) && pairs.contains(row.pair))
            content.results.rows.push_back(std::move(row));
    sortRows(content.results);
    content.results.stopped = missingFits(content) > 0;
    return content;
}

BenchmarkFolder mergedBenchmarkFolders(const std::vector<fs::path>& folders) {
    std::vector<BenchmarkFolder> parts;
    for (const fs::path& folder : folders)
        parts.push_back(readBenchmarkFolder(folder));
    if (parts.empty())
        throw Error(ErrorCode::Usage, "", "merge", "needs at least one folder");
    requireAllShards(parts, folders);
    BenchmarkFolder merged = parts.front();
    for (std::size_t i = 1; i < parts.size(); ++i) {
        std::vector<PairResult>& rows = parts[i].results.rows;
        merged.results.rows.insert(merged.results.rows.end(), rows.begin(), rows.end());
    }
    merged.info.shard = {};
    sortRows(merged.results);
    return merged;
}

void writeBenchmarkTables(const fs::path& folder, const BenchmarkFolder& content) {
    const ResultTable table = resultTable(content.results, content.info.setup);
    ensureFolder(folder);
    writeFileAtomically(folder / "results.csv", resultsCsv(content.results));
    writeFileAtomically(folder / "joints.csv", jointsCsv(content.results));
    writeFileAtomically(folder / "curves.csv", curvesCsv(content.results));
    const std::size_t missing = missingFits(content);
    const std::string note =
        missing > 0 ? "\nNot finished: " + std::to_string(missing) + " fits are missing.\n" : std::string();
    writeFileAtomically(folder / "table.md", markdownTable(table) + note);
    writeFileAtomically(folder / "table.tex", latexTable(table));
    writeFileAtomically(folder / "report.html", reportHtml(reportContent(content)));
}

std::vector<SetupResults> setupResults(const std::vector<BenchmarkFolder>& folders) {
    std::vector<SetupResults> setups;
    for (const BenchmarkFolder& folder : folders)
        setups.push_back({folder.info.setup, &folder.results});
    return setups;
}

fs::path setupFolder(const fs::path& folder, BenchmarkSetup setup) {
    return folder / (setup == BenchmarkSetup::Synthetic ? "synthetic" : "realistic");
}

bool holdsBothSetups(const fs::path& folder) {
    return !fs::exists(folder / "run.json") &&
           fs::exists(setupFolder(folder, BenchmarkSetup::Synthetic) / "run.json") &&
           fs::exists(setupFolder(folder, BenchmarkSetup::Realistic) / "run.json");
}

void writeSetupTables(const fs::path& folder, const std::vector<BenchmarkFolder>& setups) {
    const std::vector<SetupResults> results = setupResults(setups);
    const ResultTable table = setupsTable(results);
    const std::string agreement = setupsAgreement(results);
    ensureFolder(folder);
    writeFileAtomically(folder / "table.md", markdownTable(table) + (agreement.empty() ? "" : "\n" + agreement + "\n"));
    writeFileAtomically(folder / "table.tex", latexTable(table));
    std::vector<ReportContent> parts;
    for (const BenchmarkFolder& setup : setups)
        parts.push_back(
            reportContent(setup, setup.info.setup == BenchmarkSetup::Synthetic ? "synthetic_" : "realistic_"));
    writeFileAtomically(folder / "report.html", setupsReportHtml(parts));
}

void writeBenchmarkFolder(const fs::path& folder, const BenchmarkFolder& content) {
    ensureFolder(folder);
    writeRunInfo(folder, content.info);
    writeFinishedRows(folder, content.results.rows);
    writeBenchmarkTables(folder, content);
}

} // namespace core
