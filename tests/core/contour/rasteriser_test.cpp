// SPDX-License-Identifier: MIT
#include "core/contour/rasteriser.h"

#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/contour/triangle_scan.h"
#include "tests/support/shapes/solids.h"
#include "tests/support/two_finger_hand.h"

namespace {

using core::Camera;
using core::DepthImage;
using core::PosedSurface;
using core::TriangleMesh;
using Eigen::Vector2d;
using Eigen::Vector3d;

Camera makeRasterCamera(std::vector<double> distortion = {}) {
    Camera camera;
    camera.name = "test";
    camera.size = {120, 90};
    camera.intrinsics << 130, 0, 61.2, 0, 128, 43.7, 0, 0, 1;
    camera.distortion = std::move(distortion);
    camera.cameraFromWorld = {core::rotationExp({0.2, -0.3, 0.1}), {4, -7, 300}};
    return camera;
}

/// Triangles of all sizes, anywhere: some cross each other, some leave the image, some lie behind the camera.
TriangleMesh randomTriangles(int count, const char* seed) {
    test::RandomValues random(seed);
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const Vector3d middle = random.point(i % 10 ? 120 : 600);
        const double half = std::pow(10, random.between(-0.5, 2));
        for (int k = 0; k < 3; ++k)
            mesh.vertices.push_back(middle + random.point(half));
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
}

PosedSurface surfaceOf(const TriangleMesh& mesh) {
    return {&mesh.vertices, &mesh.triangles};
}

/// Margin (px^2) by which a centre lies inside (positive) or outside (negative) a projected triangle, in floating
/// point.
double margin(const std::array<Vector2d, 3>& p, const Vector2d& centre) {
    const auto side = [&](const Vector2d& a, const Vector2d& b) {
        return (b.x() - a.x()) * (centre.y() - a.y()) - (b.y() - a.y()) * (centre.x() - a.x());
    };
    const double s0 = side(p[0], p[1]), s1 = side(p[1], p[2]), s2 = side(p[2], p[0]);
    return std::max(std::min({s0, s1, s2}), std::min({-s0, -s1, -s2}));
}

struct Hit {
    double depth = std::numeric_limits<double>::infinity();
    int triangle = -1;
    double nextDepth = std::numeric_limits<double>::infinity();
    bool close = false; ///< some edge passes too near to the centre to tell sides after rounding
};

/// The nearest triangle at a pixel by projecting every triangle and meeting its plane with the viewing ray.
Hit bruteForce(const Camera& camera, const TriangleMesh& mesh, int x, int y) {
    Hit hit;
    const auto normalised = core::undistort(camera, Vector2d(x, y));
    const Vector3d ray = normalised->homogeneous();
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        std::array<Vector2d, 3> px;
        std::array<Vector3d, 3> points;
        bool seen = true;
        double span = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector3d& world =
                mesh.vertices[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(t)][k])];
            points[k] = camera.cameraFromWorld * world;
            const auto p = core::project(camera, world);
            seen = seen && p;
            px[k] = p.value_or(Vector2d(0, 0));
            span = std::max(span, px[k].cwiseAbs().maxCoeff());
        }
        if (!seen)
            continue;
        const double inside = margin(px, Vector2d(x, y));
        hit.close = hit.close || std::abs(inside) < (span + 100) / 2048;
        if (inside > 0) {
            const Vector3d normal = (points[1] - points[0]).cross(points[2] - points[0]);
            const double depth = normal.dot(points[0]) / normal.dot(ray); // ray.z() == 1
            hit.nextDepth = std::min(hit.nextDepth, std::max(depth, hit.depth));
            if (depth < hit.depth) {
                hit.depth = depth;
                hit.triangle = t;
            }
        }
    }
    return hit;
}

