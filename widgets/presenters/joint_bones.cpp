// SPDX-License-Identifier: MIT
#include "widgets/presenters/joint_bones.h"

#include <algorithm>
#include <array>

namespace widgets {

std::vector<std::pair<std::string, std::string>> jointBones(const std::vector<std::string>& present) {
    constexpr std::array kFingers = {"thumb", "index", "middle", "ring", "little"};
    constexpr std::array kParts = {"cmc", "mcp", "pip", "ip", "dip", "tip"};
    const auto has = [&](const std::string& name) {
        return std::find(present.begin(), present.end(), name) != present.end();
    };
    std::vector<std::pair<std::string, std::string>> bones;
    for (const std::string finger : kFingers) {
        std::string last = has("wrist") ? "wrist" : has("forearm") ? "forearm" : "";
        for (const std::string part : kParts) {
            const std::string name = finger + "_" + part;
            if (!has(name))
                continue;
            if (!last.empty())
                bones.emplace_back(last, name);
            last = name;
        }
    }
    return bones;
}

} // namespace widgets
