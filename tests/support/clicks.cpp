// SPDX-License-Identifier: MIT
#include "tests/support/clicks.h"

namespace test {

void clickEverywhere(core::AnnotationSet& set, const std::vector<core::Camera>& cameras, int frame,
                     const std::string& rater, const core::JointId& joint, const Eigen::Vector3d& point, double sigmaPx,
                     std::mt19937_64* random) {
    for (const core::Camera& camera : cameras) {
        auto px = core::project(camera, point);
        if (!px)
            continue;
        if (random && sigmaPx > 0) {
            std::normal_distribution<double> normal(0, sigmaPx);
            px->x() += normal(*random);
            px->y() += normal(*random);
        }
        set.marks[{frame, rater, joint, camera.name}] = {*px, core::Placement::Manual, core::MarkState::Visible};
    }
}

std::mt19937_64 randomFor(const std::string& name) {
    return std::mt19937_64(std::hash<std::string>{}(name));
}

} // namespace test
