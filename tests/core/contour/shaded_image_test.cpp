// SPDX-License-Identifier: MIT
#include "core/contour/shaded_image.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "tests/support/shapes/ball.h"

namespace {

using namespace core;

using test::makeBall;

ShadedSurface shaded(const test::Ball& ball, const Eigen::Vector3f& colour) {
    return {{&ball.vertices, &ball.triangles}, &ball.normals, colour};
}

Camera makeCamera() {
    Camera camera;
    camera.name = "test";
    camera.size = {160, 120};
    camera.intrinsics << 200, 0, 79.3, 0, 201, 60.2, 0, 0, 1;
    camera.distortion = {-0.1, 0.03, 0.001, -0.002, 0};
    camera.cameraFromWorld.translation = {3, -2, 400};
    return camera;
}

bool isBackdrop(const cv::Vec3b& bgr) {
    return std::max({bgr[0], bgr[1], bgr[2]}) < 70;
}

TEST(ShadedImage, SilhouetteIsThatOfTheMask) {
    const test::Ball one = makeBall({-30, 0, 0}, 50), two = makeBall({40, 20, -30}, 35);
    const Camera camera = makeCamera();
    const cv::Mat mask = renderMask(camera, {shaded(one, {}).surface, shaded(two, {}).surface});
    const cv::Mat overlay = renderOverlay(camera, {shaded(one, {1, 0, 0}), shaded(two, {0, 1, 0})}, {});
    // Bright surfaces on a black backdrop: what is lit is the silhouette.
    const cv::Mat image =
        renderShaded(camera, {shaded(one, {1, 1, 1}), shaded(two, {1, 1, 1})}, {}, {{0, 0, 0}, {0, 0, 0}});
    ASSERT_EQ(image.size(), mask.size());
    int covered = 0;
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
            const bool inside = mask.at<unsigned char>(y, x) != 0;
            covered += inside;
            EXPECT_EQ(overlay.at<cv::Vec4b>(y, x)[3] > 0, inside) << x << " " << y;
            EXPECT_EQ(image.at<cv::Vec3b>(y, x) != cv::Vec3b(0, 0, 0), inside) << x << " " << y;
        }
    }
    EXPECT_GT(covered, 2000);
}

TEST(ShadedImage, KeyLightComesFromItsSide) {
    const test::Ball ball = makeBall({0, 0, 0}, 60, 64, 128);
    Camera camera = makeCamera();
    camera.distortion.clear();
    camera.cameraFromWorld.translation = {0, 0, 400};
    Lighting lighting;
    lighting.keyDirection = {-1, 0, -0.2f};
    lighting.fill = lighting.rim = lighting.specular = lighting.warmth = 0;
    const cv::Mat image = renderShaded(camera, {shaded(ball, {0.8f, 0.8f, 0.8f})}, lighting);
    const int y = 60;
    for (int x = 57; x <= 100; ++x) // from the lit left side to the right, it only gets darker
        EXPECT_LE(image.at<cv::Vec3b>(y, x + 1)[1], image.at<cv::Vec3b>(y, x)[1] + 1) << x;
    EXPECT_GT(image.at<cv::Vec3b>(y, 57)[1], image.at<cv::Vec3b>(y, 100)[1] + 80);
}

TEST(ShadedImage, BackdropFillsTheRestAndDarkensTowardsCorners) {
    const test::Ball ball = makeBall({0, 0, 0}, 20);
    const cv::Mat image = renderShaded(makeCamera(), {shaded(ball, skinColour(Side::Left))});
    EXPECT_TRUE(isBackdrop(image.at<cv::Vec3b>(0, 0)));
    EXPECT_TRUE(isBackdrop(image.at<cv::Vec3b>(119, 159)));
    EXPECT_FALSE(isBackdrop(image.at<cv::Vec3b>(60, 80)));
    EXPECT_GT(image.at<cv::Vec3b>(60, 40)[1], image.at<cv::Vec3b>(0, 0)[1] + 20);
}

TEST(ShadedImage, NearestSurfaceWins) {
    const test::Ball far = makeBall({0, 0, 60}, 40), near = makeBall({0, 0, -60}, 20);
    const cv::Mat image = renderOverlay(makeCamera(), {shaded(near, {1, 0, 0}), shaded(far, {0, 0, 1})},
                                        {OverlayStyle::Shaded, 1.0f, false});
    const auto middle = image.at<cv::Vec4b>(60, 80);
    EXPECT_GT(middle[2], 2 * middle[0]); // red is in front
    const auto beside = image.at<cv::Vec4b>(60, 94);
    EXPECT_GT(beside[0], 2 * beside[2]);
}

TEST(ShadedImage, OverlayIsPremultipliedAndItsEdgeIsStrong) {
    const test::Ball ball = makeBall({0, 0, 0}, 50);
    const cv::Mat image = renderOverlay(makeCamera(), {shaded(ball, {1, 1, 1})}, {OverlayStyle::Shaded, 0.35f, true});
    int edge = 0, inner = 0;
    for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
            const auto p = image.at<cv::Vec4b>(y, x);
            EXPECT_LE(std::max({p[0], p[1], p[2]}), p[3]);
            edge += p[3] == 255;
            inner += p[3] == 89; // 0.35 * 255
            EXPECT_TRUE(p[3] == 0 || p[3] == 89 || p[3] == 255);
        }
    }
    // The outline of a disc of radius r px has about 2 pi r / 1.1 pixels (4-connected neighbours outside).
    EXPECT_NEAR(edge, 2 * M_PI * 25.2 * 0.9, 20);
    EXPECT_NEAR(inner + edge, M_PI * 25.2 * 25.2, 60);
}

TEST(ShadedImage, WiresLeaveHolesAndShadedDoesNot) {
    const test::Ball ball = makeBall({0, 0, 0}, 60, 6, 8);
    const cv::Mat wires =
        renderOverlay(makeCamera(), {shaded(ball, {1, 1, 1})}, {OverlayStyle::Wireframe, 1.0f, false});
    int strong = 0, holes = 0, covered = 0;
    const cv::Mat mask = renderMask(makeCamera(), {shaded(ball, {}).surface});
    for (int y = 0; y < wires.rows; ++y) {
        for (int x = 0; x < wires.cols; ++x) {
            const int alpha = wires.at<cv::Vec4b>(y, x)[3];
            const bool inside = mask.at<unsigned char>(y, x) != 0;
            covered += inside;
            holes += inside && alpha == 0;
            strong += alpha > 128;
            EXPECT_TRUE(inside || alpha == 0);
        }
    }
    EXPECT_GT(holes, covered / 3);
    EXPECT_GT(strong, 100);
}

TEST(ShadedImage, NothingToDrawIsTheBackdropOrNothing) {
    const cv::Mat image = renderShaded(makeCamera(), {});
    EXPECT_TRUE(isBackdrop(image.at<cv::Vec3b>(60, 80)));
    EXPECT_EQ(cv::sum(renderOverlay(makeCamera(), {}, {})), cv::Scalar(0, 0, 0, 0));
}

TEST(ShadedImage, HandsDifferInHue) {
    EXPECT_GT((skinColour(Side::Left) - skinColour(Side::Right)).norm(), 0.03f);
    EXPECT_LT((skinColour(Side::Left) - skinColour(Side::Right)).norm(), 0.2f);
}

} // namespace
