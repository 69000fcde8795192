// SPDX-License-Identifier: MIT
#include "core/io/segmentation/detected_points.h"

#include <gtest/gtest.h>

#include "tests/support/simulated_pass.h"

namespace {

TEST(DetectedPoints, AreTheLandmarksOfBothHandsInSpace) {
    test::SimulatedPass pass("points", 8);
    const std::vector<int> frames{40, 42, 44};
    pass.lost = {42};
    int done = 0;
    const auto views = core::detectFrames(pass.cameras, frames, pass, 30, {}, [&] { ++done; });
    EXPECT_EQ(done, 3);
    EXPECT_EQ(pass.evidenceCalls, 0) << "pictures are only looked at by the detector";
    const core::SequencePoints points = core::pointsOfDetections(pass.cameras, views);
    EXPECT_EQ(points.count(42), 0u);
    for (const int frame : {40, 44}) {
        ASSERT_EQ(points.count(frame), 1u);
        EXPECT_EQ(points.at(frame).size(), 2 * core::kLandmarkCount);
        for (std::size_t h = 0; h < 2; ++h) {
            const core::Skeleton& skeleton = pass.person[h].skeleton;
            const auto truth = core::jointPositions(skeleton, pass.motion[static_cast<std::size_t>(frame)][h]);
            for (const char* name : {"wrist", "thumb_tip", "index_mcp", "little_pip"}) {
                const auto& point = points.at(frame).at({pass.person[h].side, name});
                const Eigen::Vector3d& wanted = truth[static_cast<std::size_t>(skeleton.boneIndex(name))];
                EXPECT_LT((point.pointInWorld - wanted).norm(), 8) << name << " " << frame;
            }
        }
    }
}

TEST(DetectedPoints, EndWhereTheyAreStopped) {
    test::SimulatedPass pass("stopped", 4);
    std::stop_source stop;
    const auto views =
        core::detectFrames(pass.cameras, {40, 41, 42}, pass, 30, stop.get_token(), [&] { stop.request_stop(); });
    EXPECT_EQ(views.size(), 1u);
    EXPECT_EQ(pass.detectCalls, 1);
}

} // namespace
