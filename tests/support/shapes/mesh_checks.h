// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <utility>

#include "core/hand/triangle_mesh.h"

namespace test {

/// How often every directed edge occurs: in a closed, consistently oriented mesh each once, and its opposite once.
bool isClosedAndOriented(const core::TriangleMesh& mesh);

/// V - E + F: 2 for a surface like a sphere's, if no vertex is unused.
int eulerNumber(const core::TriangleMesh& mesh);

} // namespace test
