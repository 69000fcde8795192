// SPDX-License-Identifier: MIT
#pragma once

#include "core/demo_hand/demo_hand.h"

namespace core {

/// Weights of the demo hand's vertices: shared between neighbouring rays only in the palm, between neighbouring bones
/// of a ray within its bending length, then smoothed along the surface. `skeleton` has the joints of `shape` by name.
SkinWeights demoSkinWeights(const DemoHandShape& shape, const DemoHandSolid& solid, const Skeleton& skeleton,
                            const TriangleMesh& mesh);

/// Names of a ray's joints: thumb_cmc, thumb_mcp, thumb_ip, thumb_tip; index_cmc, ..., index_tip.
std::vector<std::string> rayJointNames(const RayShape& ray);

} // namespace core
