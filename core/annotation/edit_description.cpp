// SPDX-License-Identifier: MIT
#include "core/annotation/edit_description.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace core {

namespace {

constexpr std::string_view kAllViews = "all views";

/// The words before and between the data of a label. Labels of one mark: opening, joint, " in ", camera.
struct Wording {
    EditKind kind;
    std::string_view opening;
    std::string_view between = {}; ///< before the last frame, where there is one
};
constexpr std::array kMarkWordings = {
    Wording{EditKind::Place, "place "},     Wording{EditKind::Move, "move "},
    Wording{EditKind::Delete, "delete "},   Wording{EditKind::AcceptJoint, "accept "},
    Wording{EditKind::SetState, "set to "},
};
constexpr std::array kFrameWordings = {
    Wording{EditKind::Note, "note in frame "},
    Wording{EditKind::AcceptFrame, "accept all joints of frame "},
    Wording{EditKind::CopyPose, "copy pose of frame ", " to frame "},
    Wording{EditKind::Interpolate, "interpolate frames ", " to "},
    Wording{EditKind::SwapHands, "swap left and right in frames ", " to "},
    Wording{EditKind::SwapHands, "swap left and right from frame "},
    Wording{EditKind::DeleteRange, "delete frames ", " to "},
    Wording{EditKind::FirstPass, "first pass over frames ", " to "},
};
constexpr std::string_view kPropose = "propose joints of the hand model";
constexpr std::string_view kImport = "import";

/// Takes `words` off the beginning of `text`, if it begins with them.
bool take(std::string_view& text, std::string_view words) {
    if (!text.starts_with(words))
        return false;
    text.remove_prefix(words.size());
    return true;
}

bool takeNumber(std::string_view& text, int& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc())
        return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

/// "left index_mcp in cam3".
bool readMarkPlace(std::string_view text, EditDescription& found) {
    found.joint.hand = text.starts_with("left ") ? Side::Left : Side::Right;
    if (!take(text, "left ") && !take(text, "right "))
        return false;
    const auto end = text.find(" in ");
    if (end == std::string_view::npos)
        return false;
    found.joint.joint = text.substr(0, end);
    found.camera = text.substr(end + 4);
    if (found.kind == EditKind::AcceptJoint && found.camera == kAllViews)
        found.camera.clear();
    return true;
}

std::optional<EditDescription> readMarkLabel(std::string_view text, const Wording& wording) {
    EditDescription found{wording.kind};
    if (!take(text, wording.opening))
        return std::nullopt;
    if (wording.kind == EditKind::SetState) {
        const auto colon = text.find(": ");
        const auto state = stateFromName(text.substr(0, colon));
        if (colon == std::string_view::npos || !state)
            return std::nullopt;
        found.state = *state;
        text.remove_prefix(colon + 2);
    }
    return readMarkPlace(text, found) ? std::optional(found) : std::nullopt;
}

std::optional<EditDescription> readFrameLabel(std::string_view text, const Wording& wording) {
    EditDescription found{wording.kind};
    if (!take(text, wording.opening) || !takeNumber(text, found.firstFrame))
        return std::nullopt;
    if (!wording.between.empty()) {
        found.lastFrame.emplace();
        if (!take(text, wording.between) || !takeNumber(text, *found.lastFrame))
            return std::nullopt;
    }
    return found;
}

EditDescription readLabel(std::string_view label) {
    for (const Wording& wording : kFrameWordings)
        if (const auto found = readFrameLabel(label, wording))
            return *found;
    for (const Wording& wording : kMarkWordings)
        if (const auto found = readMarkLabel(label, wording))
            return *found;
    EditDescription found;
    if (label == kPropose) {
        found.kind = EditKind::Propose;
    } else if (label == kImport || label.starts_with(std::string(kImport) + " ")) {
        found.kind = EditKind::Import;
        found.text = label.substr(std::min(label.size(), kImport.size() + 1));
    }
    return found;
}

std::string markLabel(const EditDescription& description, const Wording& wording) {
    std::string label(wording.opening);
    if (description.kind == EditKind::SetState)
        label += std::string(stateName(description.state)) + ": ";
    const bool everywhere = description.kind == EditKind::AcceptJoint && description.camera.empty();
    return label + jointLabel(description.joint) + " in " + (everywhere ? std::string(kAllViews) : description.camera);
}

std::string frameLabel(const EditDescription& description, const Wording& wording) {
    std::string label = std::string(wording.opening) + std::to_string(description.firstFrame);
    if (description.lastFrame)
        label += std::string(wording.between) + std::to_string(*description.lastFrame);
    return label;
}

} // namespace

std::string editLabel(const EditDescription& description) {
    if (description.kind == EditKind::Propose)
        return std::string(kPropose);
    if (description.kind == EditKind::Import)
        return std::string(kImport) + (description.text.empty() ? "" : " ") + description.text;
    for (const Wording& wording : kMarkWordings)
        if (wording.kind == description.kind)
            return markLabel(description, wording);
    for (const Wording& wording : kFrameWordings)
        if (wording.kind == description.kind && wording.between.empty() != description.lastFrame.has_value())
            return frameLabel(description, wording);
    return description.text;
}

EditDescription parseEditLabel(std::string_view label) {
    EditDescription found = readLabel(label);
    if (editLabel(found) == label)
        return found;
    return {EditKind::Other, {}, {}, {}, 0, {}, std::string(label)};
}

} // namespace core
