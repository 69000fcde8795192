// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/annotation/annotation_set.h"

namespace core {

/// One joint under another program's name. Without a hand it stands for that joint of either hand.
struct JointMapEntry {
    std::string name;
    std::string joint;
    std::optional<Side> hand;
};

/// How joints are called elsewhere, in the order that is used there. Formats differ in how they tell hands apart: where
/// both hands share one list of names, an entry without a hand is called left_<name> and right_<name>.
class JointMap {
public:
    /// Every joint keeps its name: left_index_mcp.
    JointMap() = default;
    /// Throws Error(BadInput) naming `file` if a name or a joint occurs twice.
    JointMap(std::vector<JointMapEntry> entries, const std::string& file);

    /// True for the map that names every joint.
    bool isIdentity() const { return m_entries.empty(); }
    const std::vector<JointMapEntry>& entries() const { return m_entries; }

    /// The joint of a name in a list that both hands share.
    std::optional<JointId> jointOf(std::string_view sharedName) const;
    /// The name in such a list; empty if the joint is unknown there.
    std::optional<std::string> sharedName(const JointId& joint) const;
    /// The joint of a name in a list of one hand.
    std::optional<JointId> jointOf(std::string_view name, Side hand) const;
    /// All joints of one hand in the order of the list, with their names there; empty for the identity.
    std::vector<std::pair<std::string, JointId>> handList(Side hand) const;

private:
    std::vector<JointMapEntry> m_entries;
};

/// Reads a joint map (format "handlens-joint-map"), a file or the name of a built-in one: tzionas, coco, interhand,
/// freihand.
JointMap readJointMap(const std::filesystem::path& nameOrFile);

/// Reads a list of joints of one hand (format "handlens-joint-list"), a file or a built-in one: 14, 21.
std::vector<std::string> readJointList(const std::filesystem::path& nameOrFile);

} // namespace core
