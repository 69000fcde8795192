// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace widgets {

/// The pairs of joints that a skeleton drawing joins, of those in `present` (names of one hand): along every finger
/// from base to tip over whatever is missing, and from each finger's base to the wrist or forearm if that is there.
std::vector<std::pair<std::string, std::string>> jointBones(const std::vector<std::string>& present);

} // namespace widgets
