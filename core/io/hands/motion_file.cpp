// SPDX-License-Identifier: MIT
#include "core/io/hands/motion_file.h"

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/json_file.h"

namespace core {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

/// The entry of one hand; throws if there is none.
std::size_t entryOf(const json& document, Side side, const std::string& file) {
    for (std::size_t i = 0; i < document["hands"].size(); ++i)
        if (document["hands"][i]["side"] == sideName(side))
            return i;
    throw Error(ErrorCode::BadInput, file, "hands",
                "there is no motion of the " + std::string(sideName(side)) + " hand");
}

} // namespace

Motion readMotionFile(const std::filesystem::path& file, const std::vector<HandModel>& hands, int frameCount) {
    const json document = readOwnFile(file, "motion");
    if (document["frameCount"] != frameCount) {
        throw Error(ErrorCode::BadInput, file.string(), "frameCount",
                    document["frameCount"].dump() + " frames, but the sequence has " + std::to_string(frameCount));
    }
    const auto frames = static_cast<std::size_t>(frameCount);
    Motion motion(frames, HandPoses(hands.size()));
    for (std::size_t h = 0; h < hands.size(); ++h) {
        const std::size_t entry = entryOf(document, hands[h].side, file.string());
        const json& value = document["hands"][entry];
        const std::string field = "hands[" + std::to_string(entry) + "]";
        const int poseSize = hands[h].skeleton.poseSize();
        if (value["poseSize"] != poseSize) {
            throw Error(ErrorCode::BadInput, file.string(), field + ".poseSize",
                        value["poseSize"].dump() + ", but the hand model has " + std::to_string(poseSize));
        }
        const auto size = static_cast<std::size_t>(poseSize);
        const std::vector<double> flat = jsonNumbers(value["values"], frames * size, file.string(), field + ".values");
        for (std::size_t f = 0; f < frames; ++f)
            motion[f][h] = Eigen::Map<const Eigen::VectorXd>(flat.data() + f * size, poseSize);
    }
    return motion;
}

void writeMotionFile(const std::filesystem::path& file, const std::vector<HandModel>& hands, const Motion& motion) {
    ordered_json document{{"format", "handlens-motion"},
                          {"version", 1},
                          {"units", "mm, rad"},
                          {"frameCount", motion.size()},
                          {"hands", ordered_json::array()}};
    for (std::size_t h = 0; h < hands.size(); ++h) {
        const int poseSize = hands[h].skeleton.poseSize();
        std::vector<double> flat;
        for (const HandPoses& poses : motion) {
            if (poses.size() != hands.size() || poses[h].size() != poseSize || !poses[h].allFinite())
                throw Error(ErrorCode::BadInput, file.string(), "", "the poses do not fit the hands");
            flat.insert(flat.end(), poses[h].data(), poses[h].data() + poseSize);
        }
        document["hands"].push_back({{"side", sideName(hands[h].side)}, {"poseSize", poseSize}, {"values", flat}});
    }
    writeJsonFile(file, document);
}

} // namespace core
