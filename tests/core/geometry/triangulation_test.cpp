// SPDX-License-Identifier: MIT
#include "core/geometry/triangulation.h"

#include <chrono>
#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include "tests/support/camera_ring.h"

namespace {

using core::Observation;
using Eigen::Vector2d;
using Eigen::Vector3d;

class Triangulation : public testing::Test {
protected:
    Vector3d randomPoint() {
        std::uniform_real_distribution<double> uniform(-80, 80);
        return {uniform(m_random), uniform(m_random), uniform(m_random)};
    }
    Vector2d noise(double sigmaPx) {
        std::normal_distribution<double> normal(0, sigmaPx);
        return {normal(m_random), normal(m_random)};
    }
    std::vector<Observation> observe(const std::vector<core::Camera>& cameras, const Vector3d& point,
                                     double sigmaPx = 0) {
        std::vector<Observation> observations;
        for (int i = 0; i < static_cast<int>(cameras.size()); ++i) {
            observations.push_back(
                {i, *core::project(cameras[i], point) + (sigmaPx > 0 ? noise(sigmaPx) : Vector2d(0, 0))});
        }
        return observations;
    }

    std::mt19937_64 m_random{20130903};
};

TEST_F(Triangulation, FindsExactPointsFromTwoToEightViewsThroughTheLens) {
    const auto cameras = test::cameraRing(8);
    for (int trial = 0; trial < 60; ++trial) {
        const Vector3d truth = randomPoint();
        auto observations = observe(cameras, truth);
        std::shuffle(observations.begin(), observations.end(), m_random);
        observations.resize(2 + trial % 7);
        if (observations.size() == 2 && (observations[0].camera - observations[1].camera) % 4 == 0)
            continue; // opposite cameras see the middle of the ring along one line
        const auto result = core::triangulate(cameras, observations);
        ASSERT_TRUE(result.point) << core::failureText(result.failure);
        EXPECT_LT((result.point->pointInWorld - truth).norm(), 1e-6);
        EXPECT_LT(result.point->rmsPx, 1e-6);
        EXPECT_EQ(result.failure, core::TriangulationFailure::None);
    }
}

TEST_F(Triangulation, AgreesWithOpenCvOnCleanDataWithoutALens) {
    const auto cameras = test::cameraRing(8, false);
    for (int trial = 0; trial < 20; ++trial) {
        const auto all = observe(cameras, randomPoint());
        const std::vector<Observation> pair{all[trial % 8], all[(trial + 3) % 8]};
        cv::Mat projections[2], px[2], homogeneous;
        for (int i = 0; i < 2; ++i) {
            const core::Camera& camera = cameras[pair[i].camera];
            Eigen::Matrix<double, 3, 4> p;
            p << camera.cameraFromWorld.rotation, camera.cameraFromWorld.translation;
            p = camera.intrinsics * p;
            projections[i] = cv::Mat(3, 4, CV_64F);
            for (int row = 0; row < 3; ++row)
                for (int column = 0; column < 4; ++column)
                    projections[i].at<double>(row, column) = p(row, column);
            px[i] = (cv::Mat_<double>(2, 1) << pair[i].px.x(), pair[i].px.y());
        }
        cv::triangulatePoints(projections[0], projections[1], px[0], px[1], homogeneous);
        const Vector3d oracle(homogeneous.at<double>(0) / homogeneous.at<double>(3),
                              homogeneous.at<double>(1) / homogeneous.at<double>(3),
                              homogeneous.at<double>(2) / homogeneous.at<double>(3));
        const auto result = core::triangulate(cameras, pair);
        ASSERT_TRUE(result.point);
        EXPECT_LT((result.point->pointInWorld - oracle).norm(), 1e-6);
    }
}

TEST_F(Triangulation, CovarianceIsCalibrated) {
    for (const double sigmaPx : {0.5, 1.0, 3.0}) {
        const auto cameras = test::cameraRing(8);
        core::TriangulationOptions options;
        options.sigmaPx = sigmaPx;
        double nees = 0, squaredError = 0;
        constexpr int kTrials = 1500;
        for (int trial = 0; trial < kTrials; ++trial) {
            const Vector3d truth = randomPoint();
            const auto result = core::triangulate(cameras, observe(cameras, truth, sigmaPx), options);
            ASSERT_TRUE(result.point);
            const Vector3d error = result.point->pointInWorld - truth;
            nees += error.dot(result.point->covariance.inverse() * error) / kTrials;
            squaredError += error.squaredNorm() / kTrials;
        }
        // The mean of 1500 chi-square variables of 3 degrees of freedom has a standard deviation of 0.063.
        EXPECT_NEAR(nees, 3.0, 0.25) << "sigma " << sigmaPx;
        EXPECT_LT(std::sqrt(squaredError), 0.6 * sigmaPx);
    }
}

TEST_F(Triangulation, TwoWrongClicksOfEightAreNamedAndDoNoHarm) {
    const auto cameras = test::cameraRing(8);
    std::uniform_real_distribution<double> offset(25, 80);
    int named = 0;
    double squaredError = 0;
    constexpr int kTrials = 200;
    for (int trial = 0; trial < kTrials; ++trial) {
        const Vector3d truth = randomPoint();
        auto observations = observe(cameras, truth, 1.0);
        const std::vector<int> wrong{trial % 8, (trial + 3) % 8};
        for (const int camera : wrong)
            observations[camera].px += Vector2d(trial % 2 ? offset(m_random) : -offset(m_random), offset(m_random));
        const auto result = core::triangulate(cameras, observations);
        ASSERT_TRUE(result.point);
        squaredError += (result.point->pointInWorld - truth).squaredNorm() / kTrials;
        std::vector<bool> expected(8, true);
        expected[wrong[0]] = expected[wrong[1]] = false;
        named += result.point->inlier == expected;
    }
    EXPECT_LT(std::sqrt(squaredError), 0.6);
    EXPECT_GE(named, 0.97 * kTrials);
}

TEST_F(Triangulation, ReportsTheResidualThatItMinimises) {
    const auto cameras = test::cameraRing(5);
    const auto observations = observe(cameras, randomPoint(), 1.0);
    const auto result = core::triangulate(cameras, observations);
    ASSERT_TRUE(result.point);
    const auto cost = [&](const Vector3d& point) {
        double sum = 0;
        for (const Observation& o : observations)
            sum += (*core::project(cameras[o.camera], point) - o.px).squaredNorm();
        return sum;
    };
    const double least = cost(result.point->pointInWorld);
    EXPECT_NEAR(result.point->rmsPx, std::sqrt(least / 5), 1e-12);
    for (int axis = 0; axis < 3; ++axis)
        for (const double step : {-1e-3, 1e-3})
            EXPECT_GT(cost(result.point->pointInWorld + step * Vector3d::Unit(axis)), least);
}

TEST_F(Triangulation, WeighsObservationsByTheirOwnSigma) {
    const auto cameras = test::cameraRing(6);
    double weighted = 0, equal = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const Vector3d truth = randomPoint();
        auto observations = observe(cameras, truth, 0.5);
        for (int i = 3; i < 6; ++i)
            observations[i].px += noise(3.0);
        core::TriangulationOptions options;
        options.sigmaPx = 3.0;
        equal += (core::triangulate(cameras, observations, options).point->pointInWorld - truth).squaredNorm();
        for (int i = 0; i < 6; ++i)
            observations[i].sigmaPx = i < 3 ? 0.5 : 3.04;
        weighted += (core::triangulate(cameras, observations, options).point->pointInWorld - truth).squaredNorm();
    }
    EXPECT_LT(weighted, 0.5 * equal);
}

