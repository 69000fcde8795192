// SPDX-License-Identifier: MIT
#include "core/io/benchmark/benchmark_journal.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "core/benchmark/paper_results.h"
#include "core/benchmark/scene_fingerprint.h"
#include "core/error.h"
#include "core/io/benchmark/pairs_file.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/json_file.h"
#include "core/io/files/text_file.h"

namespace core {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

namespace {

constexpr const char* kRunFile = "run.json";
constexpr const char* kPairsFile = "pairs.json";
constexpr const char* kFinishedFile = "finished.jsonl";

ordered_json numberOrNull(double value) {
    return std::isnan(value) ? ordered_json(nullptr) : ordered_json(value);
}

double numberFrom(const json& value) {
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

std::string lineOf(const PairResult& row) {
    ordered_json joints = ordered_json::array();
    for (const double error : row.jointErrorsMm)
        joints.push_back(numberOrNull(error));
    const ordered_json line = {{"sequence", row.pair.sequence},
                               {"start", row.pair.start},
                               {"test", row.pair.test},
                               {"method", row.method},
                               {"initialErrorMm", numberOrNull(row.initialErrorMm)},
                               {"errorMm", numberOrNull(row.errorMm)},
                               {"iterations", row.iterations},
                               {"costRises", row.costRises},
                               {"seconds", row.seconds},
                               {"jointErrorsMm", joints}};
    return line.dump() + "\n";
}

PairResult rowFrom(const json& line) {
    PairResult row;
    row.pair = {line.at("sequence").get<std::string>(), line.at("start").get<int>(), line.at("test").get<int>()};
    row.method = line.at("method").get<std::string>();
    row.initialErrorMm = numberFrom(line.at("initialErrorMm"));
    row.errorMm = numberFrom(line.at("errorMm"));
    row.iterations = line.at("iterations").get<int>();
    row.costRises = line.at("costRises").get<int>();
    row.seconds = line.at("seconds").get<double>();
    for (const json& error : line.at("jointErrorsMm"))
        row.jointErrorsMm.push_back(numberFrom(error));
    return row;
}

/// What keeps the work of `now` from going on where `before` ended; empty if nothing does.
std::string obstacle(const BenchmarkRunInfo& before, const BenchmarkRunInfo& now) {
    if (before.fingerprint != now.fingerprint)
        return "another dataset, one that has changed since, or an earlier revision of the methods";
    if (before.setup != now.setup)
        return "the other setup";
    if (before.pairs != now.pairs || before.joints != now.joints)
        return "other frame pairs (sequences, fraction, differences or seed)";
    if (before.shard != now.shard)
        return "another shard";
    return "";
}

} // namespace

BenchmarkRunInfo describeRun(const std::string& dataset, const BenchmarkScene& scene, const BenchmarkOptions& options,
                             const std::vector<FramePair>& pairs) {
    BenchmarkRunInfo info;
    info.dataset = dataset;
    info.fingerprint = sceneFingerprint(scene);
    info.setup = options.setup;
    info.methods = options.methods;
    info.shard = options.shard;
    info.papersHands = isPapersHands(scene.hands);
    info.joints = benchmarkJoints(scene, options.setup);
    info.pairs = pairs;
    return info;
}

BenchmarkRunInfo readRunInfo(const fs::path& folder) {
    const json document = readOwnFile(folder / kRunFile, "benchmark-run");
    BenchmarkRunInfo info;
    info.dataset = document["dataset"].get<std::string>();
    info.fingerprint = document["fingerprint"].get<std::string>();
    info.setup = document["setup"] == "realistic" ? BenchmarkSetup::Realistic : BenchmarkSetup::Synthetic;
    info.methods = document["methods"].get<std::vector<std::string>>();
    info.external = document["external"].get<std::vector<std::string>>();
    info.shard = {document["shard"]["index"].get<int>(), document["shard"]["count"].get<int>()};
    info.sweep = document["sweep"].get<bool>();
    for (const json& joint : document["joints"])
        info.joints.push_back({*sideFromName(joint["hand"].get<std::string>()), joint["name"].get<std::string>()});
    const bool mayBePapers =
        std::all_of(info.joints.begin(), info.joints.end(), [](const JointId& id) { return isPapersJoint(id.joint); });
    info.papersHands = document.value("papersHands", mayBePapers); // earlier runs do not say
    info.pairs = readPairs(folder / kPairsFile);
    return info;
}

void writeRunInfo(const fs::path& folder, const BenchmarkRunInfo& info) {
    ordered_json joints = ordered_json::array();
    for (const JointId& id : info.joints)
        joints.push_back({{"hand", sideName(id.hand)}, {"name", id.joint}});
    writePairs(folder / kPairsFile, info.pairs);
    writeJsonFile(folder / kRunFile, {{"format", "handlens-benchmark-run"},
                                      {"version", 1},
                                      {"dataset", info.dataset},
                                      {"fingerprint", info.fingerprint},
                                      {"setup", info.setup == BenchmarkSetup::Realistic ? "realistic" : "synthetic"},
                                      {"methods", info.methods},
                                      {"external", info.external},
                                      {"shard", {{"index", info.shard.index}, {"count", info.shard.count}}},
                                      {"sweep", info.sweep},
                                      {"papersHands", info.papersHands},
                                      {"joints", joints}});
}

std::vector<PairResult> readFinishedRows(const fs::path& folder, std::size_t jointCount) {
    const fs::path file = folder / kFinishedFile;
    const std::string text = readTextFile(file);
    std::vector<PairResult> rows;
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
        try {
            rows.push_back(rowFrom(json::parse(text.begin() + static_cast<std::ptrdiff_t>(begin),
                                               text.begin() + static_cast<std::ptrdiff_t>(end))));
        } catch (const json::exception&) {
            throw Error(ErrorCode::BadInput, file.string(), "line " + std::to_string(rows.size() + 1),
                        "is not a finished fit");
        }
        if (rows.back().jointErrorsMm.size() != jointCount) {
            throw Error(ErrorCode::BadInput, file.string(), "line " + std::to_string(rows.size()),
                        "has errors of " + std::to_string(rows.back().jointErrorsMm.size()) + " joints, not of " +
                            std::to_string(jointCount));
        }
        begin = end + 1;
    }
    return rows;
}

void writeFinishedRows(const fs::path& folder, const std::vector<PairResult>& rows) {
    std::string text;
    for (const PairResult& row : rows)
        text += lineOf(row);
    writeFileAtomically(folder / kFinishedFile, text);
}

BenchmarkJournal::BenchmarkJournal(const fs::path& folder, const BenchmarkRunInfo& info)
    : m_file(folder / kFinishedFile) {
    ensureFolder(folder);
    if (fs::exists(folder / kRunFile)) {
        const std::string reason = obstacle(readRunInfo(folder), info);
        if (!reason.empty()) {
            throw Error(ErrorCode::Usage, folder.string(), "--out",
                        "holds the results of " + reason + "; choose another folder");
        }
        if (fs::exists(m_file)) {
            m_finished = readFinishedRows(folder, info.joints.size());
            std::erase_if(m_finished, [&](const PairResult& row) {
                return std::find(info.external.begin(), info.external.end(), row.method) != info.external.end();
            });
        }
    }
    writeRunInfo(folder, info);
    writeFinishedRows(folder, m_finished); // without a last line that was cut off
    m_stream = std::fopen(m_file.c_str(), "ab");
    if (m_stream == nullptr)
        throw Error(ErrorCode::Io, m_file.string(), "", "cannot be written");
}

BenchmarkJournal::~BenchmarkJournal() {
    if (m_stream != nullptr)
        std::fclose(m_stream);
}

void BenchmarkJournal::append(const PairResult& row) {
    const std::string line = lineOf(row);
    if (std::fwrite(line.data(), 1, line.size(), m_stream) != line.size() || std::fflush(m_stream) != 0)
        throw Error(ErrorCode::Io, m_file.string(), "", "cannot be written");
}

} // namespace core
