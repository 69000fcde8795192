// SPDX-License-Identifier: MIT
#include "tests/support/small_hand.h"

namespace test {

core::HandModel smallHand(core::Side side) {
    core::HandModel hand;
    hand.side = side;
    const char* names[] = {"forearm", "index_mcp", "index_pip"};
    for (int b = 0; b < 3; ++b) {
        core::Bone bone;
        bone.name = names[b];
        bone.parent = b - 1;
        bone.worldFromBoneAtRest.translation = {40.0 * b, side == core::Side::Left ? 1.25 : -1.25, 3.0};
        bone.worldFromBoneAtRest.rotation = core::rotationExp({0.1 * b, 0.02, -0.05 * b});
        bone.lengthMm = 40;
        hand.skeleton.bones.push_back(bone);
    }
    hand.skeleton.dofs = {{"index_mcp.flexion", 1, Eigen::Vector3d::UnitY(), -1.5, 0.25},
                          {"index_mcp.abduction", 1, Eigen::Vector3d::UnitZ(), -0.3, 0.3},
                          {"index_pip.flexion", 2, Eigen::Vector3d(0.6, 0.8, 0), -1.6, 0.1}};
    hand.skeleton.centreAtRest = {40, 0, 1};
    for (int v = 0; v < 8; ++v)
        hand.mesh.vertices.emplace_back(v & 1 ? 120.1 : -1 / 3.0, v & 2 ? 8 : -8, v & 4 ? 6 : -6);
    hand.mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                           {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    hand.weights.firstEntry = {0};
    for (int v = 0; v < 8; ++v) {
        if (v & 1) {
            hand.weights.entries.push_back({1, 1 / 3.0});
            hand.weights.entries.push_back({2, 1 - 1 / 3.0});
        } else {
            hand.weights.entries.push_back({0, 1});
        }
        hand.weights.firstEntry.push_back(static_cast<int>(hand.weights.entries.size()));
    }
    return hand;
}

} // namespace test
