// SPDX-License-Identifier: MIT
#include "core/annotation/curve_gap.h"

#include <gtest/gtest.h>

#include "core/annotation/quality_checker.h"
#include "core/annotation/reconstruction.h"
#include "tests/support/camera_ring.h"

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Vector3d kPointMm(20, -35, 12);

/// The distance from `px` in `camera` to everything that the ray of `fromPx` in `from` could be: brute force over its
/// length.
double distanceToRay(const core::Camera& from, const Vector2d& fromPx, const core::Camera& camera, const Vector2d& px) {
    const auto ray = core::viewingRay(from, fromPx);
    double nearest = 1e9;
    for (double mm = 1; mm < 4000; mm += 0.05)
        if (const auto at = core::project(camera, from.centreInWorld() + mm * ray->direction))
            nearest = std::min(nearest, (*at - px).norm());
    return nearest;
}

class CurveGaps : public testing::Test {
protected:
    void click(int camera, const Vector2d& off) {
        const Vector2d px = *core::project(m_cameras[static_cast<std::size_t>(camera)], kPointMm) + off;
        m_set.marks[{3, "ann", m_joint, m_cameras[static_cast<std::size_t>(camera)].name}] = {px};
        m_clicks.push_back({camera, px});
    }
    core::JointReconstruction look() const { return core::reconstruct(m_set, m_cameras, 3, "ann", m_joint); }

    std::vector<core::Camera> m_cameras = test::cameraRing(8);
    core::JointId m_joint{core::Side::Left, "index_mcp"};
    core::AnnotationSet m_set;
    std::vector<core::Observation> m_clicks;
};

TEST_F(CurveGaps, AreTheDistancesToEachOthersCurvesInRecordedPixels) {
    click(0, {0, 0});
    click(2, {3, 24});
    const auto gaps = core::worstCurveGaps(m_cameras, m_clicks);
    ASSERT_EQ(gaps.size(), 2u);
    EXPECT_GE(gaps[0].px, gaps[1].px);
    for (const core::CurveGap& gap : gaps) {
        const std::size_t mine = gap.camera == "cam0" ? 0 : 1, other = 1 - mine;
        const core::Camera& camera = m_cameras[static_cast<std::size_t>(m_clicks[mine].camera)];
        const core::Camera& from = m_cameras[static_cast<std::size_t>(m_clicks[other].camera)];
        EXPECT_EQ(gap.curveOf, from.name);
        EXPECT_NEAR(gap.px, distanceToRay(from, m_clicks[other].px, camera, m_clicks[mine].px), 0.05) << gap.camera;
        EXPECT_GT(gap.px, 8);
        EXPECT_NEAR((gap.nearestPx - gap.clickPx).norm(), gap.px, 1e-9);
    }
    const auto turned = core::worstCurveGaps(m_cameras, {m_clicks[1], m_clicks[0]});
    EXPECT_NEAR(turned[0].px, gaps[0].px, 1e-9) << "the order of the clicks does not matter";
}

TEST_F(CurveGaps, OfThreeClicksTheWorstPairIsNamed) {
    click(0, {0, 0});
    click(2, {0, 15});
    click(5, {0, -60});
    const auto gaps = core::worstCurveGaps(m_cameras, m_clicks);
    ASSERT_FALSE(gaps.empty());
    EXPECT_TRUE(gaps[0].camera == "cam5" || gaps[0].curveOf == "cam5");
}

TEST_F(CurveGaps, TwoViewsThatDisagreeAreBadAndSayByHowMuch) {
    click(0, {0, 0});
    click(2, {3, 24});
    const core::JointReconstruction joint = look();
    ASSERT_FALSE(joint.hasPoint());
    ASSERT_EQ(joint.gaps.size(), 2u);
    EXPECT_TRUE(core::isBad(joint, 5.0));
    const core::HandCoverage coverage = core::coverageOf(m_set, m_cameras, 3, "ann", 5.0).at(core::Side::Left);
    EXPECT_EQ(coverage.bad, 1);
    EXPECT_EQ(coverage.partial, 0) << "each joint is counted once";
    EXPECT_EQ(coverage.marked(), 1);
    const auto findings = core::checkSequence(m_set, m_cameras, "ann", {});
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_DOUBLE_EQ(findings[0].value, joint.gaps[0].px);
    EXPECT_EQ(findings[0].camera, joint.gaps[0].camera);
    EXPECT_EQ(findings[0].curveOf, joint.gaps[0].curveOf);
    EXPECT_NE(findings[0].text.find("px off " + joint.gaps[0].curveOf + "'s curve"), std::string::npos)
        << findings[0].text;
}

TEST_F(CurveGaps, ClicksThatAgreeHaveNone) {
    click(0, {0, 0});
    click(2, {0, 0});
    EXPECT_TRUE(look().gaps.empty());
    EXPECT_FALSE(core::isBad(look(), 2.0));
}

} // namespace
