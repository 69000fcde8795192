// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <utility>

#include "core/hand/triangle_mesh.h"

namespace test {

/// How often every directed edge occurs: in a closed, consistently oriented mesh each once, and its opposite once.
inline bool isClosedAndOriented(const core::TriangleMesh& mesh) {
    std::map<std::pair<int, int>, int> uses;
    for (const auto& t : mesh.triangles) {
        for (int k = 0; k < 3; ++k)
            if (t[k] == t[(k + 1) % 3] || ++uses[{t[k], t[(k + 1) % 3]}] > 1)
                return false;
    }
    for (const auto& [edge, count] : uses)
        if (!uses.count({edge.second, edge.first}))
            return false;
    return true;
}

/// V - E + F: 2 for a surface like a sphere's, if no vertex is unused.
inline int eulerNumber(const core::TriangleMesh& mesh) {
    return static_cast<int>(mesh.vertices.size()) - static_cast<int>(core::meshEdges(mesh.triangles).size()) +
           static_cast<int>(mesh.triangles.size());
}

} // namespace test
