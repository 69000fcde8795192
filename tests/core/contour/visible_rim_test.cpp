// SPDX-License-Identifier: MIT
#include "core/contour/visible_rim.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/contour/oriented_contour.h"
#include "core/contour/rasteriser.h"
#include "tests/support/shapes/solids.h"
#include "tests/support/two_finger_hand.h"

namespace {

using core::Camera;
using core::RimOptions;
using core::RimPoint;
using core::RimScratch;
using Eigen::Vector2d;
using Eigen::Vector3d;

Camera makeRimCamera(std::vector<double> distortion = {}, bool fisheye = false) {
    Camera camera;
    camera.name = "test";
    camera.size = {960, 720};
    camera.intrinsics << 900, 0, 483.1, 0, 870, 355.6, 0, 0, 1;
    camera.distortion = std::move(distortion);
    camera.fisheye = fisheye;
    camera.cameraFromWorld = {core::rotationExp({0.1, -0.2, 0.3}), {5, -8, 600}};
    return camera;
}

/// Hands, their levels and their posed points, as the rim wants them.
class Scene {
public:
    explicit Scene(std::vector<core::HandModel> hands, core::HandPoses poses, int targetVertices = 0,
                   int coverVertices = 0)
        : m_hands(std::move(hands))
        , m_poses(std::move(poses))
        , m_levels(m_hands.size())
        , m_covers(m_hands.size())
        , m_points(m_hands.size())
        , m_coverPoints(m_hands.size()) {
        for (std::size_t h = 0; h < m_hands.size(); ++h) {
            const core::BoneMatrices bones = core::boneMatrices(m_hands[h].skeleton, m_poses[h]);
            m_levels[h] = core::makeSkinnedSurface(m_hands[h], targetVertices);
            m_covers[h] = core::makeSkinnedSurface(m_hands[h], coverVertices);
            core::poseSurface(m_levels[h], bones, m_points[h]);
            core::poseSurface(m_covers[h], bones, m_coverPoints[h]);
        }
    }

    std::vector<RimPoint> rim(const Camera& camera, int maxPoints = 1000000) {
        RimOptions options;
        options.maxPoints = maxPoints;
        std::vector<RimPoint> rim;
        core::visibleRim(camera, sources(), options, m_scratch, rim);
        return rim;
    }

    double differencePx2(const Camera& camera, const cv::Mat& mask, float cellPx) {
        RimOptions options;
        options.cellPx = cellPx;
        return core::compareSilhouettes(camera, sources(), options, mask, {}, core::maskBounds(mask), m_scratch)
            .differencePx2;
    }

    const core::SkinnedSurface& level(std::size_t hand) const { return m_levels[hand]; }
    core::PosedPoints& points(std::size_t hand) { return m_points[hand]; }
    cv::Mat mask(const Camera& camera) const { return core::renderHandsMask(camera, m_hands, m_poses); }

private:
    std::vector<core::RimSource> sources() const {
        std::vector<core::RimSource> sources;
        for (std::size_t h = 0; h < m_hands.size(); ++h)
            sources.push_back({&m_levels[h], &m_points[h], &m_covers[h], &m_coverPoints[h]});
        return sources;
    }

    std::vector<core::HandModel> m_hands;
    core::HandPoses m_poses;
    std::vector<core::SkinnedSurface> m_levels, m_covers;
    std::vector<core::PosedPoints> m_points, m_coverPoints;
    RimScratch m_scratch;
};

struct Ball {
    Vector3d centre;
    double radius;
};

Scene ballScene(const std::vector<Ball>& balls) {
    std::vector<core::HandModel> hands;
    core::HandPoses poses;
    for (const Ball& ball : balls) {
        hands.push_back(test::rigidHand(test::ball(ball.centre, ball.radius)));
        poses.push_back(hands.back().skeleton.restPose());
    }
    Scene scene(std::move(hands), std::move(poses));
    for (std::size_t b = 0; b < balls.size(); ++b) { // the exact normals of a ball
        core::PosedPoints& points = scene.points(b);
        for (std::size_t v = 0; v < points.positions.size(); ++v)
            points.normals[v] = (points.positions[v] - balls[b].centre.cast<float>()).normalized();
    }
    return scene;
}

/// The circle on a ball where lines of sight touch it.
class Silhouette {
public:
    Silhouette(const Camera& camera, const Ball& ball)
        : m_camera(camera) {
        const Vector3d towards = camera.centreInWorld() - ball.centre;
        const double sine = ball.radius / towards.norm();
        m_centre = ball.centre + sine * sine * towards;
        m_radius = ball.radius * std::sqrt(1 - sine * sine);
        m_u = towards.unitOrthogonal();
        m_v = towards.normalized().cross(m_u);
    }

