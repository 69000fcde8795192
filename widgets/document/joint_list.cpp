// SPDX-License-Identifier: MIT
#include "widgets/document/joint_list.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

namespace widgets {

namespace {

constexpr std::array kFingers = {"thumb", "index", "middle", "ring", "little"};
constexpr std::array<std::pair<const char*, JointChoice>, 3> kChoiceNames = {
    {{"fourteen", JointChoice::Fourteen}, {"twentyone", JointChoice::TwentyOne}, {"all", JointChoice::AllBones}}};

std::vector<std::string> partsOf(const std::string& finger, bool withEnds) {
    if (finger == "thumb")
        return withEnds ? std::vector<std::string>{"cmc", "mcp", "ip", "tip"} : std::vector<std::string>{"mcp", "ip"};
    return withEnds ? std::vector<std::string>{"mcp", "pip", "dip", "tip"}
                    : std::vector<std::string>{"mcp", "pip", "dip"};
}

std::optional<core::JointId> jointFromText(const std::string& text) {
    const auto space = text.find(' ');
    if (space == std::string::npos || space + 1 == text.size())
        return std::nullopt;
    const auto side = core::sideFromName(text.substr(0, space));
    if (!side)
        return std::nullopt;
    return core::JointId{*side, text.substr(space + 1)};
}

/// The sides to annotate with their models; both sides without one if the dataset has none.
std::vector<std::pair<core::Side, const core::HandModel*>> handsOf(const core::Dataset& dataset) {
    std::vector<std::pair<core::Side, const core::HandModel*>> hands;
    for (const core::HandModel& hand : dataset.hands)
        hands.emplace_back(hand.side, &hand);
    if (hands.empty())
        hands = {{core::Side::Left, nullptr}, {core::Side::Right, nullptr}};
    return hands;
}

} // namespace

std::vector<std::string> jointNames(JointChoice choice, const core::HandModel* hand) {
    std::vector<std::string> names;
    if (choice == JointChoice::AllBones && hand) {
        for (const core::Bone& bone : hand->skeleton.bones)
            names.push_back(bone.name);
        return names;
    }
    const bool withEnds = choice != JointChoice::Fourteen;
    if (withEnds)
        names.push_back("wrist");
    for (const std::string finger : kFingers)
        for (const std::string& part : partsOf(finger, withEnds))
            names.push_back(finger + "_" + part);
    return names;
}

JointList::JointList(QObject* parent)
    : QObject(parent) {}

bool JointList::contains(const core::JointId& joint) const {
    return std::find(m_joints.begin(), m_joints.end(), joint) != m_joints.end();
}

int JointList::count(core::Side hand) const {
    return static_cast<int>(std::count_if(
        m_joints.begin(), m_joints.end(), [&](const core::JointId& j) { return j.hand == hand; }));
}

void JointList::setChoice(JointChoice choice, const core::Dataset& dataset) {
    m_choice = choice;
    if (choice != JointChoice::Custom) {
        m_joints.clear();
        for (const auto& [side, hand] : handsOf(dataset))
            for (const std::string& name : jointNames(choice, hand))
                m_joints.push_back({side, name});
    }
    emit changed();
}

void JointList::setNames(const std::vector<std::string>& names, const core::Dataset& dataset) {
    std::vector<core::JointId> joints;
    for (const auto& [side, hand] : handsOf(dataset))
        for (const std::string& name : names)
            joints.push_back({side, name});
    setCustom(std::move(joints));
}

void JointList::setCustom(std::vector<core::JointId> joints) {
    m_choice = JointChoice::Custom;
    m_joints.clear();
    for (core::JointId& joint : joints)
        if (!contains(joint))
            m_joints.push_back(std::move(joint));
    emit changed();
}

void JointList::move(int row, int rows) {
    const int size = static_cast<int>(m_joints.size());
    if (row < 0 || row >= size)
        return;
    const int target = std::clamp(row + rows, 0, size - 1);
    if (target == row)
        return;
    const auto from = m_joints.begin() + row;
    if (target > row)
        std::rotate(from, from + 1, m_joints.begin() + target + 1);
    else
        std::rotate(m_joints.begin() + target, from, from + 1);
    m_choice = JointChoice::Custom;
    emit changed();
}

core::JointId JointList::neighbour(const core::JointId& joint, int steps) const {
    if (m_joints.empty())
        return joint;
    const auto at = std::find(m_joints.begin(), m_joints.end(), joint);
    if (at == m_joints.end())
        return m_joints.front();
    const int size = static_cast<int>(m_joints.size());
    const int index = (static_cast<int>(at - m_joints.begin()) + steps % size + size) % size;
    return m_joints[static_cast<std::size_t>(index)];
}

std::string JointList::toText() const {
    for (const auto& [name, choice] : kChoiceNames)
        if (choice == m_choice)
            return name;
    std::string text;
    for (const core::JointId& joint : m_joints)
        text += (text.empty() ? "" : ",") + std::string(core::sideName(joint.hand)) + " " + joint.joint;
    return text;
}

bool JointList::setFromText(const std::string& text, const core::Dataset& dataset) {
    for (const auto& [name, choice] : kChoiceNames) {
        if (text == name) {
            setChoice(choice, dataset);
            return true;
        }
    }
    std::vector<core::JointId> joints;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');) {
        const auto joint = jointFromText(part);
        if (!joint)
            return false;
        joints.push_back(*joint);
    }
    if (joints.empty())
        return false;
    setCustom(std::move(joints));
    return true;
}

} // namespace widgets
