// SPDX-License-Identifier: MIT
#include "core/annotation/picture_gaps.h"

#include <algorithm>

namespace core {

std::set<std::string> PictureGaps::at(int frame) const {
    std::set<std::string> blind = cameras;
    for (const auto& [camera, gaps] : framesOf) {
        const bool isIn = std::any_of(gaps.begin(), gaps.end(), [&](const auto& gap) {
            return frame >= gap.first && frame - gap.first < gap.second;
        });
        if (isIn)
            blind.insert(camera);
    }
    return blind;
}

} // namespace core