    double angleOf(const Vector3d& point) const {
        return std::atan2((point - m_centre).dot(m_v), (point - m_centre).dot(m_u));
    }
    Vector3d point(double angle) const { return m_centre + m_radius * (std::cos(angle) * m_u + std::sin(angle) * m_v); }
    Vector2d px(double angle) const { return *core::project(m_camera, point(angle)); }

    /// Outward normal of the image of the circle, by central differences along it.
    Vector2d normalPx(double angle) const {
        const Vector2d tangent = px(angle + 1e-5) - px(angle - 1e-5);
        const Vector2d normal = Vector2d(-tangent.y(), tangent.x()).normalized();
        return normal.dot(px(angle) - px(angle + std::numbers::pi)) > 0 ? normal : Vector2d(-normal);
    }

private:
    const Camera& m_camera;
    Vector3d m_centre, m_u, m_v;
    double m_radius;
};

/// How far outside the ball's outline a pixel lies, px; negative inside. By the distance of its line of sight.
double outsidePx(const Camera& camera, const Ball& ball, const Vector2d& px) {
    const double mm = core::viewingRay(camera, px)->offset(ball.centre).norm() - ball.radius;
    return mm * 885 / (camera.cameraFromWorld * ball.centre).z();
}

TEST(VisibleRim, OfABallIsItsAnalyticSilhouette) {
    for (const Camera& camera : {makeRimCamera(), makeRimCamera({-0.25, 0.08, 0.002, -0.001, 0.01}),
                                 makeRimCamera({0.02, -0.01, 0, 0}, true)}) {
        for (const Ball& ball : {Ball{{0, 0, 0}, 60}, Ball{{-150, 70, 20}, 45}, Ball{{170, -90, -60}, 50}}) {
            Scene scene = ballScene({ball});
            const Silhouette silhouette(camera, ball);
            const std::vector<RimPoint> rim = scene.rim(camera);
            ASSERT_GT(rim.size(), 90u);
            for (const RimPoint& point : rim) {
                const double angle = silhouette.angleOf(point.point.cast<double>());
                EXPECT_LT((point.point.cast<double>() - silhouette.point(angle)).norm(), 0.05);
                EXPECT_LT((point.px.cast<double>() - silhouette.px(angle)).norm(), 0.08);
                EXPECT_LT((point.px.cast<double>() - *core::project(camera, point.point.cast<double>())).norm(), 1e-3);
                EXPECT_GT(point.normal.cast<double>().dot((point.point.cast<double>() - ball.centre).normalized()),
                          0.9999);
                EXPECT_GT(point.normalPx.cast<double>().dot(silhouette.normalPx(angle)), std::cos(0.2 * M_PI / 180));
                EXPECT_NEAR(point.normalPx.norm(), 1, 1e-5);
            }
        }
    }
}

TEST(VisibleRim, ImageNormalsHoldForSkewedPixels) {
    Camera camera = makeRimCamera({-0.25, 0.08, 0.002, -0.001, 0.01});
    camera.intrinsics(0, 1) = 90;
    const Ball ball{{-120, 60, 20}, 45};
    Scene scene = ballScene({ball});
    const Silhouette silhouette(camera, ball);
    for (const RimPoint& point : scene.rim(camera)) {
        const double angle = silhouette.angleOf(point.point.cast<double>());
        EXPECT_LT((point.px.cast<double>() - silhouette.px(angle)).norm(), 0.08);
        EXPECT_GT(point.normalPx.cast<double>().dot(silhouette.normalPx(angle)), std::cos(0.2 * M_PI / 180));
    }
}

TEST(VisibleRim, GoesAllTheWayAround) {
    const Camera camera = makeRimCamera();
    const Ball ball{{0, 0, 0}, 60};
    Scene scene = ballScene({ball});
    const Silhouette silhouette(camera, ball);
    for (const int maxPoints : {1000000, 60}) {
        std::vector<double> angles;
        for (const RimPoint& point : scene.rim(camera, maxPoints))
            angles.push_back(silhouette.angleOf(point.point.cast<double>()));
        ASSERT_LE(angles.size(), static_cast<std::size_t>(maxPoints));
        std::sort(angles.begin(), angles.end());
        double widest = angles.front() + 2 * std::numbers::pi - angles.back();
        for (std::size_t i = 1; i < angles.size(); ++i)
            widest = std::max(widest, angles[i] - angles[i - 1]);
        EXPECT_LT(widest, maxPoints == 60 ? 0.6 : 0.1);
    }
}

TEST(VisibleRim, NamesTheEdgeItLiesOn) {
    Scene scene = ballScene({{{-50, 0, 0}, 30}, {{50, 0, 0}, 30}});
    std::array<int, 2> perHand{0, 0};
    for (const RimPoint& point : scene.rim(makeRimCamera())) {
        ++perHand.at(static_cast<std::size_t>(point.hand));
        EXPECT_GE(point.t, 0);
        EXPECT_LE(point.t, 1);
        const auto& edges = scene.level(static_cast<std::size_t>(point.hand)).edges;
        EXPECT_NE(std::find(edges.begin(), edges.end(), std::array<int, 2>{point.vertexA, point.vertexB}), edges.end());
        const auto& positions = scene.points(static_cast<std::size_t>(point.hand)).positions;
        const Eigen::Vector3f chord = positions[static_cast<std::size_t>(point.vertexA)] * (1 - point.t) +
                                      positions[static_cast<std::size_t>(point.vertexB)] * point.t;
        EXPECT_LT((point.point - chord).norm(), 0.1f) << "lifted off the chord by less than the sagitta";
    }
    EXPECT_GT(perHand[0], 50);
    EXPECT_GT(perHand[1], 50);
}

TEST(VisibleRim, OfTwoBallsIsTheOutlineOfTheirUnion) {
    const Camera camera = makeRimCamera();
    const std::vector<Ball> balls{{{-30, 0, 40}, 60}, {{45, 20, -60}, 45}};
    const std::vector<RimPoint> both = ballScene(balls).rim(camera);
    int hidden = 0, kept = 0;
    for (std::size_t b = 0; b < 2; ++b) {
        const std::vector<RimPoint> alone = ballScene({balls[b]}).rim(camera);
        for (const RimPoint& point : alone) {
            const double outside = outsidePx(camera, balls[1 - b], point.px.cast<double>());
            const bool found = std::any_of(both.begin(), both.end(), [&](const RimPoint& other) {
                return other.hand == static_cast<int>(b) && other.vertexA == point.vertexA &&
                       other.vertexB == point.vertexB;
            });
            if (outside < -6) {
                EXPECT_FALSE(found) << "hidden by, or in front of, the other ball: " << outside << " px";
                ++hidden;
            } else if (outside > 2) {
                EXPECT_TRUE(found) << outside << " px outside the other ball";
                ++kept;
            }
        }
    }
    EXPECT_GT(hidden, 25);
    EXPECT_GT(kept, 120);
}

TEST(VisibleRim, HasNoCreaseInFrontOfAnotherSurface) {
    const Camera camera = makeRimCamera();
    const Vector3d between = 0.7 * Vector3d(0, 0, 0) + 0.3 * camera.centreInWorld();
    for (const RimPoint& point : ballScene({{{0, 0, 0}, 80}, {between, 15}}).rim(camera))
        EXPECT_EQ(point.hand, 0);
}

TEST(VisibleRim, StaysWithinTheImage) {
    Camera camera = makeRimCamera();
    camera.size = {470, 360}; // cuts the ball in the middle
    const std::vector<RimPoint> rim = ballScene({{{0, 0, 0}, 80}}).rim(camera);
    ASSERT_GT(rim.size(), 20u);
    for (const RimPoint& point : rim) {
        EXPECT_GE(point.px.minCoeff(), 0.5f);
        EXPECT_LE(point.px.x(), 468.5f);
        EXPECT_LE(point.px.y(), 358.5f);
    }
    camera.size = {100, 100};
    EXPECT_TRUE(ballScene({{{0, 0, 0}, 80}}).rim(camera).empty());
}

struct OutlineErrors {
    double mean = 0, share95 = 0, farthest = 0;
};

/// Distances (px) from each point of one list to the nearest of another.
OutlineErrors nearestDistances(const std::vector<Vector2d>& from, const std::vector<Vector2d>& to) {
    std::vector<double> distances;
    OutlineErrors errors;
    for (const Vector2d& p : from) {
        double least = 1e9;
        for (const Vector2d& q : to)
            least = std::min(least, (p - q).norm());
        distances.push_back(least);
        errors.mean += least / static_cast<double>(from.size());
    }
    std::sort(distances.begin(), distances.end());
    errors.share95 = distances[distances.size() * 95 / 100];
    errors.farthest = distances.back();
    return errors;
}

std::vector<Vector2d> rimPixels(const std::vector<RimPoint>& rim) {
    std::vector<Vector2d> px;
    for (const RimPoint& point : rim)
        px.push_back(point.px.cast<double>());
    return px;
}

TEST(VisibleRim, OfHandsLiesOnTheOutlineOfTheirSilhouette) {
    test::RandomValues random("rim of hands");
    const Camera camera = makeRimCamera({-0.12, 0.05, 0.001, -0.0008, 0});
    const std::vector<core::HandModel> hands = test::twoFingerHands();
    for (int trial = 0; trial < 6; ++trial) {
        core::HandPoses poses;
        for (const core::HandModel& hand : hands)
            poses.push_back(test::somePose(hand.skeleton, random, 25, 0.7));
        for (const int level : {0, 2000, 700}) {
            Scene scene(hands, poses, level, 700);
            const core::OrientedContour contour = core::orientedContour(scene.mask(camera));
            std::vector<Vector2d> outline;
            for (std::size_t i = 0; i < contour.size(); ++i)
                outline.emplace_back(contour.x[i], contour.y[i]);
            const std::vector<Vector2d> rim = rimPixels(scene.rim(camera));
            ASSERT_GT(rim.size(), 100u);
            const OutlineErrors there = nearestDistances(rim, outline), back = nearestDistances(outline, rim);
            EXPECT_LT(there.mean, level == 700 ? 0.8 : 0.55) << level; // pixels of the outline are 1 apart
            EXPECT_LT(there.share95, level == 700 ? 2.5 : 1.2) << level;
            EXPECT_LT(there.farthest, 7) << level << ": no creases inside";
            EXPECT_LT(back.share95, level == 700 ? 16 : 8) << level << ": nothing of the outline is missed";
        }
    }
}

TEST(VisibleRim, IsTheSameAgainWithUsedScratch) {
    test::RandomValues random("again");
    const std::vector<core::HandModel> hands = test::twoFingerHands();
    Scene scene(hands, {test::somePose(hands[0].skeleton, random), test::somePose(hands[1].skeleton, random)}, 700,
                700);
    const Camera camera = makeRimCamera();
    const std::vector<RimPoint> first = scene.rim(camera, 150);
    Camera elsewhere = camera;
    elsewhere.cameraFromWorld.translation.z() = 350;
    scene.rim(elsewhere, 80);
    const std::vector<RimPoint> again = scene.rim(camera, 150);
    ASSERT_EQ(first.size(), 150u);
    ASSERT_EQ(again.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].px, again[i].px);
        EXPECT_EQ(first[i].point, again[i].point);
    }
}