TEST(Rasteriser, FindsTheTriangleAndDepthOfBruteForceRays) {
    const Camera camera = makeRasterCamera();
    const TriangleMesh mesh = randomTriangles(120, "ray casting");
    const DepthImage image = core::renderDepth(camera, {surfaceOf(mesh)});
    ASSERT_EQ(image.depthMm.type(), CV_32F);
    ASSERT_EQ(image.triangle.type(), CV_32S);
    int compared = 0, covered = 0, grazing = 0;
    for (int y = 0; y < camera.size.height; ++y) {
        for (int x = 0; x < camera.size.width; ++x) {
            const Hit oracle = bruteForce(camera, mesh, x, y);
            if (oracle.close)
                continue;
            ++compared;
            const int triangle = image.triangle.at<int>(y, x);
            const double depth = static_cast<double>(image.depthMm.at<float>(y, x));
            if (triangle != oracle.triangle) { // only where two surfaces are equally deep in single precision
                ++grazing;
                EXPECT_LT(oracle.nextDepth - oracle.depth, 1e-4 * oracle.depth) << x << " " << y;
            } else if (triangle >= 0) {
                ++covered;
                EXPECT_NEAR(depth, oracle.depth, 1e-5 * oracle.depth) << x << " " << y;
            } else {
                EXPECT_TRUE(std::isinf(depth));
            }
        }
    }
    EXPECT_GT(compared, 4000);
    EXPECT_GT(covered, 2000);
    EXPECT_LT(grazing, 10);
}

TEST(Rasteriser, MaskIsWhereThereIsATriangle) {
    for (const char* seed : {"mask a", "mask b", "mask c"}) {
        for (const Camera& camera : {makeRasterCamera(), makeRasterCamera({-0.2, 0.05, 0.002, -0.001, 0})}) {
            const TriangleMesh mesh = randomTriangles(150, seed), other = randomTriangles(30, "more");
            const std::vector<PosedSurface> surfaces{surfaceOf(mesh), surfaceOf(other)};
            const DepthImage image = core::renderDepth(camera, surfaces);
            const cv::Mat mask = core::renderMask(camera, surfaces);
            ASSERT_EQ(mask.type(), CV_8U);
            cv::Mat expected;
            cv::compare(image.triangle, 0, expected, cv::CMP_GE);
            EXPECT_EQ(cv::countNonZero(mask != expected), 0);
            EXPECT_GT(cv::countNonZero(mask), 1000);
            EXPECT_LT(cv::countNonZero(mask), 120 * 90);
        }
    }
}

TEST(Rasteriser, DepthsOfSliversStayWithinTheirCorners) {
    // Triangles that are seen edge-on and shrink to next to nothing in the image: a pixel's centre that falls into one
    // after rounding must not be extrapolated far away.
    const Camera camera = makeRasterCamera();
    const core::RigidMotion worldFromCamera = core::inverse(camera.cameraFromWorld);
    test::RandomValues random("slivers");
    TriangleMesh mesh;
    std::vector<std::pair<double, double>> range;
    for (int y = 0; y < camera.size.height; ++y) {
        for (int x = 0; x < camera.size.width; ++x) {
            double low = std::numeric_limits<double>::infinity(), high = 0;
            const double halfPx = std::pow(10, random.between(-4, -1));
            for (int k = 0; k < 3; ++k) {
                const auto normalised = core::undistort(camera, Vector2d(x, y) + random.vector(2, halfPx));
                const Vector3d corner = random.between(100, 500) * normalised->homogeneous();
                low = std::min(low, corner.z());
                high = std::max(high, corner.z());
                mesh.vertices.push_back(worldFromCamera * corner);
            }
            const int first = static_cast<int>(mesh.vertices.size()) - 3;
            mesh.triangles.push_back({first, first + 1, first + 2});
            range.emplace_back(low, high);
        }
    }
    const DepthImage image = core::renderDepth(camera, {surfaceOf(mesh)});
    const cv::Mat mask = core::renderMask(camera, {surfaceOf(mesh)});
    int covered = 0;
    for (int y = 0; y < camera.size.height; ++y) {
        for (int x = 0; x < camera.size.width; ++x) {
            const int triangle = image.triangle.at<int>(y, x);
            EXPECT_EQ(triangle >= 0, mask.at<unsigned char>(y, x) != 0) << x << " " << y;
            if (triangle >= 0) {
                ++covered;
                const auto [low, high] = range[static_cast<std::size_t>(triangle)];
                const double depth = static_cast<double>(image.depthMm.at<float>(y, x));
                EXPECT_GE(depth, low * (1 - 1e-6));
                EXPECT_LE(depth, high * (1 + 1e-6));
            }
        }
    }
    EXPECT_GT(covered, 1000);
}

