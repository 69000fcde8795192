// SPDX-License-Identifier: MIT
#include "tests/support/shapes/penetration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace test {

namespace {

/// Triangles by the squares of the x-y plane that they touch, so that a ray along z meets few of them.
class ColumnIndex {
public:
    ColumnIndex(const std::vector<Eigen::Vector3d>& vertices, const std::vector<std::array<int, 3>>& triangles)
        : m_vertices(vertices)
        , m_triangles(triangles) {
        for (const Eigen::Vector3d& v : vertices)
            m_box.extend(v);
        m_columns.resize(static_cast<std::size_t>(column(m_box.max().x(), 0) + 1) *
                         static_cast<std::size_t>(column(m_box.max().y(), 1) + 1));
        for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
            Eigen::AlignedBox3d box;
            for (const int v : triangles[t])
                box.extend(vertices[v]);
            for (int y = column(box.min().y(), 1); y <= column(box.max().y(), 1); ++y)
                for (int x = column(box.min().x(), 0); x <= column(box.max().x(), 0); ++x)
                    m_columns[place(x, y)].push_back(t);
        }
    }

    bool isInside(const Eigen::Vector3d& point) const {
        if (!m_box.contains(point))
            return false;
        // An offset keeps the ray off the vertices and edges.
        const double px = point.x() + 1.234e-6, py = point.y() + 2.345e-6;
        int above = 0;
        for (const int t : m_columns[place(column(point.x(), 0), column(point.y(), 1))]) {
            const Eigen::Vector3d& a = m_vertices[m_triangles[t][0]];
            const Eigen::Vector3d& b = m_vertices[m_triangles[t][1]];
            const Eigen::Vector3d& c = m_vertices[m_triangles[t][2]];
            const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
            const double v = ((px - a.x()) * (c.y() - a.y()) - (py - a.y()) * (c.x() - a.x())) / area;
            const double w = ((b.x() - a.x()) * (py - a.y()) - (b.y() - a.y()) * (px - a.x())) / area;
            if (v >= 0 && w >= 0 && v + w <= 1)
                above += a.z() + v * (b.z() - a.z()) + w * (c.z() - a.z()) > point.z() ? 1 : 0;
        }
        return above % 2 == 1;
    }

private:
    static constexpr double kCellMm = 4;

    int column(double value, int axis) const { return static_cast<int>((value - m_box.min()[axis]) / kCellMm); }
    std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(column(m_box.max().x(), 0) + 1) +
               static_cast<std::size_t>(x);
    }

    const std::vector<Eigen::Vector3d>& m_vertices;
    const std::vector<std::array<int, 3>>& m_triangles;
    Eigen::AlignedBox3d m_box;
    std::vector<std::vector<int>> m_columns;
};

double distanceToSegment(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Vector3d ab = b - a;
    const double t = std::clamp((point - a).dot(ab) / std::max(ab.squaredNorm(), 1e-30), 0.0, 1.0);
    return (point - a - t * ab).norm();
}

} // namespace

double distanceToTriangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                          const Eigen::Vector3d& c) {
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    const bool isAboveIt = normal.cross(b - a).dot(point - a) >= 0 && normal.cross(c - b).dot(point - b) >= 0 &&
                           normal.cross(a - c).dot(point - c) >= 0;
    if (isAboveIt && normal.norm() > 1e-12)
        return std::abs((point - a).dot(normal.normalized()));
    return std::min({distanceToSegment(point, a, b), distanceToSegment(point, b, c), distanceToSegment(point, c, a)});
}

double deepestInside(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& vertices,
                     const std::vector<std::array<int, 3>>& triangles) {
    const ColumnIndex index(vertices, triangles);
    double deepest = 0;
    for (const Eigen::Vector3d& point : points) {
        if (!index.isInside(point))
            continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& [a, b, c] : triangles)
            if ((vertices[a] - point).norm() < nearest + 20)
                nearest = std::min(nearest, distanceToTriangle(point, vertices[a], vertices[b], vertices[c]));
        deepest = std::max(deepest, nearest);
    }
    return deepest;
}

} // namespace test
