// SPDX-License-Identifier: MIT
#include "core/io/benchmark/external_estimates.h"

#include <charconv>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/csv_text.h"
#include "core/io/files/json_file.h"
#include "core/io/files/text_file.h"
#include "core/text/number_text.h"

namespace core {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

const CsvRow kHeader{"sequence", "start", "test", "hand", "name", "x", "y", "z"};

/// Row of a table, for error messages.
struct RowPlace {
    const std::string& file;
    std::size_t row; ///< from 1, the header included

    Error error(const std::string& what) const {
        return {ErrorCode::BadInput, file, "row " + std::to_string(row), what};
    }
};

int frameFrom(const RowPlace& place, const std::string& text, const char* column) {
    int frame = -1;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), frame);
    if (code != std::errc() || end != text.data() + text.size() || frame < 0)
        throw place.error(std::string(column) + " '" + text + "' is not a frame number");
    return frame;
}

double lengthFrom(const RowPlace& place, const std::string& text) {
    double value = 0;
    if (!parseNumber(text, value))
        throw place.error("'" + text + "' is not a finite number");
    return value;
}

void readRow(const RowPlace& place, const CsvRow& fields, ExternalEstimates& estimates) {
    if (fields.size() != kHeader.size())
        throw place.error("has " + std::to_string(fields.size()) + " columns, not " + std::to_string(kHeader.size()));
    const std::optional<Side> hand = sideFromName(fields[3]);
    if (!hand)
        throw place.error("hand '" + fields[3] + "' is neither left nor right");
    const FramePair pair{fields[0], frameFrom(place, fields[1], "start"), frameFrom(place, fields[2], "test")};
    const Eigen::Vector3d position(lengthFrom(place, fields[5]), lengthFrom(place, fields[6]),
                                   lengthFrom(place, fields[7]));
    if (!estimates.joints[pair].emplace(JointId{*hand, fields[4]}, position).second)
        throw place.error(jointLabel({*hand, fields[4]}) + " is listed twice for this pair");
}

ExternalEstimates readTable(const std::string& name, const fs::path& path) {
    ExternalEstimates estimates{name, {}};
    const std::string file = path.string();
    const std::vector<CsvRow> rows = readCsv(path);
    if (rows.empty() || rows[0] != kHeader) {
        const std::string header = csvLine(kHeader);
        throw Error(ErrorCode::BadInput, file, "header", "must be " + header.substr(0, header.size() - 1));
    }
    for (std::size_t i = 1; i < rows.size(); ++i)
        readRow({file, i + 1}, rows[i], estimates);
    return estimates;
}

JointPositions jointsFromJson(const json& list, const std::string& file, const std::string& field) {
    JointPositions joints;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string where = field + ".joints[" + std::to_string(i) + "]";
        const JointId id{*sideFromName(list[i]["hand"].get<std::string>()), list[i]["name"].get<std::string>()};
        if (!joints.emplace(id, jsonVector(list[i]["xyz"], file, where + ".xyz")).second)
            throw Error(ErrorCode::BadInput, file, where, jointLabel(id) + " is listed twice");
    }
    return joints;
}

HandPoses posesFromJson(const json& list, const std::vector<HandModel>& hands, const std::string& file,
                        const std::string& field) {
    if (list.size() != hands.size())
        throw Error(ErrorCode::BadInput, file, field + ".poses", "must hold one pose per hand of the dataset");
    HandPoses poses;
    for (std::size_t h = 0; h < hands.size(); ++h) {
        const auto size = static_cast<std::size_t>(hands[h].skeleton.poseSize());
        const std::vector<double> values =
            jsonNumbers(list[h], size, file, field + ".poses[" + std::to_string(h) + "]");
        poses.push_back(Eigen::Map<const Pose>(values.data(), static_cast<Eigen::Index>(values.size())));
    }
    return poses;
}

ExternalEstimates readJson(const std::string& name, const fs::path& file, const std::vector<HandModel>& hands) {
    const json document = readJsonFile(file);
    checkSchema(document, "external-estimates", file.string());
    ExternalEstimates estimates{name, {}};
    const json& list = document["estimates"];
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string field = "estimates[" + std::to_string(i) + "]";
        const FramePair pair{list[i]["sequence"].get<std::string>(), list[i]["start"].get<int>(),
                             list[i]["test"].get<int>()};
        JointPositions joints =
            list[i].contains("joints")
                ? jointsFromJson(list[i]["joints"], file.string(), field)
                : namedJointPositions(hands, posesFromJson(list[i]["poses"], hands, file.string(), field));
        if (!estimates.joints.emplace(pair, std::move(joints)).second)
            throw Error(ErrorCode::BadInput, file.string(), field, "is a pair that is listed twice");
    }
    return estimates;
}

} // namespace

ExternalEstimates readExternalEstimates(const std::string& name, const fs::path& file,
                                        const std::vector<HandModel>& hands) {
    return file.extension() == ".json" ? readJson(name, file, hands) : readTable(name, file);
}

} // namespace core
