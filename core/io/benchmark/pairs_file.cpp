// SPDX-License-Identifier: MIT
#include "core/io/benchmark/pairs_file.h"

#include <set>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/json_file.h"

namespace core {

std::vector<FramePair> readPairs(const std::filesystem::path& file) {
    const nlohmann::json document = readJsonFile(file);
    checkSchema(document, "pairs", file.string());
    std::vector<FramePair> pairs;
    std::set<FramePair> seen;
    for (const nlohmann::json& entry : document["pairs"]) {
        const std::string field = "pairs[" + std::to_string(pairs.size()) + "]";
        const FramePair pair{entry["sequence"].get<std::string>(), entry["start"].get<int>(), entry["test"].get<int>()};
        if (entry.contains("difference") && entry["difference"].get<int>() != pair.difference())
            throw Error(ErrorCode::BadInput, file.string(), field + ".difference", "must be test - start");
        if (!seen.insert(pair).second)
            throw Error(ErrorCode::BadInput, file.string(), field, "is listed twice");
        pairs.push_back(pair);
    }
    return pairs;
}

void writePairs(const std::filesystem::path& file, const std::vector<FramePair>& pairs) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const FramePair& pair : pairs) {
        list.push_back({{"sequence", pair.sequence},
                        {"start", pair.start},
                        {"test", pair.test},
                        {"difference", pair.difference()}});
    }
    writeJsonFile(file, {{"pairs", list}});
}

} // namespace core
