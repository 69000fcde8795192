// SPDX-License-Identifier: MIT
#include "core/fitting/fit_target.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/support/fitting_scene.h"

namespace {

using core::CameraTarget;
using core::FitTargetOptions;
using core::makeFitTargets;

class FitTarget : public testing::Test {
protected:
    test::FittingScene m_scene{"fit target", 4};
};

TEST_F(FitTarget, RaysRunThroughTheirContourPoints) {
    const auto targets = makeFitTargets(m_scene.cameras, m_scene.masks, {}, 1);
    ASSERT_EQ(targets.size(), 4u);
    for (std::size_t c = 0; c < targets.size(); ++c) {
        const CameraTarget& target = targets[c];
        EXPECT_EQ(target.camera, static_cast<int>(c));
        ASSERT_GT(target.contour.size(), 200u);
        ASSERT_EQ(target.rayDirection.size(), target.contour.size());
        EXPECT_LT((target.centre - m_scene.cameras[c].centreInWorld()).norm(), 1e-9);
        for (std::size_t i = 0; i < target.contour.size(); ++i) {
            EXPECT_NEAR(target.rayDirection[i].norm(), 1, 1e-12);
            const auto px = core::project(m_scene.cameras[c], target.centre + 800 * target.rayDirection[i]);
            ASSERT_TRUE(px);
            EXPECT_NEAR(px->x(), static_cast<double>(target.contour.x[i]), 1e-6);
            EXPECT_NEAR(px->y(), static_cast<double>(target.contour.y[i]), 1e-6);
        }
    }
}

TEST_F(FitTarget, HoldsTheOutlineAndTheMaskOfEachCamera) {
    const auto targets = makeFitTargets(m_scene.cameras, m_scene.masks, {}, 1);
    for (std::size_t c = 0; c < targets.size(); ++c) {
        const core::OrientedContour contour = core::orientedContour(m_scene.masks[c]);
        EXPECT_EQ(targets[c].contour.x, contour.x);
        EXPECT_EQ(targets[c].contour.angleRad, contour.angleRad);
        EXPECT_EQ(targets[c].mask.data, m_scene.masks[c].data) << "shared, not copied";
        EXPECT_EQ(targets[c].maskBounds, core::maskBounds(m_scene.masks[c]));
        EXPECT_FALSE(targets[c].tensor);
        const float infinity = std::numeric_limits<float>::infinity();
        const core::ContourMatch match = targets[c].index.nearest(contour.x[50], contour.y[50], infinity);
        EXPECT_EQ(match.distance, 0);
    }
}

TEST_F(FitTarget, CamerasWithoutAnOutlineAreLeftOut) {
    m_scene.masks[0] = cv::Mat();
    m_scene.masks[2].setTo(0);
    const auto targets = makeFitTargets(m_scene.cameras, m_scene.masks, {}, 1);
    ASSERT_EQ(targets.size(), 2u);
    EXPECT_EQ(targets[0].camera, 1);
    EXPECT_EQ(targets[1].camera, 3);
    for (cv::Mat& mask : m_scene.masks)
        mask = cv::Mat(960, 540, CV_8U, cv::Scalar(255)); // everything is hand: no outline within the image
    EXPECT_TRUE(makeFitTargets(m_scene.cameras, m_scene.masks, {}, 1).empty());
}

TEST_F(FitTarget, SpecksAreLeftOutOfSpeckledMasksOnly) {
    FitTargetOptions options;
    options.withoutSpecks = true;
    const auto clean = makeFitTargets(m_scene.cameras, m_scene.masks, options, 1);
    for (cv::Mat& mask : m_scene.masks) {
        cv::Mat copy = mask.clone(); // a hole of 8 px in a palm, as between two fingers
        const cv::Rect bounds = core::maskBounds(copy);
        cv::circle(copy, {bounds.x + bounds.width / 3, bounds.y + bounds.height / 2}, 4, 0, cv::FILLED);
        mask = copy;
    }
    const auto holed = makeFitTargets(m_scene.cameras, m_scene.masks, options, 1);
    test::speckle(m_scene.masks);
    const auto kept = makeFitTargets(m_scene.cameras, m_scene.masks, {}, 1);
    const auto left = makeFitTargets(m_scene.cameras, m_scene.masks, options, 1);
    for (std::size_t c = 0; c < clean.size(); ++c) {
        EXPECT_FALSE(clean[c].isSpeckled);
        EXPECT_FALSE(holed[c].isSpeckled) << "one hole is not noise";
        EXPECT_FALSE(kept[c].isSpeckled) << "nobody asked";
        EXPECT_TRUE(left[c].isSpeckled);
        EXPECT_GT(kept[c].contour.size(), left[c].contour.size() + 60);
        EXPECT_NEAR(static_cast<double>(left[c].contour.size()), static_cast<double>(clean[c].contour.size()),
                    0.1 * static_cast<double>(clean[c].contour.size()));
    }
}

TEST_F(FitTarget, SearchesWholePixelsIfAskedTo) {
    FitTargetOptions options;
    options.wholePixels = true;
    const auto targets = makeFitTargets(m_scene.cameras, m_scene.masks, options, 1);
    const CameraTarget& target = targets.front();
    for (std::size_t i = 0; i < target.contour.size(); i += 17) {
        const float x = std::round(target.contour.x[i]), y = std::round(target.contour.y[i]);
        EXPECT_EQ(target.index.nearest(x, y, 100).distance, 0);
    }
}

TEST_F(FitTarget, BuildsTheTensorOnlyIfAskedTo) {
    FitTargetOptions options;
    options.tensorLambdaPxPerRad = 25;
    const auto targets = makeFitTargets(m_scene.cameras, m_scene.masks, options, 1);
    for (const CameraTarget& target : targets)
        EXPECT_TRUE(target.tensor);
}

TEST_F(FitTarget, PointsWithoutARayAreDropped) {
    core::Camera camera = m_scene.cameras[0];
    camera.intrinsics << 300, 0, 270, 0, 300, 480, 0, 0, 1;
    camera.distortion = {-0.3, 0, 0, 0, 0}; // no light reaches pixels more than 0.70 * 300 from the middle
    cv::Mat mask(960, 540, CV_8U, cv::Scalar(0));
    mask(cv::Rect(250, 100, 40, 760)) = 255;
    const auto targets = makeFitTargets({camera}, {mask}, {}, 1);
    ASSERT_EQ(targets.size(), 1u);
    ASSERT_EQ(targets[0].rayDirection.size(), targets[0].contour.size());
    EXPECT_LT(targets[0].contour.size(), core::orientedContour(mask).size());
    EXPECT_GT(targets[0].contour.size(), 700u);
    for (std::size_t i = 0; i < targets[0].contour.size(); ++i)
        EXPECT_LT(std::abs(targets[0].contour.y[i] - 480), 212);
}

TEST_F(FitTarget, DoesNotDependOnTheThreads) {
    const auto one = makeFitTargets(m_scene.cameras, m_scene.masks, {}, 1);
    const auto four = makeFitTargets(m_scene.cameras, m_scene.masks, {}, 4);
    ASSERT_EQ(one.size(), four.size());
    for (std::size_t c = 0; c < one.size(); ++c) {
        EXPECT_EQ(one[c].camera, four[c].camera);
        EXPECT_EQ(one[c].contour.x, four[c].contour.x);
        EXPECT_EQ(one[c].rayDirection, four[c].rayDirection);
    }
}

} // namespace
