// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace core {

/// Everything that the description of COCO keypoints demands: members and types (resources/schemas/coco.schema.json),
/// ids that are unique and exist, three numbers per keypoint, v of 0, 1 or 2, num_keypoints = count of v > 0, skeleton
/// pairs counted from
/// 1. Throws Error(BadInput) naming `file` and the item.
void checkCoco(const nlohmann::json& document, const std::string& file);

} // namespace core
