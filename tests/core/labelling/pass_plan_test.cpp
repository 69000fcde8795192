// SPDX-License-Identifier: MIT
#include "core/labelling/pass_plan.h"

#include <gtest/gtest.h>

#include "tests/support/random_values.h"

namespace {

TEST(KeyFrames, AreSoFarApartAndHaveBothEnds) {
    EXPECT_EQ(core::keyFrames({0, 1, 2, 3, 4, 5, 6, 7}, 3), (std::vector{0, 3, 6, 7}));
    EXPECT_EQ(core::keyFrames({5, 19, 33}, 10), (std::vector{5, 19, 33}));
    EXPECT_TRUE(core::keyFrames({}, 3).empty());
}

TEST(EvenlyDrawn, TakesNeverMoreThanThereAre) {
    EXPECT_EQ(core::evenlyDrawn({1, 2, 3}, 9), (std::vector{1, 2, 3}));
    EXPECT_EQ(core::evenlyDrawn({0, 1, 2, 3, 4, 5, 6, 7, 8}, 3), (std::vector{1, 4, 7}));
}

TEST(PredictedPoses, GoOnAsTheyWent) {
    test::RandomValues random("prediction");
    core::Pose before = random.vector(9, 0.4);
    Eigen::VectorXd step = random.vector(9, 0.1);
    const core::Pose last = core::retract(before, step);
    const core::HandPoses predicted = core::predictedPoses({last}, {before}, 1);
    EXPECT_NEAR((predicted[0] - core::retract(last, step)).norm(), 0, 1e-12);
    EXPECT_EQ(core::predictedPoses({last, {}}, {}, 1)[0], last);
    EXPECT_EQ(core::predictedPoses({last}, {core::Pose()}, 1)[0], last);
}

TEST(TrackQueue, TakesStepsFromTheSurestFrameFirst) {
    core::TrackQueue queue({0, 1, 2, 3, 40}, 30);
    queue.add(1, 0.3);
    queue.add(3, 0.1);
    const auto first = queue.next(), second = queue.next(), third = queue.next();
    ASSERT_TRUE(first && second && third);
    EXPECT_EQ(first->from, 3);
    EXPECT_EQ(first->to, 2);
    EXPECT_EQ(first->direction, -1);
    EXPECT_EQ(second->from, 1);
    EXPECT_EQ(third->from, 1);
    EXPECT_NE(second->to, third->to);
    EXPECT_FALSE(queue.next()); // 40 is too far away
    queue.add(1, 0.2, -1);
    EXPECT_EQ(queue.next()->to, 0);
    EXPECT_FALSE(queue.next());
}

} // namespace
