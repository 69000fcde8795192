// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/geometry/camera.h"

namespace test {

/// Who and what most tests of annotations click.
inline const std::string kRater = "ann";
inline const core::JointId kIndex{core::Side::Left, "index_mcp"};
inline const core::JointId kWrist{core::Side::Right, "wrist"};

/// Writes a manual mark of `point` into every camera that sees it, with normal noise from `random` per axis.
void clickEverywhere(core::AnnotationSet& set, const std::vector<core::Camera>& cameras, int frame,
                     const std::string& rater, const core::JointId& joint, const Eigen::Vector3d& point,
                     double sigmaPx = 0, std::mt19937_64* random = nullptr);

/// Seeded by its name, so that every test draws its own, always the same numbers.
std::mt19937_64 randomFor(const std::string& name);

} // namespace test
