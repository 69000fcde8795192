// SPDX-License-Identifier: MIT
#include "core/annotation/click_noise.h"

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"
#include "tests/support/clicks.h"

namespace {

using core::AnnotationSet;
using core::Side;

class ClickNoiseTest : public testing::Test {
protected:
    void click(double sigmaPx, int joints, int views = 8) {
        std::uniform_real_distribution<double> uniform(-80, 80);
        for (int i = 0; i < joints; ++i) {
            const Eigen::Vector3d point(uniform(m_random), uniform(m_random), uniform(m_random));
            test::clickEverywhere(m_set, {m_cameras.begin(), m_cameras.begin() + views}, i, "ann",
                                  {Side::Left, "wrist"}, point, sigmaPx, &m_random);
        }
    }

    std::vector<core::Camera> m_cameras = test::cameraRing(8);
    AnnotationSet m_set;
    std::mt19937_64 m_random = test::randomFor("ClickNoise");
};

TEST_F(ClickNoiseTest, FindsTheScatterThatWasPutIn) {
    for (const double sigma : {0.4, 1.0, 2.5}) {
        m_set = {};
        click(sigma, 300);
        const auto noise = core::estimateClickNoise(m_set, m_cameras, "ann");
        ASSERT_TRUE(noise);
        EXPECT_NEAR(noise->sigmaPx, sigma, 0.04 * sigma);
        EXPECT_NEAR(noise->degreesOfFreedom, 2.0 * noise->clicks - 3 * 300, 1e-6);
    }
}

TEST_F(ClickNoiseTest, IsUnbiasedWithFewViewsToo) {
    click(1.5, 2000, 3);
    EXPECT_NEAR(core::estimateClickNoise(m_set, m_cameras, "ann")->sigmaPx, 1.5, 0.06);
}

TEST_F(ClickNoiseTest, LeavesWrongClicksOut) {
    click(1.0, 300);
    for (int i = 0; i < 300; i += 5)
        m_set.marks.at({i, "ann", {Side::Left, "wrist"}, "cam3"}).px += Eigen::Vector2d(60, -30);
    const auto noise = core::estimateClickNoise(m_set, m_cameras, "ann");
    EXPECT_NEAR(noise->sigmaPx, 1.0, 0.05);
    EXPECT_GE(noise->outliers, 60);
}

TEST_F(ClickNoiseTest, TellsAPoorCameraFromTheOthers) {
    click(0.5, 400);
    std::normal_distribution<double> normal(0, 1.2);
    for (auto& [key, mark] : m_set.marks)
        if (key.camera == "cam6")
            mark.px += Eigen::Vector2d(normal(m_random), normal(m_random));
    const auto byCamera = core::estimateClickNoise(m_set, m_cameras, "ann")->sigmaPxByCamera;
    EXPECT_EQ(byCamera.size(), 8u);
    for (const auto& [camera, sigma] : byCamera)
        EXPECT_TRUE(camera == "cam6" ? sigma > 0.9 : sigma < 0.7) << camera << " " << sigma;
}

TEST_F(ClickNoiseTest, NeedsEnoughJointsOfThreeViews) {
    click(1.0, 4);
    EXPECT_FALSE(core::estimateClickNoise(m_set, m_cameras, "ann"));
    m_set = {};
    click(1.0, 100, 2);
    EXPECT_FALSE(core::estimateClickNoise(m_set, m_cameras, "ann"));
    EXPECT_FALSE(core::estimateClickNoise(m_set, m_cameras, "bob"));
}

} // namespace
