// SPDX-License-Identifier: MIT
#include "core/io/formats/joint_files.h"

#include <set>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/embedded_resources.h"
#include "core/io/files/json_file.h"

namespace core {

namespace {

const std::string kPrefixes[] = {"left_", "right_"};

/// "left_index_mcp" -> left hand and "index_mcp".
std::optional<std::pair<Side, std::string_view>> splitHand(std::string_view name) {
    for (const std::string& prefix : kPrefixes) {
        if (name.starts_with(prefix) && name.size() > prefix.size()) {
            return std::pair(*sideFromName(std::string_view(prefix).substr(0, prefix.size() - 1)),
                             name.substr(prefix.size()));
        }
    }
    return std::nullopt;
}

std::string withHand(Side hand, const std::string& name) {
    return std::string(sideName(hand)) + "_" + name;
}

/// A file of that path if there is one, else the built-in one of that name.
nlohmann::json readNamed(const std::filesystem::path& nameOrFile, const std::string& folder, const std::string& kind) {
    const std::string builtIn = folder + "/" + nameOrFile.string() + ".json";
    if (findEmbeddedResource(builtIn) && !std::filesystem::is_regular_file(nameOrFile))
        return embeddedOwnFile(builtIn, kind);
    return readOwnFile(nameOrFile, kind);
}

} // namespace

JointMap::JointMap(std::vector<JointMapEntry> entries, const std::string& file)
    : m_entries(std::move(entries)) {
    std::set<std::string> names;
    std::set<JointId> joints;
    for (const JointMapEntry& entry : m_entries) {
        for (const Side hand : {Side::Left, Side::Right})
            if ((!entry.hand || *entry.hand == hand) && !joints.insert({hand, entry.joint}).second)
                throw Error(ErrorCode::BadInput, file, "joints", "\"" + entry.joint + "\" occurs twice");
        if (!names.insert(entry.name).second)
            throw Error(ErrorCode::BadInput, file, "joints", "the name \"" + entry.name + "\" occurs twice");
    }
}

std::optional<JointId> JointMap::jointOf(std::string_view sharedName) const {
    const auto split = splitHand(sharedName);
    if (isIdentity())
        return split ? std::optional(JointId{split->first, std::string(split->second)}) : std::nullopt;
    for (const JointMapEntry& entry : m_entries) {
        if (entry.hand && entry.name == sharedName)
            return JointId{*entry.hand, entry.joint};
        if (!entry.hand && split && entry.name == split->second)
            return JointId{split->first, entry.joint};
    }
    return std::nullopt;
}

std::optional<std::string> JointMap::sharedName(const JointId& joint) const {
    if (isIdentity())
        return withHand(joint.hand, joint.joint);
    for (const JointMapEntry& entry : m_entries)
        if (entry.joint == joint.joint && entry.hand.value_or(joint.hand) == joint.hand)
            return entry.hand ? entry.name : withHand(joint.hand, entry.name);
    return std::nullopt;
}

std::optional<JointId> JointMap::jointOf(std::string_view name, Side hand) const {
    if (isIdentity())
        return JointId{hand, std::string(name)};
    for (const JointMapEntry& entry : m_entries)
        if (entry.name == name && entry.hand.value_or(hand) == hand)
            return JointId{hand, entry.joint};
    return std::nullopt;
}

std::vector<std::pair<std::string, JointId>> JointMap::handList(Side hand) const {
    std::vector<std::pair<std::string, JointId>> list;
    for (const JointMapEntry& entry : m_entries)
        if (entry.hand.value_or(hand) == hand)
            list.emplace_back(entry.name, JointId{hand, entry.joint});
    return list;
}

JointMap readJointMap(const std::filesystem::path& nameOrFile) {
    std::vector<JointMapEntry> entries;
    const nlohmann::json value = readNamed(nameOrFile, "joint-maps", "joint-map");
    for (const auto& item : value["joints"]) {
        JointMapEntry entry{item["name"], item["joint"], std::nullopt};
        if (item.contains("hand"))
            entry.hand = sideFromName(item["hand"].get<std::string>());
        entries.push_back(std::move(entry));
    }
    return {std::move(entries), nameOrFile.string()};
}

std::vector<std::string> readJointList(const std::filesystem::path& nameOrFile) {
    return readNamed(nameOrFile, "joint-lists", "joint-list")["joints"].get<std::vector<std::string>>();
}

} // namespace core
