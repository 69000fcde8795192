// SPDX-License-Identifier: MIT
#include "core/fitting/pose_estimator.h"

#include <filesystem>
#include <limits>
#include <map>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/error.h"
#include "core/fitting/method_name.h"
#include "tests/support/fitting_scene.h"

namespace {

using core::FitResult;
using core::FitTermination;
using core::HandPoses;
using core::parseMethod;
using core::PoseEstimator;

class Estimator : public testing::Test {
protected:
    FitResult fit(const std::string& method, int threads = 1) const {
        return m_estimator.fit(m_scene.masks, m_scene.start, parseMethod(method), {}, {}, threads);
    }
    /// What() of the error that the input brings about; empty if it is accepted.
    std::string complaint(const std::vector<cv::Mat>& masks, const HandPoses& start) const {
        try {
            m_estimator.fit(masks, start, parseMethod("ch"));
        } catch (const core::Error& error) {
            EXPECT_EQ(error.code(), core::ErrorCode::BadInput);
            return error.what();
        }
        return "";
    }

    test::FittingScene m_scene{"pose estimator"};
    PoseEstimator m_estimator{m_scene.hands, m_scene.cameras};
};

TEST_F(Estimator, EveryMethodFindsThePose) {
    ASSERT_GT(m_scene.errorMm(m_scene.start), 6);
    const std::vector<std::pair<std::string, double>> bounds{{"ch", 2.2},
                                                             {"ch:iterations=60", 1.0},
                                                             {"ch:schedule=paper", 1.2},
                                                             {"dch-thres", 2.0},
                                                             {"dch-thres:iterations=60", 0.8},
                                                             {"dch-thres:schedule=paper", 0.7},
                                                             {"dch-quant", 1.5},
                                                             {"dch-quant2", 2.2},
                                                             {"dch-dt3", 1.4},
                                                             {"best", 0.6},
                                                             {"best:live=1", 0.9}};
    for (const auto& [method, boundMm] : bounds) {
        const FitResult result = fit(method);
        EXPECT_LT(m_scene.errorMm(result.poses), boundMm) << method;
        EXPECT_NE(result.termination, FitTermination::NoMatches) << method;
        EXPECT_GT(result.seconds, 0);
        RecordProperty("error_um_" + method, static_cast<int>(1000 * m_scene.errorMm(result.poses)));
    }
}

TEST_F(Estimator, ForearmsDrawTheHandsAwayOnlyIfTheyAreNotCut) {
    test::drawForearms(m_scene, m_scene.masks);
    for (const char* const method : {"best", "dch-thres"}) {
        const double cut = m_scene.errorMm(fit(method).poses);
        const double ignored = m_scene.errorMm(fit(std::string(method) + ":forearm=ignore").poses);
        EXPECT_LT(cut, 0.7 * ignored) << method;
        RecordProperty(std::string("forearm_um_") + method, static_cast<int>(1000 * cut));
        RecordProperty(std::string("ignored_um_") + method, static_cast<int>(1000 * ignored));
    }
}

TEST_F(Estimator, SilhouettesThatEndWithTheHandsAreFittedAsBefore) {
    for (const char* const method : {"ch", "dch-thres", "dch-quant2", "dch-dt3", "best"}) {
        const FitResult cut = fit(method), ignored = fit(std::string(method) + ":forearm=ignore");
        for (std::size_t h = 0; h < 2; ++h)
            EXPECT_EQ(cut.poses[h], ignored.poses[h]) << method << ": bit by bit";
    }
}

TEST_F(Estimator, ExactSilhouettesGiveThePapersMethodsWhateverTheyKnowOfNoise) {
    for (const std::string distance : {"ch", "dch-thres", "dch-quant", "dch-quant2", "dch-dt3"}) {
        for (const std::string schedule : {"rigid", "paper"}) {
            const std::string method = distance + ":schedule=" + schedule;
            const FitResult with = fit(method), without = fit(method + ":noise=0");
            EXPECT_EQ(with.poses[0], without.poses[0]) << method << ": bit by bit";
            EXPECT_EQ(with.history.size(), without.history.size()) << method;
        }
    }
}

TEST_F(Estimator, SpecksDoNotDrawTheHandsAway) {
    std::map<std::string, double> before;
    for (const std::string method : {"ch", "dch-thres", "dch-dt3"})
        before[method] = m_scene.errorMm(fit(method).poses);
    test::speckle(m_scene.masks);
    for (const auto& [method, errorMm] : before) {
        EXPECT_LT(m_scene.errorMm(fit(method).poses), errorMm + 0.4) << method;
        if (method != "ch") // its error in this scene is not that of the specks
            EXPECT_GT(m_scene.errorMm(fit(method + ":noise=0").poses), m_scene.errorMm(fit(method).poses)) << method;
    }
    EXPECT_EQ(fit("dch-thres:schedule=paper", 1).poses[0], fit("dch-thres:schedule=paper", 3).poses[0]);
}

TEST_F(Estimator, IsTheSameForAnyNumberOfThreadsAndEveryTime) {
    for (const char* method : {"ch", "dch-thres", "dch-quant2", "dch-dt3", "best"}) {
        const FitResult first = fit(method), again = fit(method), threaded = fit(method, 2);
        for (const FitResult* other : {&again, &threaded}) {
            ASSERT_EQ(first.history.size(), other->history.size()) << method;
            EXPECT_EQ(first.termination, other->termination);
            for (std::size_t i = 0; i < first.history.size(); ++i)
                EXPECT_EQ(first.history[i].costMm2, other->history[i].costMm2) << method << " " << i;
            for (std::size_t h = 0; h < 2; ++h)
                EXPECT_EQ(first.poses[h], other->poses[h]) << method << ": bit by bit";
        }
    }
}

TEST_F(Estimator, TensorAndDirectSearchGiveTheSamePose) {
    const FitResult direct = fit("dch-dt3"), tensor = fit("dch-dt3:backend=tensor");
    EXPECT_LT(core::meanJointDistanceMm(m_scene.hands, direct.poses, tensor.poses), 0.8)
        << "equally good matches differ";
    EXPECT_LT(m_scene.errorMm(tensor.poses), 1.4);
}

TEST_F(Estimator, HistoryLeadsFromTheStartToTheResult) {
    int calls = 0;
    const core::Method method = parseMethod("dch-thres:iterations=9");
    const FitResult result = m_estimator.fit(m_scene.masks, m_scene.start, method, {}, [&](int iteration, int most) {
        EXPECT_EQ(iteration, ++calls);
        EXPECT_EQ(most, 9);
    });
    ASSERT_EQ(result.history.size(), 9u);
    EXPECT_EQ(calls, 9);
    EXPECT_EQ(result.termination, FitTermination::MaxIterations);
    HandPoses before = m_scene.start;
    for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_EQ(result.history[i].iteration, static_cast<int>(i));
        EXPECT_NEAR(result.history[i].stepMm, core::meanJointDistanceMm(m_scene.hands, before, result.history[i].poses),
                    1e-9);
        before = result.history[i].poses;
    }
    EXPECT_EQ(before[0], result.poses[0]);
    EXPECT_LT(result.history.back().costMm2, 0.3 * result.history.front().costMm2);
}

