// SPDX-License-Identifier: MIT
#include <map>
#include <numbers>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/hand/rig.h"
#include "core/io/demo/demo_files.h"
#include "core/io/files/json_file.h"

namespace core {

using nlohmann::json;

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;

/// Which degrees of freedom the numbers of a finger in a shape are.
const std::vector<std::string> kFingerDofs{"mcp.flexion", "mcp.abduction", "pip.flexion",
                                           "dip.flexion", "cmc.flexion",   "mcp.twist"};
const std::vector<std::string> kThumbDofs{"cmc.flexion", "cmc.abduction", "mcp.flexion", "mcp.abduction", "ip.flexion"};
const std::vector<std::string> kFingers{"thumb", "index", "middle", "ring", "little"};

/// Sets the angles that a shape or key names.
void setAngles(const json& value, const Skeleton& skeleton, Eigen::VectorXd& anglesRad) {
    for (const std::string& finger : kFingers) {
        if (!value.contains(finger))
            continue;
        const std::vector<std::string>& dofs = finger == "thumb" ? kThumbDofs : kFingerDofs;
        for (std::size_t i = 0; i < value[finger].size() && i < dofs.size(); ++i) {
            for (std::size_t d = 0; d < skeleton.dofs.size(); ++d)
                if (skeleton.dofs[d].name == finger + "_" + dofs[i])
                    anglesRad[static_cast<Eigen::Index>(d)] = value[finger][i].get<double>() * kRadPerDeg;
        }
    }
}

/// Reads the keys of one hand. What a key does not say stays as in the key before it.
class KeyReader {
public:
    KeyReader(const json& shapes, const HandModel& hand, std::string file)
        : m_shapes(shapes)
        , m_hand(hand)
        , m_file(std::move(file)) {}

    std::vector<HandKey> read(const json& list, const std::string& field) const {
        std::vector<HandKey> keys;
        Eigen::Vector3d wrist, fingers, dorsal;
        Eigen::VectorXd angles = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_hand.skeleton.dofs.size()));
        for (std::size_t i = 0; i < list.size(); ++i) {
            const json& key = list[i];
            const std::string here = field + "[" + std::to_string(i) + "]";
            for (const char* name : {"wrist", "fingers", "dorsal", "shape"})
                if (i == 0 && !key.contains(name))
                    throw Error(ErrorCode::BadInput, m_file, here + "." + name, "the first key must say everything");
            take(key, "wrist", here, wrist);
            take(key, "fingers", here, fingers);
            take(key, "dorsal", here, dorsal);
            if (key.contains("shape"))
                setAngles(shape(key["shape"].get<std::string>(), here), m_hand.skeleton, angles);
            setAngles(key, m_hand.skeleton, angles);
            keys.push_back(placed(key["at"].get<double>(), anatomicalFrame(wrist, fingers, dorsal), angles));
            if (i > 0 && keys[i].frame <= keys[i - 1].frame)
                throw Error(ErrorCode::BadInput, m_file, here + ".at", "frames must ascend");
        }
        return keys;
    }

private:
    void take(const json& key, const char* name, const std::string& field, Eigen::Vector3d& value) const {
        if (key.contains(name))
            value = jsonVector(key[name], m_file, field + "." + name);
    }

    const json& shape(const std::string& name, const std::string& field) const {
        if (!m_shapes.contains(name))
            throw Error(ErrorCode::BadInput, m_file, field + ".shape", "there is no shape '" + name + "'");
        return m_shapes[name];
    }

    /// Keys are written for a right hand; a left one is their mirror image at x = 0.
    HandKey placed(double frame, RigidMotion stageFromWrist, const Eigen::VectorXd& angles) const {
        if (m_hand.side == Side::Left) {
            stageFromWrist.translation.x() *= -1;
            stageFromWrist.rotation = Eigen::Vector3d(-1, 1, 1).asDiagonal() * stageFromWrist.rotation *
                                      Eigen::Vector3d(1, -1, 1).asDiagonal();
        }
        return {frame, stageFromWrist.translation, Eigen::Quaterniond(stageFromWrist.rotation), angles};
    }

    const json& m_shapes;
    const HandModel& m_hand;
    std::string m_file;
};

std::vector<StageKey> stageFrom(const json& list, const std::string& file, const std::string& field) {
    std::vector<StageKey> keys;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string here = field + "[" + std::to_string(i) + "]";
        keys.push_back({list[i]["at"].get<double>(), jsonVector(list[i]["offset"], file, here + ".offset"),
                        kRadPerDeg * jsonVector(list[i]["turnDeg"], file, here + ".turnDeg")});
        if (i > 0 && keys[i].frame <= keys[i - 1].frame)
            throw Error(ErrorCode::BadInput, file, here + ".at", "frames must ascend");
    }
    return keys;
}

ContactRule contactFrom(const json& value, const std::string& file, const std::string& field) {
    ContactRule rule{jsonVector(value["direction"], file, field + ".direction"),
                     value["secondShare"].get<double>(),
                     value["smoothFrames"].get<int>(),
                     {}};
    for (const json& gap : value["gaps"])
        rule.gaps.push_back({gap[0].get<double>(), gap[1].get<double>()});
    return rule;
}

} // namespace

std::vector<Choreography> choreographiesFromJson(const json& value, const std::vector<HandModel>& hands,
                                                 const std::string& file) {
    std::vector<Choreography> result;
    for (std::size_t s = 0; s < value["sequences"].size(); ++s) {
        const json& sequence = value["sequences"][s];
        const std::string field = "sequences[" + std::to_string(s) + "]";
        Choreography choreography;
        choreography.name = sequence["name"].get<std::string>();
        choreography.frameCount = sequence["frames"].get<int>();
        for (const HandModel& hand : hands) {
            const bool isOwn = hand.side == Side::Left && sequence.contains("left");
            const std::string track = isOwn ? "left" : "right";
            choreography.keys.push_back(
                KeyReader(value["shapes"], hand, file).read(sequence[track], field + "." + track));
        }
        choreography.stage = stageFrom(sequence.value("stage", json::array()), file, field + ".stage");
        if (sequence.contains("contact"))
            choreography.contact = contactFrom(sequence["contact"], file, field + ".contact");
        result.push_back(std::move(choreography));
    }
    return result;
}

} // namespace core
