// SPDX-License-Identifier: MIT
#include "core/io/demo/demo_dataset.h"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "core/hand/motion.h"
#include "tests/support/shapes/penetration.h"
#include "tests/support/temporary_folder.h"

namespace {

const core::NewDataset& demo() {
    static const core::NewDataset kDemo = core::makeDemoDataset();
    return kDemo;
}

TEST(DemoDataset, HasFourSequencesEightViewsAndTwoHands) {
    const core::Dataset& dataset = demo().dataset;
    ASSERT_EQ(dataset.sequences.size(), 4U);
    EXPECT_EQ(dataset.cameras.size(), 8U);
    EXPECT_EQ(dataset.hands.size(), 2U);
    for (std::size_t s = 0; s < 4; ++s) {
        EXPECT_GE(dataset.sequences[s].frameCount, 150);
        EXPECT_EQ(dataset.sequences[s].framesPerSecond, 50);
        EXPECT_EQ(dataset.sequences[s].views.size(), 8U);
        EXPECT_EQ(demo().motions[s].size(), static_cast<std::size_t>(dataset.sequences[s].frameCount));
    }
    for (const core::Camera& camera : dataset.cameras)
        EXPECT_EQ(camera.size, (core::ImageSize{1080, 1920}));
}

TEST(DemoDataset, MovesAsFastAsThePublishedSequences) {
    const std::map<int, double> published{{1, 1.8}, {5, 8.5}, {10, 16.6}, {15, 24.4}};
    for (const auto& [apart, expected] : published) {
        double sum = 0;
        for (const core::Motion& motion : demo().motions) {
            const double displacement = core::meanDisplacementMm(demo().dataset.hands, motion, apart);
            EXPECT_NEAR(displacement, expected, 0.25 * expected);
            sum += displacement;
        }
        EXPECT_NEAR(sum / 4, expected, 0.25 * expected);
    }
}

TEST(DemoDataset, StaysWithinTheLimitsAndMovesSmoothly) {
    for (const core::Motion& motion : demo().motions) {
        for (std::size_t f = 0; f < motion.size(); ++f) {
            for (std::size_t h = 0; h < 2; ++h) {
                const core::Skeleton& skeleton = demo().dataset.hands[h].skeleton;
                for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
                    const double angle = motion[f][h][core::kRigidDofs + static_cast<Eigen::Index>(d)];
                    EXPECT_GE(angle, skeleton.dofs[d].minRad - 1e-9) << skeleton.dofs[d].name;
                    EXPECT_LE(angle, skeleton.dofs[d].maxRad + 1e-9) << skeleton.dofs[d].name;
                }
                if (f >= 2) {
                    const auto a = core::jointPositions(skeleton, motion[f - 2][h]);
                    const auto b = core::jointPositions(skeleton, motion[f - 1][h]);
                    const auto c = core::jointPositions(skeleton, motion[f][h]);
                    for (std::size_t j = 0; j < a.size(); ++j)
                        EXPECT_LT((a[j] - 2 * b[j] + c[j]).norm(), 5) << "frame " << f; // mm per frame^2
                }
            }
        }
    }
}

TEST(DemoDataset, HandsComeCloseWithoutPassingThroughEachOther) {
    const std::vector<core::HandModel>& hands = demo().dataset.hands;
    for (std::size_t s = 0; s < demo().motions.size(); ++s) {
        double deepest = 0;
        for (std::size_t f = 0; f < demo().motions[s].size(); f += 4) {
            const core::HandPoses& poses = demo().motions[s][f];
            const auto left = core::posedVertices(hands[0], poses[0]);
            const auto right = core::posedVertices(hands[1], poses[1]);
            deepest = std::max({deepest, test::deepestInside(left, right, hands[1].mesh.triangles),
                                test::deepestInside(right, left, hands[0].mesh.triangles)});
        }
        EXPECT_LT(deepest, 4) << demo().dataset.sequences[s].name;
    }
}

TEST(DemoDataset, EveryViewSeesBothHandsAllTheTime) {
    for (const Eigen::Vector3d& point : core::recordedVolume(demo().dataset.hands, demo().motions)) {
        for (const core::Camera& camera : demo().dataset.cameras) {
            const auto px = core::project(camera, point);
            ASSERT_TRUE(px.has_value());
            EXPECT_GT(px->minCoeff(), 20);
            EXPECT_LT(px->x(), 1060);
            EXPECT_LT(px->y(), 1900);
        }
    }
}

TEST(DemoDataset, ReadsBackAsItWasWritten) {
    const test::TemporaryFolder folder;
    core::writeDataset(demo().dataset, demo().motions, folder.path() / "demo");
    const core::Dataset read = core::readDataset(folder.path() / "demo");
    ASSERT_EQ(read.sequences.size(), 4U);
    EXPECT_EQ(read.hands[1].mesh.triangles, demo().dataset.hands[1].mesh.triangles);
    const core::Motion motion = core::readMotion(read, read.sequences[2]);
    ASSERT_EQ(motion.size(), demo().motions[2].size());
    EXPECT_TRUE(motion[77][1].isApprox(demo().motions[2][77][1], 1e-12));
}

} // namespace
