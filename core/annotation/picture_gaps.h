// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace core {

/// Which cameras of a sequence have no picture, in the whole sequence or at some frames.
struct PictureGaps {
    std::set<std::string> cameras; ///< without any footage
    std::map<std::string, std::vector<std::pair<int, int>>>
        framesOf{}; ///< per camera: first frame and number of frames

    /// The cameras without a picture of that frame.
    std::set<std::string> at(int frame) const;
    bool operator==(const PictureGaps&) const = default;
};

} // namespace core
