// SPDX-License-Identifier: MIT
#include "core/demo_hand/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace core {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Heights of a surface above a plane, sampled at the points of a square grid. What is highest counts.
class HeightField {
public:
    HeightField(const Eigen::AlignedBox2d& box, double cellMm)
        : m_low(box.min())
        , m_cellMm(cellMm)
        , m_count(((box.sizes() / cellMm).array().floor() + 1).cast<int>().matrix())
        , m_height(static_cast<std::size_t>(m_count.prod()), -kInfinity) {}

    /// Corners: x, y in the plane, z the height.
    void raise(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
        const Eigen::Vector2d ab = (b - a).head<2>(), ac = (c - a).head<2>();
        const double area = ab.x() * ac.y() - ab.y() * ac.x();
        if (std::abs(area) < 1e-12)
            return;
        const Eigen::Array2d low = ((a.cwiseMin(b).cwiseMin(c).head<2>() - m_low) / m_cellMm).array();
        const Eigen::Array2d high = ((a.cwiseMax(b).cwiseMax(c).head<2>() - m_low) / m_cellMm).array();
        const Eigen::Array2i from = low.ceil().cast<int>().max(0);
        const Eigen::Array2i to = high.floor().cast<int>().min(m_count.array() - 1);
        for (int y = from.y(); y <= to.y(); ++y) {
            for (int x = from.x(); x <= to.x(); ++x) {
                const Eigen::Vector2d ap = m_low + m_cellMm * Eigen::Vector2d(x, y) - a.head<2>();
                const double v = (ap.x() * ac.y() - ap.y() * ac.x()) / area;
                const double w = (ab.x() * ap.y() - ab.y() * ap.x()) / area;
                if (v >= 0 && w >= 0 && v + w <= 1) {
                    double& height = m_height[static_cast<std::size_t>(y * m_count.x() + x)];
                    height = std::max(height, a.z() + v * (b.z() - a.z()) + w * (c.z() - a.z()));
                }
            }
        }
    }

    const std::vector<double>& heights() const { return m_height; }

private:
    Eigen::Vector2d m_low;
    double m_cellMm;
    Eigen::Vector2i m_count;
    std::vector<double> m_height;
};

Eigen::AlignedBox2d planeBox(const std::vector<Eigen::Vector3d>& points) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector3d& point : points)
        box.extend(Eigen::Vector2d(point.head<2>()));
    return box;
}

HeightField heights(const Eigen::AlignedBox2d& box, double cellMm, const std::vector<Eigen::Vector3d>& points,
                    const std::vector<std::array<int, 3>>& triangles) {
    HeightField field(box, cellMm);
    for (const auto& [a, b, c] : triangles)
        field.raise(points[a], points[b], points[c]);
    return field;
}

} // namespace

double gapAlong(const Eigen::Vector3d& direction, const std::vector<Eigen::Vector3d>& first,
                const std::vector<std::array<int, 3>>& firstTriangles, const std::vector<Eigen::Vector3d>& second,
                const std::vector<std::array<int, 3>>& secondTriangles, double cellMm) {
    const Eigen::Matrix3d planeFromWorld =
        Eigen::Quaterniond::FromTwoVectors(direction, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    std::vector<Eigen::Vector3d> below = first, above = second;
    for (Eigen::Vector3d& point : below)
        point = planeFromWorld * point;
    for (Eigen::Vector3d& point : above)
        point = planeFromWorld * point;
    const Eigen::AlignedBox2d shared = planeBox(below).intersection(planeBox(above));
    if (shared.isEmpty())
        return kInfinity;
    for (Eigen::Vector3d& point : above)
        point.z() = -point.z(); // its lowest becomes its highest
    const HeightField top = heights(shared, cellMm, below, firstTriangles);
    const HeightField bottom = heights(shared, cellMm, above, secondTriangles);
    double gap = kInfinity;
    for (std::size_t i = 0; i < top.heights().size(); ++i)
        gap = std::min(gap, -bottom.heights()[i] - top.heights()[i]);
    return gap;
}

} // namespace core
