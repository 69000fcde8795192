// SPDX-License-Identifier: MIT
#include "tests/support/tiny_hands.h"

#include <cmath>

namespace test {

core::TriangleMesh box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    core::TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        mesh.vertices.emplace_back(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                                   corner & 4 ? high.z() : low.z());
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

core::HandModel tinyHand(core::Side side) {
    const double x = side == core::Side::Left ? -60 : 60;
    core::HandModel hand;
    hand.side = side;
    hand.mesh = box({x - 20, -10, 0}, {x + 20, 10, 60});
    const core::TriangleMesh finger = box({x - 8, -8, 60}, {x + 8, 8, 100});
    const int offset = static_cast<int>(hand.mesh.vertices.size());
    hand.mesh.vertices.insert(hand.mesh.vertices.end(), finger.vertices.begin(), finger.vertices.end());
    for (const auto& triangle : finger.triangles)
        hand.mesh.triangles.push_back({triangle[0] + offset, triangle[1] + offset, triangle[2] + offset});
    core::Bone palm{"forearm", -1, {}, 60};
    palm.worldFromBoneAtRest.translation = {x, 0, 0};
    core::Bone index{"index_mcp", 0, {}, 40};
    index.worldFromBoneAtRest.translation = {x, 0, 60};
    hand.skeleton.bones = {palm, index};
    hand.skeleton.dofs = {{"index_mcp.flexion", 1, Eigen::Vector3d::UnitY(), -1.5, 1.5}};
    hand.skeleton.centreAtRest = {x, 0, 40};
    for (std::size_t v = 0; v < hand.mesh.vertices.size(); ++v) {
        hand.weights.firstEntry.push_back(static_cast<int>(v));
        hand.weights.entries.push_back({v < 8 ? 0 : 1, 1.0});
    }
    hand.weights.firstEntry.push_back(static_cast<int>(hand.mesh.vertices.size()));
    return hand;
}

std::vector<core::HandModel> tinyHands() {
    return {tinyHand(core::Side::Left), tinyHand(core::Side::Right)};
}

core::Motion tinyMotion(int frames) {
    core::Motion motion;
    for (int frame = 0; frame < frames; ++frame) {
        core::Pose pose(7);
        pose << 0.5 * frame, 10 * std::sin(0.1 * frame), 0.2 * frame, 0.01 * frame, 0, 0.005 * frame, 0.02 * frame;
        motion.push_back({pose, pose});
    }
    return motion;
}

} // namespace test
