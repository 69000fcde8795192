// SPDX-License-Identifier: MIT
#include "core/demo_hand/remeshing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_set>

#include "core/demo_hand/edge_key.h"

namespace core {

namespace {

using Triangle = std::array<int, 3>;

/// Triangles around every vertex.
std::vector<std::vector<int>> vertexTriangles(const TriangleMesh& mesh) {
    std::vector<std::vector<int>> around(mesh.vertices.size());
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
        for (const int v : mesh.triangles[t])
            around[v].push_back(t);
    return around;
}

Eigen::Vector3d areaNormal(const TriangleMesh& mesh, const Triangle& t) {
    return (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
}

bool contains(const Triangle& triangle, int v) {
    return triangle[0] == v || triangle[1] == v || triangle[2] == v;
}

/// Edge collapses on a mesh whose neighbourhoods are known. A collapse touches its surroundings, which then rest until
/// the next pass.
class Collapser {
public:
    explicit Collapser(TriangleMesh& mesh)
        : m_mesh(mesh)
        , m_around(vertexTriangles(mesh))
        , m_touched(mesh.vertices.size(), false)
        , m_isGone(mesh.triangles.size(), false) {}

    bool collapse(int a, int b) {
        if (m_touched[a] || m_touched[b] || !keepsTopology(a, b))
            return false;
        const Eigen::Vector3d middle = 0.5 * (m_mesh.vertices[a] + m_mesh.vertices[b]);
        if (turnsOver(a, b, middle) || turnsOver(b, a, middle))
            return false;
        for (const int end : {a, b})
            for (const int v : neighbours(end))
                m_touched[v] = true;
        m_mesh.vertices[a] = middle;
        for (const int t : m_around[b]) {
            Triangle& triangle = m_mesh.triangles[t];
            m_isGone[t] = m_isGone[t] || contains(triangle, a);
            std::replace(triangle.begin(), triangle.end(), b, a);
        }
        return true;
    }

    /// Removes collapsed triangles and the vertices that none uses any more.
    void compact() {
        std::vector<int> newIndex(m_mesh.vertices.size(), -1);
        TriangleMesh result;
        for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t) {
            if (m_isGone[t])
                continue;
            Triangle triangle = m_mesh.triangles[t];
            for (int& v : triangle) {
                if (newIndex[v] < 0) {
                    newIndex[v] = static_cast<int>(result.vertices.size());
                    result.vertices.push_back(m_mesh.vertices[v]);
                }
                v = newIndex[v];
            }
            result.triangles.push_back(triangle);
        }
        m_mesh = std::move(result);
    }

private:
    std::vector<int> neighbours(int vertex) const {
        std::vector<int> result;
        for (const int t : m_around[vertex]) {
            for (const int v : m_mesh.triangles[t])
                if (v != vertex)
                    result.push_back(v);
        }
        std::sort(result.begin(), result.end());
        result.erase(std::unique(result.begin(), result.end()), result.end());
        return result;
    }

    /// The link condition: the ends share just the two vertices across, and those keep at least three neighbours.
    bool keepsTopology(int a, int b) const {
        const std::vector<int> ofA = neighbours(a), ofB = neighbours(b);
        std::vector<int> shared;
        std::set_intersection(ofA.begin(), ofA.end(), ofB.begin(), ofB.end(), std::back_inserter(shared));
        return shared.size() == 2 && m_around[shared[0]].size() > 4 && m_around[shared[1]].size() > 4;
    }

    bool turnsOver(int moved, int other, const Eigen::Vector3d& place) const {
        for (const int t : m_around[moved]) {
            Triangle triangle = m_mesh.triangles[t];
            if (contains(triangle, other))
                continue;
            std::rotate(triangle.begin(), std::find(triangle.begin(), triangle.end(), moved), triangle.end());
            const Eigen::Vector3d& c = m_mesh.vertices[triangle[1]];
            const Eigen::Vector3d after = (c - place).cross(m_mesh.vertices[triangle[2]] - place);
            const Eigen::Vector3d before = areaNormal(m_mesh, triangle);
            if (before.dot(after) < 0.3 * before.norm() * after.norm())
                return true;
        }
        return false;
    }

    TriangleMesh& m_mesh;
    std::vector<std::vector<int>> m_around;
    std::vector<bool> m_touched;
    std::vector<bool> m_isGone;
};

/// Edge flips on a mesh whose edges and valences are known; a triangle takes part in one flip at most.
class Flipper {
public:
    explicit Flipper(TriangleMesh& mesh)
        : m_mesh(mesh)
        , m_edges(meshEdges(mesh.triangles))
        , m_valence(mesh.vertices.size(), 0)
        , m_touched(mesh.triangles.size(), false) {
        for (const MeshEdge& edge : m_edges) {
            ++m_valence[edge.vertexA];
            ++m_valence[edge.vertexB];
            m_exists.insert(edgeKey(edge.vertexA, edge.vertexB));
        }
    }

    int run() {
        int flips = 0;
        for (const MeshEdge& edge : m_edges)
            flips += edge.triangleB >= 0 && flip(edge) ? 1 : 0;
        return flips;
    }

private:
    /// The edge a -> b of triangle A, with c across in A and d across in B.
    struct Diamond {
        int a, b, c, d;
    };

