// SPDX-License-Identifier: MIT
#include "core/fitting/best_fit.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/fitting/method_name.h"
#include "tests/support/fitting_scene.h"

namespace {

using core::FitAttempt;
using core::FitTermination;

class BestFit : public testing::Test {
protected:
    FitAttempt fit(bool live, std::stop_token stop = {}, const core::FitProgress& progress = {}) {
        return fit(core::parseMethod(live ? "best:live=1" : "best"), stop, progress);
    }
    FitAttempt fit(const core::Method& method, std::stop_token stop = {}, const core::FitProgress& progress = {}) {
        core::FitProfile profile;
        core::PoseRefiner refiner(m_hands, m_scene.cameras, m_targets, m_scene.start, 1, profile);
        return core::fitBest(refiner, method, m_scene.start, stop, progress);
    }

    test::FittingScene m_scene{"best fit", 5};
    core::FittingHands m_hands = core::makeFittingHands(m_scene.hands);
    std::vector<core::CameraTarget> m_targets = core::makeFitTargets(m_scene.cameras, m_scene.masks, {}, 1);
};

TEST_F(BestFit, ComesNearTheTruth) {
    ASSERT_GT(m_scene.errorMm(m_scene.start), 5);
    EXPECT_LT(m_scene.errorMm(fit(false).poses), 0.8);
}

TEST_F(BestFit, TheLiveVariantIsCoarserAndShorter) {
    const FitAttempt live = fit(true), full = fit(false);
    EXPECT_LT(m_scene.errorMm(live.poses), 3);
    EXPECT_LT(live.history.size(), full.history.size());
}

TEST_F(BestFit, HistoryLeadsFromTheStartToTheResult) {
    const FitAttempt result = fit(false);
    ASSERT_FALSE(result.history.empty());
    core::HandPoses before = m_scene.start;
    for (std::size_t i = 0; i < result.history.size(); ++i) {
        const core::FitIteration& record = result.history[i];
        EXPECT_EQ(record.iteration, static_cast<int>(i));
        EXPECT_GT(record.matches, 0);
        EXPECT_GT(record.costMm2, 0);
        EXPECT_NEAR(record.stepMm, core::meanJointDistanceMm(m_scene.hands, before, record.poses), 1e-9);
        before = record.poses;
    }
    EXPECT_EQ(before[0], result.poses[0]);
    EXPECT_EQ(before[1], result.poses[1]);
    EXPECT_TRUE(result.termination == FitTermination::Converged || result.termination == FitTermination::MaxIterations);
}

TEST_F(BestFit, ProgressNeverGoesBackOrBeyondTheEnd) {
    int last = 0, calls = 0;
    fit(false, {}, [&](int done, int total) {
        EXPECT_GE(done, last);
        EXPECT_LE(done, total);
        last = done;
        ++calls;
    });
    EXPECT_GT(calls, 10);
}

TEST_F(BestFit, StopsWhenAskedToAndKeepsWhatItHas) {
    for (const int when : {1, 5, 11}) {
        std::stop_source source;
        const FitAttempt result = fit(false, source.get_token(), [&](int done, int) {
            if (done == when)
                source.request_stop();
        });
        EXPECT_EQ(result.termination, FitTermination::Stopped);
        ASSERT_EQ(result.history.size(), static_cast<std::size_t>(when));
        EXPECT_EQ(result.poses[0], result.history.back().poses[0]);
    }
}

TEST_F(BestFit, EveryOptionChangesTheFit) {
    const FitAttempt all = fit(false);
    for (const char* const idea : {"palm=0", "coarse=0", "wide=0", "across=0", "prior=0", "learnt=0", "polish=0",
                                   "noise=0", "both=1", "within=1", "robust=5"}) {
        const FitAttempt without = fit(core::parseMethod(std::string("best:") + idea));
        EXPECT_GT((without.poses[0] - all.poses[0]).norm(), 1e-9) << idea << " changed nothing";
        EXPECT_LT(m_scene.errorMm(without.poses), m_scene.errorMm(m_scene.start)) << idea;
    }
}

TEST_F(BestFit, WithoutNoiseOrPriorNothingIsLearnt) {
    for (const std::string name : {"best:noise=0", "best:prior=0", "best:live=1"}) {
        const FitAttempt with = fit(core::parseMethod(name)), without = fit(core::parseMethod(name + ":learnt=0"));
        EXPECT_EQ(with.poses[0], without.poses[0]) << name;
        EXPECT_EQ(with.poses[1], without.poses[1]) << name;
    }
}

TEST_F(BestFit, ContoursThatAreEquallyOffTriggerNoRestarts) {
    for (cv::Mat& mask : m_scene.masks)
        cv::dilate(mask, mask, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
    m_targets = core::makeFitTargets(m_scene.cameras, m_scene.masks, {}, 1);
    int relative = 0, absolute = 0;
    fit(
        core::parseMethod("best"), {}, [&](int, int) { ++relative; });
    fit(core::parseMethod("best:noise=0"), {}, [&](int, int) { ++absolute; });
    EXPECT_LT(2 * relative, absolute) << "iterations of all attempts";
}

TEST_F(BestFit, FromTheTruthItStaysThere) {
    m_scene.start = m_scene.truth;
    EXPECT_LT(m_scene.errorMm(fit(false).poses), 0.5);
}

} // namespace
