// SPDX-License-Identifier: MIT
#include "core/demo_hand/implicit_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include "core/demo_hand/edge_key.h"

namespace core {

double smoothMin(double a, double b, double widthMm) {
    const double overlap = std::max(widthMm - std::abs(a - b), 0.0) / widthMm;
    return std::min(a, b) - overlap * overlap * overlap * widthMm / 6;
}

namespace {

/// The field on a regular grid, sampled where it is needed, and the surface that grows while its cubes are visited.
class TetrahedraMarcher {
public:
    TetrahedraMarcher(const SolidField& field, const Eigen::AlignedBox3d& box, double stepMm)
        : m_field(field)
        , m_origin(box.min())
        , m_stepMm(stepMm)
        , m_count(((box.sizes() / stepMm).array().ceil() + 1).cast<int>().matrix())
        , m_values(static_cast<std::size_t>(m_count.prod()), std::numeric_limits<double>::quiet_NaN())
        , m_isQueued(m_values.size(), false) {}

    TriangleMesh run(const Eigen::Vector3d& inside) {
        Eigen::Vector3i cell = ((inside - m_origin) / m_stepMm).array().floor().cast<int>().matrix();
        while (isCube(cell) && value(cell) < 0)
            cell.z() += 1;
        cell.z() -= 1;
        enqueue(cell);
        while (!m_queue.empty()) {
            const Eigen::Vector3i cube = m_queue.back();
            m_queue.pop_back();
            const std::size_t before = m_mesh.triangles.size();
            visitCube(cube);
            for (int axis = 0; axis < 3 && m_mesh.triangles.size() > before; ++axis) {
                enqueue(cube + Eigen::Vector3i::Unit(axis));
                enqueue(cube - Eigen::Vector3i::Unit(axis));
            }
        }
        return std::move(m_mesh);
    }

private:
    Eigen::Vector3d point(const Eigen::Vector3i& cell) const { return m_origin + m_stepMm * cell.cast<double>(); }
    int index(const Eigen::Vector3i& cell) const {
        return (cell.z() * m_count.y() + cell.y()) * m_count.x() + cell.x();
    }
    bool isCube(const Eigen::Vector3i& low) const {
        return (low.array() >= 0).all() && (low.array() + 1 < m_count.array()).all();
    }

    double value(const Eigen::Vector3i& cell) {
        double& stored = m_values[static_cast<std::size_t>(index(cell))];
        if (std::isnan(stored)) {
            const double sampled = m_field(point(cell));
            // A sample exactly on the surface would make triangles without area.
            stored = std::abs(sampled) < 1e-9 ? 1e-9 : sampled;
        }
        return stored;
    }

    void enqueue(const Eigen::Vector3i& cube) {
        if (isCube(cube) && !m_isQueued[static_cast<std::size_t>(index(cube))]) {
            m_isQueued[static_cast<std::size_t>(index(cube))] = true;
            m_queue.push_back(cube);
        }
    }

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
        if (!rightHanded)
            std::swap(triangle[1], triangle[2]);
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

    const SolidField& m_field;
    Eigen::Vector3d m_origin;
    double m_stepMm;
    Eigen::Vector3i m_count;
    std::vector<double> m_values; ///< NaN = not sampled yet
    std::vector<bool> m_isQueued;
    std::vector<Eigen::Vector3i> m_queue;
    std::unordered_map<std::uint64_t, int> m_vertexOfEdge;
    TriangleMesh m_mesh;
};

} // namespace

TriangleMesh polygonise(const SolidField& field, const Eigen::AlignedBox3d& box, double stepMm,
                        const Eigen::Vector3d& inside) {
    return TetrahedraMarcher(field, box, stepMm).run(inside);
}

} // namespace core
