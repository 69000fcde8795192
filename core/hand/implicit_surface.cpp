// SPDX-License-Identifier: MIT
#include "core/hand/implicit_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include <meshoptimizer.h>

namespace core {

double smoothMin(double a, double b, double widthMm) {
    const double overlap = std::max(widthMm - std::abs(a - b), 0.0) / widthMm;
    return std::min(a, b) - overlap * overlap * overlap * widthMm / 6;
}

namespace {

std::uint64_t edgeKey(int a, int b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint64_t>(std::max(a, b));
}

/// The field sampled on a regular grid, and the surface that grows while its cubes are visited.
class TetrahedraMarcher {
public:
    TetrahedraMarcher(const SolidField& field, const Eigen::AlignedBox3d& box, double stepMm)
        : m_origin(box.min()), m_stepMm(stepMm),
          m_count(((box.sizes() / stepMm).array().ceil() + 1).cast<int>().matrix()) {
        m_values.resize(static_cast<std::size_t>(m_count.prod()));
        for (int z = 0; z < m_count.z(); ++z) {
            for (int y = 0; y < m_count.y(); ++y) {
                for (int x = 0; x < m_count.x(); ++x) {
                    const double value = field(point({x, y, z}));
                    // A sample exactly on the surface would make triangles without area.
                    m_values[static_cast<std::size_t>(index({x, y, z}))] = std::abs(value) < 1e-9 ? 1e-9 : value;
                }
            }
        }
    }

    TriangleMesh run() {
        for (int z = 0; z + 1 < m_count.z(); ++z) {
            for (int y = 0; y + 1 < m_count.y(); ++y) {
                for (int x = 0; x + 1 < m_count.x(); ++x) {
                    visitCube({x, y, z});
                }
            }
        }
        return std::move(m_mesh);
    }

private:
    Eigen::Vector3d point(const Eigen::Vector3i& cell) const { return m_origin + m_stepMm * cell.cast<double>(); }
    int index(const Eigen::Vector3i& cell) const {
        return (cell.z() * m_count.y() + cell.y()) * m_count.x() + cell.x();
    }
    double value(const Eigen::Vector3i& cell) const { return m_values[static_cast<std::size_t>(index(cell))]; }

