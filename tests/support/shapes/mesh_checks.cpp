// SPDX-License-Identifier: MIT
#include "tests/support/shapes/mesh_checks.h"

namespace test {

bool isClosedAndOriented(const core::TriangleMesh& mesh) {
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

int eulerNumber(const core::TriangleMesh& mesh) {
    return static_cast<int>(mesh.vertices.size()) - static_cast<int>(core::meshEdges(mesh.triangles).size()) +
           static_cast<int>(mesh.triangles.size());
}

} // namespace test