TEST(Rasteriser, TheAreaOfABallIsThatOfItsAnalyticSilhouette) {
    // A pixel-centre rule is right on average: a filled polygon of OpenCV would be half a pixel too large all around.
    Camera camera = makeRasterCamera();
    camera.size = {600, 500};
    camera.intrinsics << 1300, 0, 300.4, 0, 1300, 249.8, 0, 0, 1;
    camera.cameraFromWorld = {Eigen::Matrix3d::Identity(), {0, 0, 400}};
    const TriangleMesh mesh = test::ball({0, 0, 0}, 50, 96, 192);
    const double area = cv::countNonZero(core::renderMask(camera, {surfaceOf(mesh)}));
    const double sine = 50.0 / 400, radius = 1300 * sine / std::sqrt(1 - sine * sine);
    EXPECT_NEAR(std::sqrt(area / M_PI), radius, 0.08);
}

TEST(Rasteriser, TrianglesAreNumberedAcrossSurfaces) {
    const Camera camera = makeRasterCamera();
    const TriangleMesh near = test::ball({-25, 0, 0}, 20, 12, 24), far = test::ball({25, 0, 0}, 20, 12, 24);
    const DepthImage image = core::renderDepth(camera, {surfaceOf(near), surfaceOf(far)});
    const int first = static_cast<int>(near.triangles.size());
    const auto at = [&](const Vector3d& world) {
        const Vector2d px = core::project(camera, world)->array().round();
        return image.triangle.at<int>(static_cast<int>(px.y()), static_cast<int>(px.x()));
    };
    EXPECT_GE(at({-25, 0, 0}), 0);
    EXPECT_LT(at({-25, 0, 0}), first);
    EXPECT_GE(at({25, 0, 0}), first);
    EXPECT_EQ(at({-25, 60, 0}), -1);
}

TEST(Rasteriser, LeavesOutTrianglesWithAVertexBehindTheCamera) {
    Camera camera = makeRasterCamera();
    camera.cameraFromWorld = {};
    TriangleMesh mesh;
    mesh.vertices = {{-50, -50, 100}, {50, -50, 100}, {0, 80, -10}};
    mesh.triangles = {{0, 1, 2}};
    EXPECT_EQ(cv::countNonZero(core::renderMask(camera, {surfaceOf(mesh)})), 0);
    mesh.vertices[2].z() = 100;
    EXPECT_GT(cv::countNonZero(core::renderMask(camera, {surfaceOf(mesh)})), 100);
}

TEST(Rasteriser, SilhouetteOfTheHandsIsTheirUnion) {
    const std::vector<core::HandModel> hands = test::twoFingerHands();
    test::RandomValues random("hands mask");
    core::HandPoses poses;
    std::vector<std::vector<Vector3d>> vertices;
    for (const core::HandModel& hand : hands) {
        poses.push_back(test::somePose(hand.skeleton, random));
        vertices.push_back(core::posedVertices(hand, poses.back()));
    }
    const Camera camera = makeRasterCamera();
    const cv::Mat both = core::renderHandsMask(camera, hands, poses);
    const cv::Mat left = core::renderMask(camera, {{&vertices[0], &hands[0].mesh.triangles}});
    const cv::Mat right = core::renderMask(camera, {{&vertices[1], &hands[1].mesh.triangles}});
    EXPECT_EQ(cv::countNonZero(both != (left | right)), 0);
    EXPECT_GT(cv::countNonZero(left), 500);
    EXPECT_GT(cv::countNonZero(right), 500);
}

TEST(Rasteriser, NothingToDrawIsBackground) {
    const Camera camera = makeRasterCamera();
    EXPECT_EQ(cv::countNonZero(core::renderMask(camera, {})), 0);
    const DepthImage image = core::renderDepth(camera, {});
    EXPECT_EQ(cv::countNonZero(image.triangle != -1), 0);
    EXPECT_EQ(image.depthMm.size(), cv::Size(120, 90));
}

} // namespace
