// SPDX-License-Identifier: MIT
#include "core/contour/forearm.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/contour/rasteriser.h"
#include "core/contour/sleeve.h"
#include "core/contour/visible_rim.h"
#include "tests/support/camera_ring.h"
#include "tests/support/random_values.h"
#include "tests/support/two_finger_hand.h"

namespace {

using core::ConvexRegion;
using Eigen::Vector2f;

/// A square turned by 45 degrees, with a point inside: |x - 10| + |y - 20| <= 6.
const ConvexRegion kDiamond({{10, 14}, {16, 20}, {11, 20}, {10, 26}, {4, 20}});

TEST(ConvexRegion, HoldsWhatLiesWithinItsHull) {
    for (float y = 10; y < 30; y += 0.7f)
        for (float x = 0; x < 20; x += 0.7f)
            EXPECT_EQ(kDiamond.contains({x, y}), std::abs(x - 10) + std::abs(y - 20) <= 6) << x << " " << y;
    EXPECT_FALSE(ConvexRegion().contains({0, 0}));
    EXPECT_TRUE(ConvexRegion({{1, 1}, {2, 2}}).empty());
}

TEST(ConvexRegion, GivesTheSpanOfARow) {
    const auto span = kDiamond.span(22);
    ASSERT_TRUE(span);
    EXPECT_NEAR(span->first, 6, 1e-4);
    EXPECT_NEAR(span->second, 14, 1e-4);
    EXPECT_FALSE(kDiamond.span(13));
    EXPECT_FALSE(kDiamond.span(27));
}

TEST(CoverageMask, LeavesIgnoredRegionsOutOfTheDifference) {
    core::CoverageMask coverage;
    coverage.reset({0, 0}, {40, 40}, 1);
    const cv::Mat mask(60, 60, CV_8U, cv::Scalar(255));
    int inside = 0;
    for (int y = 0; y <= 40; ++y)
        for (int x = 0; x <= 40; ++x)
            inside += kDiamond.contains({static_cast<float>(x), static_cast<float>(y)});
    const std::vector<ConvexRegion> ignored{kDiamond};
    EXPECT_EQ(coverage.compare(mask, {}).differencePx2, 41 * 41);
    EXPECT_EQ(coverage.compare(mask, {}, ignored).differencePx2, 41 * 41 - inside);
}

TEST(CoverageMask, TellsDeepDifferencesFromThoseNearTheOutline) {
    core::CoverageMask coverage;
    coverage.reset({0, 0}, {40, 40}, 1);
    const cv::Mat mask(60, 60, CV_8U, cv::Scalar(255));
    cv::Mat unsure = cv::Mat::zeros(60, 60, CV_8U);
    unsure.rowRange(0, 10).setTo(255);
    const core::SilhouetteComparison areas = coverage.compare(mask, unsure);
    EXPECT_EQ(areas.differencePx2, 41 * 41);
    EXPECT_EQ(areas.deepPx2, 41 * 31);
    EXPECT_EQ(areas.unionPx2, 41 * 41);
}

TEST(Forearm, BeginsBeforeTheModelsEndAndGoesAwayFromTheFingers) {
    for (const core::HandModel& hand : test::twoFingerHands()) {
        const core::ForearmCut cut = core::forearmCut(hand);
        const core::Skeleton& skeleton = hand.skeleton;
        for (std::size_t b = 1; b < skeleton.bones.size(); ++b)
            EXPECT_LT(cut.direction.dot(skeleton.bones[b].worldFromBoneAtRest.translation - cut.centre), 0);
        double end = -1e9;
        for (const Eigen::Vector3d& v : hand.mesh.vertices)
            end = std::max(end, cut.direction.dot(v - cut.centre));
        EXPECT_NEAR(cut.endMm, end, 1e-9);
        EXPECT_GT(cut.endMm, 0);
        EXPECT_GT(cut.radiusMm, 5);
    }
}

TEST(Forearm, RegionMovesWithTheHand) {
    test::RandomValues random("forearm region");
    const core::HandModel hand = test::twoFingerHands().front();
    const core::ForearmCut cut = core::forearmCut(hand);
    for (const core::Camera& camera : test::cameraRing(6, true)) {
        const core::RigidMotion motion{core::rotationExp(random.point(0.3)), random.point(10)};
        const ConvexRegion region = core::forearmRegion(camera, cut, motion);
        if (region.empty())
            continue;
        int found = 0;
        for (const Eigen::Vector3d& point : core::forearmAxis(cut, motion)) {
            const auto px = core::project(camera, point);
            found += px && region.contains(px->cast<float>());
        }
        EXPECT_GT(found, 10) << camera.name;
    }
}

/// How far before the cut a part begins that is wider than the hand, in the silhouettes of all cameras. The part is
/// drawn as lines around the axis, from `before` mm before the cut on.
double foundSleeveMm(const core::HandModel& hand, double before, double widerMm) {
    const core::ForearmCut cut = core::forearmCut(hand);
    const core::Pose pose = hand.skeleton.restPose();
    const core::SkinnedSurface surface = core::makeSkinnedSurface(hand, 0);
    core::PosedPoints posed;
    core::poseSurface(surface, core::boneMatrices(hand.skeleton, pose), posed);
    const std::vector<core::RimSource> sources{{&surface, &posed, &surface, &posed}};
    core::SleeveSearch search;
    for (const core::Camera& camera : test::cameraRing(6, true)) {
        cv::Mat mask = core::renderHandsMask(camera, {hand}, {pose});
        const auto from = core::project(camera, cut.centre - before * cut.direction);
        const auto to = core::project(camera, cut.centre + 100 * cut.direction);
        if (widerMm > 0 && from && to) {
            const double depth = (camera.cameraFromWorld * cut.centre).z();
            const double width = 2 * (cut.radiusMm + widerMm) * camera.intrinsics(0, 0) / depth;
            const Eigen::Vector2d along = (*to - *from).normalized(), side(-along.y(), along.x());
            std::vector<cv::Point> corners;
            for (const Eigen::Vector2d& corner :
                 {Eigen::Vector2d(*from - width / 2 * side), Eigen::Vector2d(*from + width / 2 * side),
                  Eigen::Vector2d(*to + width / 2 * side), Eigen::Vector2d(*to - width / 2 * side)})
                corners.emplace_back(static_cast<int>(corner.x()), static_cast<int>(corner.y()));
            cv::fillConvexPoly(mask, corners, 255);
        }
        core::RimScratch scratch;
        std::vector<core::RimPoint> rim;
        core::visibleRim(camera, sources, {}, scratch, rim);
        search.look(camera, cut, {}, scratch.coverage, mask);
    }
    return search.beginsMm();
}

TEST(Forearm, ASleeveIsFoundWhereItBegins) {
    const core::HandModel hand = test::twoFingerHands().front();
    EXPECT_EQ(foundSleeveMm(hand, 0, 0), 0) << "a bare wrist";
    const double longer = foundSleeveMm(hand, 22, 12), shorter = foundSleeveMm(hand, 10, 12);
    EXPECT_NEAR(longer, 22, 5);
    EXPECT_NEAR(shorter, 10, 5);
}

TEST(Forearm, ACutThatIsMovedCoversTheSleeve) {
    const core::ForearmCut cut = core::forearmCut(test::twoFingerHands().front());
    const core::ForearmCut moved = core::movedTowardsHand(cut, 12);
    EXPECT_NEAR((moved.centre - cut.centre).dot(cut.direction), -12, 1e-9);
    EXPECT_NEAR(moved.endMm, cut.endMm + 12, 1e-9);
    EXPECT_GT(moved.radiusMm, cut.radiusMm);
}

} // namespace