    Diamond diamondAround(const MeshEdge& edge) const {
        Triangle left = m_mesh.triangles[edge.triangleA];
        while (contains({edge.vertexA, edge.vertexB, -1}, left[2]))
            std::rotate(left.begin(), left.begin() + 1, left.end());
        const Triangle& right = m_mesh.triangles[edge.triangleB];
        const auto across =
            std::find_if(right.begin(), right.end(), [&](int v) { return v != left[0] && v != left[1]; });
        return {left[0], left[1], left[2], *across};
    }

    bool improvesValence(const Diamond& q) const {
        const auto excess = [&](int v, int change) { return std::abs(m_valence[v] + change - 6); };
        return excess(q.a, -1) + excess(q.b, -1) + excess(q.c, 1) + excess(q.d, 1) <
                   excess(q.a, 0) + excess(q.b, 0) + excess(q.c, 0) + excess(q.d, 0) &&
               m_valence[q.a] > 4 && m_valence[q.b] > 4;
    }

    bool staysFlat(const Diamond& q) const {
        constexpr double kLeastCosine = 0.8;
        const Eigen::Vector3d left = areaNormal(m_mesh, {q.a, q.b, q.c}).normalized();
        const Eigen::Vector3d right = areaNormal(m_mesh, {q.b, q.a, q.d}).normalized();
        const Eigen::Vector3d mean = (left + right).normalized();
        return left.dot(right) > kLeastCosine &&
               areaNormal(m_mesh, {q.c, q.d, q.b}).normalized().dot(mean) > kLeastCosine &&
               areaNormal(m_mesh, {q.d, q.c, q.a}).normalized().dot(mean) > kLeastCosine;
    }

    bool flip(const MeshEdge& edge) {
        if (m_touched[edge.triangleA] || m_touched[edge.triangleB])
            return false;
        const Diamond q = diamondAround(edge);
        if (m_exists.count(edgeKey(q.c, q.d)) || !improvesValence(q) || !staysFlat(q))
            return false;
        m_mesh.triangles[edge.triangleA] = {q.c, q.d, q.b};
        m_mesh.triangles[edge.triangleB] = {q.d, q.c, q.a};
        m_touched[edge.triangleA] = m_touched[edge.triangleB] = true;
        m_exists.insert(edgeKey(q.c, q.d)); // the old edge stays listed: it could come back only in the next pass
        --m_valence[q.a], --m_valence[q.b], ++m_valence[q.c], ++m_valence[q.d];
        return true;
    }

    TriangleMesh& m_mesh;
    std::vector<MeshEdge> m_edges;
    std::vector<int> m_valence;
    std::vector<bool> m_touched;
    std::unordered_set<std::uint64_t> m_exists;
};

Eigen::Vector3d gradient(const SolidField& field, const Eigen::Vector3d& point) {
    constexpr double kStepMm = 0.05;
    Eigen::Vector3d result;
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d offset = kStepMm * Eigen::Vector3d::Unit(k);
        result[k] = (field(point + offset) - field(point - offset)) / (2 * kStepMm);
    }
    return result;
}

/// A Newton step or two along the gradient, none longer than a millimetre.
Eigen::Vector3d onSurface(const SolidField& field, Eigen::Vector3d point) {
    for (int step = 0; step < 3; ++step) {
        const double value = field(point);
        if (std::abs(value) < 1e-3)
            break;
        const Eigen::Vector3d slope = gradient(field, point);
        const Eigen::Vector3d move = -value * slope / std::max(slope.squaredNorm(), 0.05);
        point += move / std::max(move.norm(), 1.0);
    }
    return point;
}

} // namespace

int collapseShortEdges(TriangleMesh& mesh, const EdgeLengthField& edgeLength) {
    struct ShortEdge {
        double relativeLength;
        int a, b;
    };
    std::vector<ShortEdge> shortEdges;
    for (const MeshEdge& edge : meshEdges(mesh.triangles)) {
        const Eigen::Vector3d& a = mesh.vertices[edge.vertexA];
        const Eigen::Vector3d& b = mesh.vertices[edge.vertexB];
        const double relative = (a - b).norm() / edgeLength(0.5 * (a + b));
        if (relative < 0.8)
            shortEdges.push_back({relative, edge.vertexA, edge.vertexB});
    }
    std::stable_sort(shortEdges.begin(), shortEdges.end(),
                     [](const ShortEdge& x, const ShortEdge& y) { return x.relativeLength < y.relativeLength; });
    Collapser collapser(mesh);
    int count = 0;
    for (const ShortEdge& edge : shortEdges)
        count += collapser.collapse(edge.a, edge.b) ? 1 : 0;
    collapser.compact();
    return count;
}

int flipEdges(TriangleMesh& mesh) {
    return Flipper(mesh).run();
}

void relaxOnto(const SolidField& field, TriangleMesh& mesh) {
    constexpr double kStep = 0.6;
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
        mesh.vertices[v] = onSurface(field, mesh.vertices[v] + kStep * along);
    }
}

TriangleMesh remeshed(const SolidField& field, TriangleMesh mesh, const EdgeLengthField& edgeLength, int iterations) {
    constexpr int kMostPasses = 40;
    const auto enough = [&mesh] { return static_cast<int>(mesh.vertices.size() / 100); };
    for (int pass = 0; pass < kMostPasses && collapseShortEdges(mesh, edgeLength) > enough(); ++pass) {
    }
    for (int iteration = 0; iteration < iterations; ++iteration) {
        flipEdges(mesh);
        relaxOnto(field, mesh);
        collapseShortEdges(mesh, edgeLength);
    }
    return mesh;
}

} // namespace core