    /// The six tetrahedra of a cube: one per order in which the three axes are walked from its low to its high corner.
    void visitCube(const Eigen::Vector3i& low) {
        static constexpr int kWalks[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
        for (int walk = 0; walk < 6; ++walk) {
            std::array<Eigen::Vector3i, 4> corners{low, low, low, low};
            for (int k = 0; k < 3; ++k) {
                corners[k + 1] = corners[k];
                corners[k + 1][kWalks[walk][k]] += 1;
            }
            visitTetrahedron(corners, walk < 3);
        }
    }

    /// Adds the part of the surface in one tetrahedron. Corners inside the solid are moved to the front; every swap
    /// mirrors the tetrahedron.
    void visitTetrahedron(std::array<Eigen::Vector3i, 4>& c, bool rightHanded) {
        int inside = 0;
        for (int k = 0; k < 4; ++k) {
            if (value(c[k]) < 0) {
                if (k != inside) {
                    std::swap(c[k], c[inside]);
                    rightHanded = !rightHanded;
                }
                ++inside;
            }
        }
        if (inside == 1) {
            addTriangle({crossing(c[0], c[1]), crossing(c[0], c[2]), crossing(c[0], c[3])}, rightHanded);
        } else if (inside == 3) {
            addTriangle({crossing(c[0], c[3]), crossing(c[1], c[3]), crossing(c[2], c[3])}, rightHanded);
        } else if (inside == 2) {
            const int a = crossing(c[0], c[2]), b = crossing(c[0], c[3]);
            const int d = crossing(c[1], c[3]), e = crossing(c[1], c[2]);
            addTriangle({a, b, d}, rightHanded);
            addTriangle({a, d, e}, rightHanded);
        }
    }

    void addTriangle(std::array<int, 3> triangle, bool rightHanded) {
        if (!rightHanded) {
            std::swap(triangle[1], triangle[2]);
        }
        m_mesh.triangles.push_back(triangle);
    }

    /// The vertex on the grid edge between two corners of different sign, shared by all tetrahedra around that edge.
    int crossing(const Eigen::Vector3i& a, const Eigen::Vector3i& b) {
        const std::uint64_t key = edgeKey(index(a), index(b));
        const auto [entry, isNew] = m_vertexOfEdge.try_emplace(key, static_cast<int>(m_mesh.vertices.size()));
        if (isNew) {
            const double t = std::clamp(value(a) / (value(a) - value(b)), 0.02, 0.98);
            m_mesh.vertices.push_back(point(a) + t * (point(b) - point(a)));
        }
        return entry->second;
    }

    Eigen::Vector3d m_origin;
    double m_stepMm;
    Eigen::Vector3i m_count;
    std::vector<double> m_values;
    std::unordered_map<std::uint64_t, int> m_vertexOfEdge;
    TriangleMesh m_mesh;
};

/// The mesh without the vertices that no triangle uses; order is kept.
TriangleMesh withoutUnusedVertices(const TriangleMesh& mesh) {
    std::vector<int> newIndex(mesh.vertices.size(), -1);
    for (const auto& triangle : mesh.triangles) {
        for (const int v : triangle) {
            newIndex[v] = 0;
        }
    }
    TriangleMesh result;
    for (std::size_t v = 0; v < newIndex.size(); ++v) {
        if (newIndex[v] == 0) {
            newIndex[v] = static_cast<int>(result.vertices.size());
            result.vertices.push_back(mesh.vertices[v]);
        }
    }
    for (const auto& [a, b, c] : mesh.triangles) {
        result.triangles.push_back({newIndex[a], newIndex[b], newIndex[c]});
    }
    return result;
}

Eigen::Vector3d gradient(const SolidField& field, const Eigen::Vector3d& point) {
    constexpr double kStepMm = 0.05;
    Eigen::Vector3d result;
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d offset = kStepMm * Eigen::Vector3d::Unit(k);
        result[k] = (field(point + offset) - field(point - offset)) / (2 * kStepMm);
    }
    return result;
}

Eigen::Vector3d onSurface(const SolidField& field, Eigen::Vector3d point) {
    for (int step = 0; step < 3; ++step) {
        const Eigen::Vector3d slope = gradient(field, point);
        const double squared = slope.squaredNorm();
        if (squared < 1e-6) {
            break;
        }
        Eigen::Vector3d move = -field(point) * slope / squared;
        const double length = move.norm();
        point += length > 1.0 ? Eigen::Vector3d(move / length) : move;
        if (length < 1e-3) {
            break;
        }
    }
    return point;
}

int oppositeVertex(const std::array<int, 3>& triangle, int a, int b) {
    for (const int v : triangle) {
        if (v != a && v != b) {
            return v;
        }
    }
    return -1;
}

/// Directed like in a triangle: true if a comes right before b.
bool runs(const std::array<int, 3>& triangle, int a, int b) {
    return (triangle[0] == a && triangle[1] == b) || (triangle[1] == a && triangle[2] == b) ||
           (triangle[2] == a && triangle[0] == b);
}

/// One pass of edge flips towards valence six, only between nearly coplanar triangles.
void flipEdges(TriangleMesh& mesh) {
    const std::vector<MeshEdge> edges = meshEdges(mesh.triangles);
    std::vector<int> valence(mesh.vertices.size(), 0);
    std::unordered_map<std::uint64_t, bool> exists;
    for (const MeshEdge& edge : edges) {
        ++valence[edge.vertexA];
        ++valence[edge.vertexB];
        exists[edgeKey(edge.vertexA, edge.vertexB)] = true;
    }
    const auto normal = [&](int a, int b, int c) -> Eigen::Vector3d {
        return (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).normalized();
    };
    std::vector<bool> touched(mesh.triangles.size(), false);
    for (const MeshEdge& edge : edges) {
        if (edge.triangleB < 0 || touched[edge.triangleA] || touched[edge.triangleB]) {
            continue;
        }
        int a = edge.vertexA, b = edge.vertexB;
        if (!runs(mesh.triangles[edge.triangleA], a, b)) {
            std::swap(a, b);
        }
        const int c = oppositeVertex(mesh.triangles[edge.triangleA], a, b);
        const int d = oppositeVertex(mesh.triangles[edge.triangleB], a, b);
        const auto excess = [&](int v, int change) { return std::abs(valence[v] + change - 6); };
        const int before = excess(a, 0) + excess(b, 0) + excess(c, 0) + excess(d, 0);
        const int after = excess(a, -1) + excess(b, -1) + excess(c, 1) + excess(d, 1);
        if (after >= before || valence[a] <= 4 || valence[b] <= 4 || exists.count(edgeKey(c, d))) {
            continue;
        }
        const Eigen::Vector3d old = normal(a, b, c) + normal(b, a, d);
        if (normal(a, b, c).dot(normal(b, a, d)) < 0.8 || normal(c, d, b).dot(old) < 1.6 ||
            normal(d, c, a).dot(old) < 1.6) {
            continue;
        }
        mesh.triangles[edge.triangleA] = {c, d, b};
        mesh.triangles[edge.triangleB] = {d, c, a};
        touched[edge.triangleA] = touched[edge.triangleB] = true;
        exists.erase(edgeKey(a, b));
        exists[edgeKey(c, d)] = true;
        --valence[a], --valence[b], ++valence[c], ++valence[d];
    }
}

} // namespace

TriangleMesh polygonise(const SolidField& field, const Eigen::AlignedBox3d& box, double stepMm) {
    return TetrahedraMarcher(field, box, stepMm).run();
}

TriangleMesh simplified(const TriangleMesh& mesh, int triangleCount) {
    std::vector<float> positions;
    for (const Eigen::Vector3d& v : mesh.vertices) {
        positions.insert(positions.end(), {float(v.x()), float(v.y()), float(v.z())});
    }
    std::vector<unsigned> indices;
    for (const auto& triangle : mesh.triangles) {
        indices.insert(indices.end(), triangle.begin(), triangle.end());
    }
    std::vector<unsigned> kept(indices.size());
    const std::size_t wanted = 3 * static_cast<std::size_t>(triangleCount);
    kept.resize(meshopt_simplify(kept.data(), indices.data(), indices.size(), positions.data(), mesh.vertices.size(),
                                 3 * sizeof(float), wanted, 1.0F, 0, nullptr));
    TriangleMesh result{mesh.vertices, {}};
    for (std::size_t i = 0; i + 2 < kept.size(); i += 3) {
        result.triangles.push_back({int(kept[i]), int(kept[i + 1]), int(kept[i + 2])});
    }
    return withoutUnusedVertices(result);
}

void relaxOnto(const SolidField& field, TriangleMesh& mesh, int iterations) {
    for (int iteration = 0; iteration < iterations; ++iteration) {
        flipEdges(mesh);
        std::vector<Eigen::Vector3d> sum(mesh.vertices.size(), Eigen::Vector3d::Zero());
        std::vector<double> count(mesh.vertices.size(), 0);
        for (const MeshEdge& edge : meshEdges(mesh.triangles)) {
            sum[edge.vertexA] += mesh.vertices[edge.vertexB];
            sum[edge.vertexB] += mesh.vertices[edge.vertexA];
            ++count[edge.vertexA];
            ++count[edge.vertexB];
        }
        const std::vector<Eigen::Vector3d> normals = vertexNormals(mesh);
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            const Eigen::Vector3d toMiddle = sum[v] / count[v] - mesh.vertices[v];
            const Eigen::Vector3d along = toMiddle - toMiddle.dot(normals[v]) * normals[v];
            mesh.vertices[v] = onSurface(field, mesh.vertices[v] + 0.6 * along);
        }
    }
}

} // namespace core
