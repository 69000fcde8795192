// SPDX-License-Identifier: MIT
#include "widgets/jobs/benchmark/benchmark_files.h"

#include <algorithm>

#include "core/benchmark/scene_fingerprint.h"
#include "core/error.h"
#include "core/io/benchmark/benchmark_scene.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr LocalText fileWords{"widgets::BenchmarkRunner"};

QString objectionTo(const std::filesystem::path& folder, const core::BenchmarkFolder& content) {
    if (std::filesystem::exists(folder / "run.json")) {
        core::BenchmarkRunInfo there = core::readRunInfo(folder);
        there.dataset = content.info.dataset;
        return there == content.info ? QString()
                                     : fileWords(QT_TRANSLATE_NOOP(
                                           "widgets::BenchmarkRunner",
                                           "This folder holds the results of another benchmark. Choose another one."));
    }
    for (const char* file : {"results.csv", "joints.csv", "curves.csv", "table.md", "table.tex", "report.html",
                             "pairs.json", "finished.jsonl"}) {
        if (std::filesystem::exists(folder / file))
            return fileWords(QT_TRANSLATE_NOOP("widgets::BenchmarkRunner",
                                               "This folder already holds a file %1. Choose another one."))
                .arg(QLatin1String(file));
    }
    return {};
}

} // namespace

std::vector<core::BenchmarkFolder> filledFolders(std::vector<core::BenchmarkFolder> folders) {
    const auto first = folders.front();
    std::erase_if(folders, [](const core::BenchmarkFolder& folder) { return folder.results.rows.empty(); });
    return folders.empty() ? std::vector{first} : folders;
}

QString resultsObjection(const std::filesystem::path& folder, const std::vector<core::BenchmarkFolder>& contents) {
    if (contents.size() == 1)
        return objectionTo(folder, contents.front());
    if (std::filesystem::exists(folder / "run.json"))
        return fileWords(QT_TRANSLATE_NOOP("widgets::BenchmarkRunner",
                                           "This folder holds the results of another benchmark. Choose another one."));
    for (const core::BenchmarkFolder& content : contents)
        if (const QString why = objectionTo(core::setupFolder(folder, content.info.setup), content); !why.isEmpty())
            return why;
    for (const char* file : {"table.md", "table.tex", "report.html"})
        if (!core::holdsBothSetups(folder) && std::filesystem::exists(folder / file))
            return fileWords(QT_TRANSLATE_NOOP("widgets::BenchmarkRunner",
                                               "This folder already holds a file %1. Choose another one."))
                .arg(QLatin1String(file));
    return {};
}

void writeResults(const std::filesystem::path& folder, std::vector<core::BenchmarkFolder> contents) {
    for (core::BenchmarkFolder& content : contents) {
        core::sortRows(content.results); // rows of a run that goes on stand in the order in which they came
        core::writeBenchmarkFolder(contents.size() == 1 ? folder : core::setupFolder(folder, content.info.setup),
                                   content);
    }
    if (contents.size() > 1)
        core::writeSetupTables(folder, contents);
}

std::vector<core::BenchmarkFolder> readResults(const std::filesystem::path& folder) {
    if (!core::holdsBothSetups(folder))
        return {core::readBenchmarkFolder(folder)};
    return {core::readBenchmarkFolder(core::setupFolder(folder, core::BenchmarkSetup::Synthetic)),
            core::readBenchmarkFolder(core::setupFolder(folder, core::BenchmarkSetup::Realistic))};
}

bool areResultsOf(const core::BenchmarkRunInfo& info, const core::Dataset& dataset) {
    std::vector<std::string> sequences;
    for (const core::FramePair& pair : info.pairs)
        if (std::find(sequences.begin(), sequences.end(), pair.sequence) == sequences.end())
            sequences.push_back(pair.sequence);
    try {
        if (core::sceneFingerprint(core::readBenchmarkScene(dataset, sequences, info.setup)) == info.fingerprint)
            return true;
        return core::sceneFingerprint(core::readBenchmarkScene(dataset, {}, info.setup)) ==
               info.fingerprint;   // the run may have drawn nothing from one
    } catch (const core::Error&) { // it lacks what they need
        return false;
    }
}

} // namespace widgets
