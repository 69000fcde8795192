// SPDX-License-Identifier: MIT
#include "tests/support/shapes/solids.h"

#include <cmath>
#include <numbers>

namespace test {

core::TriangleMesh surfaceOfRevolution(const std::vector<Ring>& rings, double firstX, double lastX, int sectors) {
    core::TriangleMesh mesh;
    mesh.vertices.emplace_back(firstX, 0, 0);
    for (const Ring& ring : rings) {
        for (int j = 0; j < sectors; ++j) {
            const double angle = 2 * std::numbers::pi * j / sectors;
            mesh.vertices.emplace_back(ring.x, ring.radius * std::cos(angle), ring.radius * std::sin(angle));
        }
    }
    mesh.vertices.emplace_back(lastX, 0, 0);
    const int count = static_cast<int>(rings.size()), last = static_cast<int>(mesh.vertices.size()) - 1;
    const auto at = [&](int ring, int j) { return 1 + ring * sectors + j % sectors; };
    for (int j = 0; j < sectors; ++j) {
        mesh.triangles.push_back({0, at(0, j + 1), at(0, j)});
        for (int i = 0; i + 1 < count; ++i) {
            mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            mesh.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
        }
        mesh.triangles.push_back({last, at(count - 1, j), at(count - 1, j + 1)});
    }
    return mesh;
}

core::TriangleMesh ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& radii, int rings, int sectors) {
    std::vector<Ring> profile;
    for (int i = 1; i < rings; ++i) {
        const double angle = std::numbers::pi * i / rings;
        profile.push_back({-std::cos(angle), std::sin(angle)});
    }
    core::TriangleMesh mesh = surfaceOfRevolution(profile, -1, 1, sectors);
    for (Eigen::Vector3d& v : mesh.vertices)
        v = centre + radii.cwiseProduct(v);
    return mesh;
}

core::TriangleMesh ball(const Eigen::Vector3d& centre, double radius, int rings, int sectors) {
    return ellipsoid(centre, Eigen::Vector3d::Constant(radius), rings, sectors);
}

core::TriangleMesh capsule(double length, double radius, double ringStep, int sectors) {
    std::vector<Ring> profile;
    constexpr int kCapRings = 6;
    for (int i = 1; i < kCapRings; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / kCapRings;
        profile.push_back({-radius * std::cos(angle), radius * std::sin(angle)});
    }
    const int middle = static_cast<int>(std::ceil(length / ringStep));
    for (int i = 0; i <= middle; ++i)
        profile.push_back({length * i / middle, radius});
    for (int i = kCapRings - 1; i > 0; --i) {
        const double angle = 0.5 * std::numbers::pi * i / kCapRings;
        profile.push_back({length + radius * std::cos(angle), radius * std::sin(angle)});
    }
    return surfaceOfRevolution(profile, -radius, length + radius, sectors);
}

core::TriangleMesh moved(core::TriangleMesh mesh, const core::RigidMotion& motion) {
    for (Eigen::Vector3d& v : mesh.vertices)
        v = motion * v;
    return mesh;
}

void append(core::TriangleMesh& mesh, const core::TriangleMesh& part) {
    const int offset = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& [a, b, c] : part.triangles)
        mesh.triangles.push_back({a + offset, b + offset, c + offset});
}

} // namespace test
