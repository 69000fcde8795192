// SPDX-License-Identifier: MIT
#include "core/io/footage/frame_times.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace {

using core::FrameGap;
using Gaps = std::vector<FrameGap>;

/// Times of `count` frames of a camera with this step; before frame `at` it lost `lost`. Rounded to `unit` seconds.
std::vector<double> times(int count, double step, const std::vector<std::pair<int, int>>& losses, double unit = 0) {
    std::vector<double> result;
    double instant = 7;
    for (int i = 0; i < count; ++i) {
        for (const auto& [at, lost] : losses)
            instant += at == i ? lost : 0;
        const double time = 3.2 + instant * step;
        result.push_back(unit > 0 ? std::round(time / unit) * unit : time);
        instant += 1;
    }
    return result;
}

TEST(FrameTimes, ShowWhatACameraLost) {
    const core::FrameTiming timing = core::analyseTimes(times(1000, 1.0 / 30, {{500, 8}}));
    EXPECT_TRUE(timing.isSane);
    EXPECT_EQ(timing.gaps, (Gaps{{499, 8}}));
    EXPECT_EQ(core::roundedRate(timing.stepSec), 30);
    EXPECT_EQ(core::analyseTimes(times(300, 0.01, {{1, 1}, {2, 1}, {3, 2}, {299, 40}})).gaps,
              (Gaps{{0, 1}, {1, 1}, {2, 2}, {298, 40}}));
    EXPECT_TRUE(core::analyseTimes(times(1000, 1.0 / 30, {})).gaps.empty());
}

TEST(FrameTimes, AreNotMisledByStampsInMilliseconds) {
    for (const double rate : {24000.0 / 1001, 30.0, 30000.0 / 1001, 60.0, 120.0, 240.0, 300.0, 500.0}) {
        const core::FrameTiming timing = core::analyseTimes(times(20'000, 1 / rate, {{77, 1}, {9000, 3}}, 0.001));
        EXPECT_TRUE(timing.isSane) << rate;
        EXPECT_EQ(timing.gaps, (Gaps{{76, 1}, {8999, 3}})) << rate;
        EXPECT_NEAR(core::roundedRate(timing.stepSec), rate, 1e-6 * rate);
    }
}

TEST(FrameTimes, AreNotMisledByJitter) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0, 0.0015);
    std::vector<double> jittered = times(2000, 1.0 / 60, {{1200, 2}});
    for (double& time : jittered)
        time += noise(random);
    EXPECT_EQ(core::analyseTimes(jittered).gaps, (Gaps{{1199, 2}}));
    std::vector<double> late = times(200, 0.04, {});
    late[50] += 0.03;  // its own stamp is late, the next frame is not
    late[90] -= 0.025; // early
    late[120] += 0.038, late[121] += 0.02;
    EXPECT_TRUE(core::analyseTimes(late).isSane);
    EXPECT_TRUE(core::analyseTimes(late).gaps.empty());
}

TEST(FrameTimes, ThatMakeNoSenseGiveNoGaps) {
    EXPECT_FALSE(core::analyseTimes({}).isSane);
    EXPECT_FALSE(core::analyseTimes({1}).isSane);
    EXPECT_FALSE(core::analyseTimes({0, 1, 1, 2, 3, 4}).isSane) << "twice the same";
    EXPECT_FALSE(core::analyseTimes({0, 1, 4, 5, 6, 4.5, 7}).isSane) << "back in time";
    EXPECT_FALSE(core::analyseTimes({0, 1, 3.5, 4, 8, 9.7, 10, 13}).isSane) << "no step is usual";
}

TEST(FrameTimes, ThatClaimAGapOfBillionsOfFramesAreNotSane) {
    const core::FrameTiming day = core::analyseTimes(times(20, 0.02, {{10, 4'320'000}}));
    EXPECT_TRUE(day.isSane);
    EXPECT_EQ(day.gaps, (Gaps{{9, 4'320'000}}));
    for (const double last : {1e9, 1e18, 1e300}) {
        std::vector<double> claimed = times(20, 1, {{5, 2}});
        claimed.push_back(last);
        const core::FrameTiming timing = core::analyseTimes(claimed);
        EXPECT_FALSE(timing.isSane) << last;
        EXPECT_TRUE(timing.gaps.empty()) << last;
    }
}

TEST(FrameTimes, RatesAreThoseInUse) {
    EXPECT_EQ(core::roundedRate(0.04), 25);
    EXPECT_EQ(core::roundedRate(1 / 29.97002), 30 / 1.001);
    EXPECT_NEAR(core::roundedRate(1 / 33.4), 33.4, 1e-9);
    EXPECT_EQ(core::roundedRate(0), 0);
}

} // namespace
