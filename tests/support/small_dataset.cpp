// SPDX-License-Identifier: MIT
#include "tests/support/small_dataset.h"

namespace test {

SmallDataset smallDataset() {
    SmallDataset small;
    core::Dataset& dataset = small.dataset;
    dataset.name = "small";
    dataset.cameras = cameraRing(3);
    dataset.hands = {smallHand(core::Side::Left), smallHand(core::Side::Right)};
    dataset.handFiles = {"hands/left.json", "hands/right.json"};
    core::Sequence first{"first", 5, 25, {}, "", "motion/first.json", "annotations/first.sqlite"},
        second{"second", 7, 50, {}, "", "", ""};
    first.views = {};
    for (const core::Camera& camera : dataset.cameras) {
        first.views.push_back({camera.name, core::ViewKind::Rendered, "", 0});
        second.views.push_back({camera.name, core::ViewKind::None, "", 0});
    }
    dataset.sequences = {first, second};
    core::Motion motion;
    for (int f = 0; f < first.frameCount; ++f) {
        core::HandPoses poses;
        for (const core::HandModel& hand : dataset.hands) {
            core::Pose pose = hand.skeleton.restPose();
            pose.head<3>() << 10.0 * f - 60, hand.side == core::Side::Left ? -30 : 30, 1 / 3.0;
            pose.segment<3>(3) << 0.1 * f, -0.05, 0.02;
            pose.tail<3>() << -0.2 * f, 0.05 * f, -0.1 * f;
            poses.push_back(pose);
        }
        motion.push_back(poses);
    }
    small.motions = {motion, {}};
    return small;
}

void writeSmallDataset(const std::filesystem::path& folder) {
    const SmallDataset small = smallDataset();
    core::writeDataset(small.dataset, small.motions, folder);
}

} // namespace test
