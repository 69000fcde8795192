// SPDX-License-Identifier: MIT
#include "core/demo_hand/demo_hand_shape.h"

namespace core {

std::vector<std::string> rayJointNames(const RayShape& ray) {
    std::vector<std::string> names{ray.finger + "_cmc", ray.finger + "_mcp"};
    if (ray.joints.size() == 4) {
        names.push_back(ray.finger + "_ip");
    } else {
        names.push_back(ray.finger + "_pip");
        names.push_back(ray.finger + "_dip");
    }
    names.push_back(ray.finger + "_tip");
    return names;
}

} // namespace core
