// SPDX-License-Identifier: MIT
#include "core/hand/hand_chains.h"

#include <algorithm>

namespace core {

std::optional<std::string> previousJoint(std::string_view joint) {
    const std::size_t split = joint.find('_');
    if (split == std::string_view::npos)
        return std::nullopt;
    const std::string finger(joint.substr(0, split));
    const std::string_view part = joint.substr(split + 1);
    const bool isThumb = finger == "thumb";
    if (std::find(kFingers.begin(), kFingers.end(), finger) == kFingers.end())
        return std::nullopt;
    if (part == "mcp")
        return finger + "_cmc";
    if (isThumb) {
        return part == "ip"    ? std::optional(finger + "_mcp")
               : part == "tip" ? std::optional(finger + "_ip")
                               : std::nullopt;
    }
    return part == "pip"   ? std::optional(finger + "_mcp")
           : part == "dip" ? std::optional(finger + "_pip")
           : part == "tip" ? std::optional(finger + "_dip")
                           : std::nullopt;
}

} // namespace core