TEST_F(Triangulation, InformationIsTheInverseCovariance) {
    const auto cameras = test::cameraRing(4);
    const auto observations = observe(cameras, randomPoint());
    core::TriangulationOptions options;
    options.sigmaPx = 2;
    const auto result = core::triangulate(cameras, observations, options);
    ASSERT_TRUE(result.point);
    const Eigen::Matrix3d product =
        core::triangulationInformation(cameras, observations, result.point->pointInWorld, options) *
        result.point->covariance;
    EXPECT_LT((product - Eigen::Matrix3d::Identity()).norm(), 1e-8);
}

TEST_F(Triangulation, SaysWhyThereIsNoPoint) {
    auto cameras = test::cameraRing(8);
    const Vector3d truth(10, -20, 30);
    const auto exact = observe(cameras, truth);
    EXPECT_EQ(core::triangulate(cameras, {}).failure, core::TriangulationFailure::FewerThanTwoViews);
    EXPECT_EQ(core::triangulate(cameras, {exact[0]}).failure, core::TriangulationFailure::FewerThanTwoViews);
    EXPECT_EQ(core::triangulate(cameras, {exact[2], exact[2]}).failure, core::TriangulationFailure::FewerThanTwoViews);

    auto wrong = exact;
    wrong[1].px.y() += 60;
    EXPECT_EQ(core::triangulate(cameras, {exact[0], wrong[1]}).failure, core::TriangulationFailure::ViewsDisagree);

    std::vector<core::Camera> twins{cameras[0], cameras[0]};
    twins[1].cameraFromWorld.translation.x() += 2; // 2 mm apart at a metre: 0.1 degrees
    EXPECT_EQ(core::triangulate(twins, observe(twins, truth)).failure, core::TriangulationFailure::RaysNearlyParallel);

    std::vector<core::Camera> diverging{cameras[0], cameras[0]};
    diverging[1].cameraFromWorld.translation.x() -= 300;
    const std::vector<Observation> outward{{0, {900, 955}}, {1, {100, 955}}};
    const std::vector<Observation> inward{{0, {100, 955}}, {1, {900, 955}}};
    const auto failures = {core::triangulate(diverging, outward).failure, core::triangulate(diverging, inward).failure};
    EXPECT_EQ(std::count(failures.begin(), failures.end(), core::TriangulationFailure::BehindCamera), 1);
}

TEST_F(Triangulation, DoesNotDependOnTheOrderOfTheViews) {
    const auto cameras = test::cameraRing(8);
    auto observations = observe(cameras, randomPoint(), 1.0);
    observations[4].px.x() += 70;
    const auto first = core::triangulate(cameras, observations);
    std::reverse(observations.begin(), observations.end());
    const auto second = core::triangulate(cameras, observations);
    ASSERT_TRUE(first.point && second.point);
    EXPECT_LT((first.point->pointInWorld - second.point->pointInWorld).norm(), 1e-6);
    EXPECT_FALSE(first.point->inlier[4]);
    EXPECT_FALSE(second.point->inlier[3]);
}

TEST_F(Triangulation, IsFastEnoughForWholeSequences) {
    const auto cameras = test::cameraRing(8);
    std::vector<std::vector<Observation>> points;
    for (int i = 0; i < 560; ++i)
        points.push_back(observe(cameras, randomPoint(), 1.0));
    const auto start = std::chrono::steady_clock::now();
    int found = 0;
    for (const auto& observations : points)
        found += core::triangulate(cameras, observations).point.has_value();
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    RecordProperty("milliseconds_per_1000_points", std::to_string(ms / 0.56));
    EXPECT_EQ(found, 560);
#ifndef __SANITIZE_ADDRESS__
    EXPECT_LT(ms, 90) << "560 points of 8 views (generous: shared processors, unoptimised builds)";
#endif
}

} // namespace
