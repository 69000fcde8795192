// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/annotation/annotation_set.h"

namespace test {

/// Who and what most tests of annotations mark.
inline const std::string kRater = "ann";
inline const core::JointId kIndex{core::Side::Left, "index_mcp"};
inline const core::JointId kWrist{core::Side::Right, "wrist"};

} // namespace test
