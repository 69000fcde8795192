// SPDX-License-Identifier: MIT
#include "core/io/external_estimates.h"

#include <charconv>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/json_file.h"
#include "core/io/text_file.h"
#include "core/text/number_text.h"

namespace core {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::string_view kHeader = "sequence,start,test,hand,name,x,y,z";
constexpr std::size_t kColumns = 8;

/// The fields of a CSV line; a field may be in double quotes, with quotes inside doubled.
std::vector<std::string> csvFields(std::string_view line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
            fields.back() += line[++i];
        } else if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

int frameFrom(const LineReader& reader, const std::string& text, const char* column) {
    int frame = -1;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), frame);
    if (code != std::errc() || end != text.data() + text.size() || frame < 0) {
        throw reader.errorHere(std::string(column) + " '" + text + "' is not a frame number");
    }
    return frame;
}

double lengthFrom(const LineReader& reader, const std::string& text) {
    double value = 0;
    if (!parseNumber(text, value)) {
        throw reader.errorHere("'" + text + "' is not a finite number");
    }
    return value;
}

void readCsvLine(LineReader& reader, ExternalEstimates& estimates) {
    const std::vector<std::string> fields = csvFields(reader.next("a joint"));
    if (fields.size() != kColumns) {
        throw reader.errorHere("has " + std::to_string(fields.size()) + " columns, not " + std::to_string(kColumns));
    }
    const std::optional<Side> hand = sideFromName(fields[3]);
    if (!hand) {
        throw reader.errorHere("hand '" + fields[3] + "' is neither left nor right");
    }
    const FramePair pair{fields[0], frameFrom(reader, fields[1], "start"), frameFrom(reader, fields[2], "test")};
    const Eigen::Vector3d position(lengthFrom(reader, fields[5]), lengthFrom(reader, fields[6]),
                                   lengthFrom(reader, fields[7]));
    if (!estimates.joints[pair].emplace(JointId{*hand, fields[4]}, position).second) {
        throw reader.errorHere(jointLabel({*hand, fields[4]}) + " is listed twice for this pair");
    }
}

ExternalEstimates readCsv(const std::string& name, const fs::path& file) {
    ExternalEstimates estimates{name, {}};
    LineReader reader(file);
    if (reader.next("the header " + std::string(kHeader)) != kHeader) {
        throw reader.errorHere("must be " + std::string(kHeader));
    }
    while (!reader.atEnd()) {
        readCsvLine(reader, estimates);
    }
    return estimates;
}

JointPositions jointsFromJson(const json& list, const std::string& file, const std::string& field) {
    JointPositions joints;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string where = field + ".joints[" + std::to_string(i) + "]";
        const JointId id{*sideFromName(list[i]["hand"].get<std::string>()), list[i]["name"].get<std::string>()};
        if (!joints.emplace(id, jsonVector(list[i]["xyz"], file, where + ".xyz")).second) {
            throw Error(ErrorCode::BadInput, file, where, jointLabel(id) + " is listed twice");
        }
    }
    return joints;
}

HandPoses posesFromJson(const json& list, const std::vector<HandModel>& hands, const std::string& file,
                        const std::string& field) {
    if (list.size() != hands.size()) {
        throw Error(ErrorCode::BadInput, file, field + ".poses", "must hold one pose per hand of the dataset");
    }
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
        if (!estimates.joints.emplace(pair, std::move(joints)).second) {
            throw Error(ErrorCode::BadInput, file.string(), field, "is a pair that is listed twice");
        }
    }
    return estimates;
}

} // namespace

ExternalEstimates readExternalEstimates(const std::string& name, const fs::path& file,
                                        const std::vector<HandModel>& hands) {
    return file.extension() == ".json" ? readJson(name, file, hands) : readCsv(name, file);
}

} // namespace core