TEST(VisibleRim, OfNothingIsEmpty) {
    RimScratch scratch;
    std::vector<RimPoint> rim(3);
    core::visibleRim(makeRimCamera(), {}, {}, scratch, rim);
    EXPECT_TRUE(rim.empty());
}

TEST(SilhouetteDifference, IsTheAreaWhereMasksDisagree) {
    test::RandomValues random("difference");
    const Camera camera = makeRimCamera({-0.12, 0.05, 0.001, -0.0008, 0});
    const std::vector<core::HandModel> hands = test::twoFingerHands();
    core::HandPoses poses;
    for (const core::HandModel& hand : hands)
        poses.push_back(test::somePose(hand.skeleton, random));
    Scene scene(hands, poses);
    const cv::Mat own = scene.mask(camera);
    cv::Mat other = own.clone();
    for (core::Pose& pose : poses)
        pose.head<3>() += Vector3d(12, -4, 0);
    const cv::Mat moved = core::renderHandsMask(camera, hands, poses);
    cv::rectangle(other, {40, 50}, {99, 79}, cv::Scalar(255), cv::FILLED); // far from the hands
    EXPECT_NEAR(scene.differencePx2(camera, other, 2), 60 * 30, 600);
    for (const float cellPx : {1.0f, 2.0f, 4.0f}) {
        const double expected = cv::countNonZero(own != moved);
        EXPECT_NEAR(scene.differencePx2(camera, moved, cellPx), expected, 0.05 * expected) << cellPx;
        EXPECT_LT(scene.differencePx2(camera, own, cellPx), 0.1 * expected) << cellPx;
    }
}

} // namespace