TEST_F(Estimator, ConvergesAtTheTruth) {
    const FitResult result = m_estimator.fit(m_scene.masks, m_scene.truth, parseMethod("ch:iterations=200"));
    EXPECT_EQ(result.termination, FitTermination::Converged);
    EXPECT_LT(result.history.back().stepMm, 0.01);
    EXPECT_LT(m_scene.errorMm(result.poses), 0.8);
}

TEST_F(Estimator, TheDefaultScheduleMovesTheWholeHandsFirst) {
    const FitResult rigid = fit("dch-thres:iterations=3"), paper = fit("dch-thres:iterations=3:schedule=paper");
    EXPECT_EQ(rigid.poses[0].tail(6), m_scene.start[0].tail(6));
    EXPECT_GT((paper.poses[0].tail(6) - m_scene.start[0].tail(6)).norm(), 0.01);
}

TEST_F(Estimator, StopsWhenAskedTo) {
    for (const char* method : {"dch-thres", "best"}) {
        std::stop_source source;
        const FitResult result = m_estimator.fit(m_scene.masks, m_scene.start, parseMethod(method), source.get_token(),
                                                 [&](int iteration, int) {
                                                     if (iteration == 3)
                                                         source.request_stop();
                                                 });
        EXPECT_EQ(result.termination, FitTermination::Stopped) << method;
        EXPECT_EQ(result.history.size(), 3u);
        source.request_stop();
        const FitResult none = m_estimator.fit(m_scene.masks, m_scene.start, parseMethod(method), source.get_token());
        EXPECT_EQ(none.termination, FitTermination::Stopped);
        EXPECT_TRUE(none.history.empty());
        EXPECT_EQ(none.poses[0], m_scene.start[0]);
    }
}

TEST_F(Estimator, WithoutASilhouetteThereAreNoMatches) {
    std::vector<cv::Mat> black;
    for (const cv::Mat& mask : m_scene.masks)
        black.emplace_back(mask.size(), CV_8U, cv::Scalar(0));
    for (const auto& masks : {black, std::vector<cv::Mat>(m_scene.masks.size())}) {
        for (const char* method : {"ch", "dch-quant", "best"}) {
            const FitResult result = m_estimator.fit(masks, m_scene.start, parseMethod(method));
            EXPECT_EQ(result.termination, FitTermination::NoMatches) << method;
            EXPECT_EQ(result.poses[0], m_scene.start[0]);
            EXPECT_EQ(result.poses[1], m_scene.start[1]);
        }
    }
    const FitResult strict = fit("dch-thres:tau=0");
    EXPECT_EQ(strict.termination, FitTermination::NoMatches);
    EXPECT_EQ(strict.history.size(), 1u);
}

TEST_F(Estimator, CamerasWithoutAMaskAreLeftOut) {
    m_scene.masks[1] = cv::Mat();
    m_scene.masks[4] = cv::Mat();
    EXPECT_LT(m_scene.errorMm(fit("dch-thres").poses), 1.2);
}

TEST_F(Estimator, InputOfTheWrongSizeIsAnError) {
    const auto& [hands, cameras, truth, start, masks] = m_scene;
    auto few = masks;
    few.pop_back();
    EXPECT_EQ(complaint(few, start), "masks: there are 5 for 6 cameras");
    auto small = masks;
    small[2] = cv::Mat(959, 540, CV_8U, cv::Scalar(0));
    EXPECT_EQ(complaint(small, start), "mask of cam2: must be an 8-bit image of the camera's size");
    auto colour = masks;
    colour[0] = cv::Mat(960, 540, CV_8UC3, cv::Scalar::all(255));
    EXPECT_EQ(complaint(colour, start), "mask of cam0: must be an 8-bit image of the camera's size");
    EXPECT_EQ(complaint(masks, {start[0]}), "start: must hold one pose per hand");
    EXPECT_EQ(complaint(masks, {start[0], start[1].head(7)}), "start: pose 1 does not fit its hand");
    HandPoses broken = start;
    broken[0][4] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(complaint(masks, broken), "start: pose 0 does not fit its hand");
    EXPECT_EQ(complaint(masks, start), "");
}

} // namespace
