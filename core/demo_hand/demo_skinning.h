// SPDX-License-Identifier: MIT
#pragma once

#include "core/demo_hand/demo_hand_shape.h"
#include "core/demo_hand/demo_hand_solid.h"
#include "core/hand/hand_model.h"

namespace core {

/// Weights of the demo hand's vertices: shared between neighbouring rays only in the palm, between neighbouring bones
/// of a ray within its bending length, then smoothed along the surface. `skeleton` has the joints of `shape` by name.
SkinWeights demoSkinWeights(const DemoHandShape& shape, const DemoHandSolid& solid, const Skeleton& skeleton,
                            const TriangleMesh& mesh);

} // namespace core
