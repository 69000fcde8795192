// SPDX-License-Identifier: MIT
#include "core/hand/motion.h"

namespace core {

double meanDisplacementMm(const std::vector<HandModel>& hands, const Motion& motion, int apart) {
    double sum = 0;
    const std::size_t step = static_cast<std::size_t>(apart);
    for (std::size_t frame = 0; frame + step < motion.size(); ++frame)
        sum += meanJointDistanceMm(hands, motion[frame], motion[frame + step]);
    return motion.size() > step ? sum / static_cast<double>(motion.size() - step) : 0;
}

} // namespace core
