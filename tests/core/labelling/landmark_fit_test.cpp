// SPDX-License-Identifier: MIT
#include "core/labelling/landmark_fit.h"

#include <gtest/gtest.h>

#include "core/labelling/hand_assignment.h"
#include "tests/support/simulated_pass.h"

namespace {

using test::SimulatedPass;

std::vector<core::SpatialHand> handsOf(SimulatedPass& scene, int frame) {
    auto hands = core::groupDetections(scene.cameras, scene.detect(frame, {}));
    // left one first
    if (hands.size() == 2 && hands[0].rightnessLogOdds() > hands[1].rightnessLogOdds())
        std::swap(hands[0], hands[1]);
    return hands;
}

TEST(LandmarkFit, BringsAModelToLandmarksFromNoPoseAtAll) {
    SimulatedPass scene("fit", 8, 1);
    for (const int frame : {0, 60, 120}) {
        const auto hands = handsOf(scene, frame);
        ASSERT_EQ(hands.size(), 2u);
        for (std::size_t h = 0; h < 2; ++h) {
            const core::HandModel& model = scene.hands[h];
            const auto fit = core::fitToLandmarks(model, hands[h], core::usualStarts(model.skeleton));
            ASSERT_TRUE(fit);
            const auto truth = core::jointPositions(model.skeleton, scene.motion[static_cast<std::size_t>(frame)][h]);
            const auto found = core::jointPositions(model.skeleton, fit->pose);
            double sum = 0;
            for (std::size_t b = 0; b < truth.size(); ++b)
                sum += (found[b] - truth[b]).norm();
            EXPECT_LT(sum / static_cast<double>(truth.size()), 5) << "frame " << frame; // the bias is some of it
            EXPECT_LT(fit->misfit, 1);
            for (const Eigen::Matrix3d& covariance : fit->jointCovarianceMm2)
                EXPECT_GT(covariance.determinant(), 0);
        }
    }
}

TEST(LandmarkFit, AWrongLandmarkDoesNotPullTheHandAlong) {
    SimulatedPass scene("outlier", 8, 1);
    auto hand = handsOf(scene, 30).front();
    const core::HandModel& model = scene.hands.front();
    const auto clean = core::fitToLandmarks(model, hand, core::usualStarts(model.skeleton));
    hand.landmarks[8]->triangulated.pointInWorld += Eigen::Vector3d(60, 40, 0);
    const auto fit = core::fitToLandmarks(model, hand, core::usualStarts(model.skeleton));
    ASSERT_TRUE(clean && fit);
    const auto a = core::jointPositions(model.skeleton, clean->pose),
               b = core::jointPositions(model.skeleton, fit->pose);
    const int middle = model.skeleton.boneIndex("middle_tip"), wrist = 0;
    EXPECT_LT((a[static_cast<std::size_t>(middle)] - b[static_cast<std::size_t>(middle)]).norm(), 3);
    EXPECT_LT((a[wrist] - b[wrist]).norm(), 3);
}

TEST(LandmarkFit, TheOtherSidesModelFitsWorse) {
    SimulatedPass scene("sides", 8, 1);
    for (const int frame : {0, 60}) { // in other poses a hand is much like its mirror image
        const auto hands = handsOf(scene, frame);
        for (std::size_t h = 0; h < 2; ++h) {
            const auto own = core::fitToLandmarks(scene.hands[h], hands[h], core::usualStarts(scene.hands[h].skeleton));
            const auto other =
                core::fitToLandmarks(scene.hands[1 - h], hands[h], core::usualStarts(scene.hands[1 - h].skeleton));
            EXPECT_LT(own->misfit, 0.6 * other->misfit) << "frame " << frame << " hand " << h;
        }
    }
}

TEST(HandAssignment, FollowsTheModelsWhereTheDetectorIsUnsureOfSides) {
    SimulatedPass scene("assignment", 8, 1);
    auto detections = scene.detect(60, {});
    for (auto& view : detections) // left and right exchanged, without much conviction
        for (core::DetectedHand& hand : view)
            hand.rightness = hand.rightness > 0.5 ? 0.47 : 0.53;
    const auto hands = core::groupDetections(scene.cameras, detections);
    const auto assigned = core::assignHands(scene.hands, {{60, hands}});
    for (std::size_t h = 0; h < 2; ++h) {
        ASSERT_TRUE(assigned.at(60)[h]);
        const auto truth = core::jointPositions(scene.hands[h].skeleton, scene.motion[60][h]);
        const auto base = static_cast<std::size_t>(scene.hands[h].skeleton.boneIndex("middle_mcp"));
        EXPECT_LT(
            (assigned.at(60)[h]->landmarks[core::kMiddleBaseLandmark]->triangulated.pointInWorld - truth[base]).norm(),
            10);
    }
}

} // namespace
