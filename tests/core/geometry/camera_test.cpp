// SPDX-License-Identifier: MIT
#include "core/geometry/camera.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include "core/geometry/lens_coverage.h"
#include "tests/support/random_values.h"

namespace {

using core::Camera;
using Eigen::Vector2d;
using Eigen::Vector3d;

Camera makeCamera(std::vector<double> distortion, bool fisheye = false) {
    Camera camera;
    camera.name = "test";
    camera.size = {1280, 960};
    camera.intrinsics << 905, 0, 651.3, 0, 897, 470.8, 0, 0, 1;
    camera.distortion = std::move(distortion);
    camera.fisheye = fisheye;
    camera.cameraFromWorld.rotation = core::rotationExp({0.3, -0.7, 0.2});
    camera.cameraFromWorld.translation = {20, -35, 700};
    return camera;
}

/// Every kind of lens, OpenCV's numbers of coefficients.
std::vector<Camera> allLenses() {
    return {makeCamera({}),
            makeCamera({-0.21, 0.07, 0.0013, -0.0021}),
            makeCamera({-0.31, 0.14, -0.0007, 0.0011, -0.033}),
            makeCamera({0.18, -0.05, 0.002, 0.001, 0.01}),
            makeCamera({0.41, -0.12, 0.0009, -0.0013, 0.021, 0.69, -0.09, 0.015}),
            makeCamera({0.03, -0.011, 0.004, -0.0009}, true)};
}

/// A point in the world that the camera sees at the normalised coordinates.
Vector3d pointAt(const Camera& camera, const Vector2d& normalised, double depthMm) {
    return core::inverse(camera.cameraFromWorld) * Vector3d(depthMm * normalised.homogeneous());
}

/// What OpenCV makes of a point; its lens models only know cameras without skew.
Vector2d openCvPixel(const Camera& camera, const Vector3d& pointInWorld) {
    const auto& m = camera.intrinsics;
    const cv::Matx33d k(m(0, 0), 0, m(0, 2), 0, m(1, 1), m(1, 2), 0, 0, 1);
    const Vector3d vector = core::rotationLog(camera.cameraFromWorld.rotation), &t = camera.cameraFromWorld.translation;
    const cv::Vec3d rotation(vector.x(), vector.y(), vector.z()), translation(t.x(), t.y(), t.z());
    const std::vector<cv::Point3d> points{{pointInWorld.x(), pointInWorld.y(), pointInWorld.z()}};
    std::vector<cv::Point2d> px;
    if (camera.fisheye)
        cv::fisheye::projectPoints(points, px, cv::Affine3d(rotation, translation), k, camera.distortion);
    else
        cv::projectPoints(points, rotation, translation, k, camera.distortion, px);
    return {px[0].x, px[0].y};
}

TEST(Camera, ProjectsLikeOpenCv) {
    test::RandomValues random("project");
    for (const Camera& camera : allLenses()) {
        for (int trial = 0; trial < 100; ++trial) {
            const Vector3d point = pointAt(camera, random.vector(2, 0.7), random.between(200, 1500));
            const auto px = core::project(camera, point);
            ASSERT_TRUE(px);
            EXPECT_LT((*px - openCvPixel(camera, point)).norm(), 1e-8) << camera.distortion.size() << camera.fisheye;
        }
    }
}

TEST(Camera, ProjectsTheOpticalAxisToThePrincipalPoint) {
    for (const Camera& camera : allLenses()) {
        const auto projection = core::projectWithJacobian(camera, pointAt(camera, {0, 0}, 500));
        ASSERT_TRUE(projection);
        EXPECT_LT((projection->px - Vector2d(651.3, 470.8)).norm(), 1e-9);
        EXPECT_TRUE(projection->pxByPointInWorld.allFinite());
    }
}

TEST(Camera, SeesNothingOnOrBehindItsPlane) {
    for (const Camera& camera : allLenses()) {
        for (const double depth : {-300.0, 0.0}) {
            const Vector3d point = core::inverse(camera.cameraFromWorld) * Vector3d(10, 20, depth);
            EXPECT_FALSE(core::project(camera, point));
            EXPECT_FALSE(core::projectWithJacobian(camera, point));
        }
        const Vector3d lost(0, std::numeric_limits<double>::quiet_NaN(), 0);
        EXPECT_FALSE(core::project(camera, lost));
    }
}

TEST(Camera, JacobianIsThatOfFiniteDifferences) {
    test::RandomValues random("projection jacobian");
    std::vector<Camera> cameras = allLenses();
    cameras.push_back(makeCamera({-0.2, 0.05, 0.001, 0.002, 0}));
    cameras.back().intrinsics(0, 1) = 3.5; // skew
    for (const Camera& camera : cameras) {
        for (int trial = 0; trial < 30; ++trial) {
            const Vector3d point = pointAt(camera, random.vector(2, 0.6), random.between(300, 1000));
            const auto projection = core::projectWithJacobian(camera, point);
            ASSERT_TRUE(projection);
            EXPECT_LT((projection->px - *core::project(camera, point)).norm(), 1e-10);
            core::Matrix23d numeric;
            constexpr double kStepMm = 0.01;
            for (int k = 0; k < 3; ++k) {
                const Vector3d step = kStepMm * Vector3d::Unit(k);
                numeric.col(k) =
                    (*core::project(camera, point + step) - *core::project(camera, point - step)) / (2 * kStepMm);
            }
            EXPECT_LT((projection->pxByPointInWorld - numeric).norm(), 1e-6 * numeric.norm());
        }
    }
}

TEST(Camera, DistortionsJacobianIsThatOfFiniteDifferences) {
    test::RandomValues random("distortion jacobian");
    for (const Camera& camera : allLenses()) {
        for (int trial = 0; trial < 30; ++trial) {
            const Vector2d n = random.vector(2, trial ? 0.8 : 1e-3);
            Eigen::Matrix2d jacobian, numeric;
            core::distort(camera, n, &jacobian);
            constexpr double kStep = 1e-5;
            for (int k = 0; k < 2; ++k) {
                const Vector2d step = kStep * Vector2d::Unit(k);
                numeric.col(k) = (core::distort(camera, n + step) - core::distort(camera, n - step)) / (2 * kStep);
            }
            EXPECT_LT((jacobian - numeric).norm(), 1e-6 * numeric.norm());
        }
    }
}

TEST(Camera, UndistortsLikeOpenCv) {
    test::RandomValues random("undistort");
    const cv::TermCriteria exact(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 500, 1e-15);
    for (const Camera& camera : allLenses()) {
        const auto& m = camera.intrinsics;
        const cv::Matx33d k(m(0, 0), 0, m(0, 2), 0, m(1, 1), m(1, 2), 0, 0, 1);
        for (int trial = 0; trial < 50; ++trial) {
            // The middle of the image: OpenCV's iteration does not settle near the corners of a strong lens.
            const std::vector<cv::Point2d> px{{random.between(250, 1050), random.between(150, 800)}};
            std::vector<cv::Point2d> oracle;
            if (camera.fisheye)
                cv::fisheye::undistortPoints(px, oracle, k, camera.distortion);
            else
                cv::undistortPoints(px, oracle, k, camera.distortion, cv::noArray(), cv::noArray(), exact);
            const auto normalised = core::undistort(camera, {px[0].x, px[0].y});
            ASSERT_TRUE(normalised);
            EXPECT_LT((*normalised - Vector2d(oracle[0].x, oracle[0].y)).norm(), camera.fisheye ? 1e-7 : 1e-9)
                << camera.distortion.size() << camera.fisheye;
        }
    }
}

TEST(Camera, EveryPixelOfTheImageComesBackFromItsViewingRay) {
    for (const Camera& camera : allLenses()) {
        for (double y = -0.5; y <= camera.size.height; y += 32) {
            for (double x = -0.5; x <= camera.size.width; x += 32) {
                const auto ray = core::viewingRay(camera, {x, y});
                ASSERT_TRUE(ray) << x << " " << y;
                EXPECT_LT(ray->offset(camera.centreInWorld()).norm(), 1e-9);
                for (const double mm : {150.0, 900.0}) {
                    const auto px = core::project(camera, camera.centreInWorld() + mm * ray->direction);
                    ASSERT_TRUE(px) << "the ray points away from the camera";
                    EXPECT_LT((*px - Vector2d(x, y)).norm(), 1e-7);
                }
            }
        }
    }
}

TEST(Camera, AWideFisheyeSeesToTheSides) {
    const Camera camera = makeCamera({0.01, -0.002, 0.0, 0.0}, true);
    for (const double angleDeg : {5.0, 45.0, 70.0, 80.0, 85.0}) {
        const double angle = angleDeg * M_PI / 180;
        const Vector2d normalised = std::tan(angle) * Vector2d(0.6, -0.8);
        const Vector2d px = *core::project(camera, pointAt(camera, normalised, 100));
        const auto back = core::undistort(camera, px);
        ASSERT_TRUE(back) << angleDeg;
        EXPECT_NEAR(std::atan(back->norm()), angle, 1e-9);
        EXPECT_LT((*back - normalised).norm(), 1e-6 * normalised.norm());
    }
}

TEST(Camera, HasNoRayWhereTheLensModelCannotBeInverted) {
    // r (1 - 0.3 r^2) never exceeds 0.7027: nothing is seen at pixels beyond.
    const Camera barrel = makeCamera({-0.3, 0, 0, 0, 0});
    for (const double radius : {0.5, 0.65, 0.69, 0.705, 0.72, 0.8, 1.0, 1.5, 2.5, 4.0, 20.0}) {
        for (const double direction : {0.1, 1.3, 2.9, 4.4}) {
            const Vector2d target = radius * Vector2d(std::cos(direction), std::sin(direction));
            const Vector2d px(905 * target.x() + 651.3, 897 * target.y() + 470.8);
            const auto normalised = core::undistort(barrel, px);
            EXPECT_EQ(normalised.has_value(), radius < 0.7027) << radius;
            if (normalised) {
                EXPECT_LT(normalised->norm(), 1.0541) << "the branch that contains the middle of the image";
                EXPECT_GT(normalised->dot(target), 0);
            }
        }
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(core::undistort(barrel, {nan, 3}));
    EXPECT_FALSE(core::viewingRay(barrel, {nan, 3}));
}

/// The smallest radius at which the radial map of the camera's lens stops growing, by small steps.
double foldRadius(const Camera& camera) {
    constexpr double kStep = 1e-4;
    double before = 0;
    for (double r = kStep; r < 20; r += kStep) {
        const double now = core::distort(camera, {r, 0}).x();
        if (!(now > before))
            return r;
        before = now;
    }
    return 1e9;
}

TEST(Camera, ShowsNothingBeyondTheRadiusAtWhichTheLensFoldsBack) {
    test::RandomValues random("fold");
    std::vector<Camera> cameras{makeCamera({-0.96, 0, 0, 0, 0}),
                                makeCamera({-0.96, 1.1, 0, 0, -0.6}),
                                makeCamera({-0.5, -0.4, 0, 0}),
                                makeCamera({0.3, -0.9, 0, 0, 0.2}),
                                makeCamera({-0.9, 0.2, 0, 0, 0, 0.1, 0.05, 0.0}),
                                makeCamera({0.2, 0, 0, 0, 0, -0.6, 0.01, 0.02}),
                                makeCamera({-0.4, 0.05, 0, 0}, true),
                                makeCamera({0.05, -0.2, 0, 0.01}, true)};
    for (const Camera& camera : cameras) {
        const double fold = foldRadius(camera);
        for (int trial = 0; trial < 300; ++trial) {
            const double radius = random.between(0.01, 3), turn = random.between(0, 6.3);
            if (std::abs(radius - fold) < 1e-3)
                continue;
            const Vector3d point = pointAt(camera, radius * Vector2d(std::cos(turn), std::sin(turn)), 500);
            EXPECT_EQ(core::project(camera, point).has_value(), radius < fold) << radius << " of " << fold;
            EXPECT_EQ(core::projectWithJacobian(camera, point).has_value(), radius < fold) << radius << " of " << fold;
        }
    }
}

TEST(Camera, ShowsNothingWhereTangentialTermsTurnTheImageOver) {
    const Camera camera = makeCamera({-0.3, 0, 0.02, 0.01});
    for (double angle = 0; angle < 6.3; angle += 0.1) {
        bool isLost = false;
        for (double r = 0.01; r < 1.3; r += 0.005) {
            const Vector2d n = r * Vector2d(std::cos(angle), std::sin(angle));
            Eigen::Matrix2d jacobian;
            core::distort(camera, n, &jacobian);
            isLost = isLost || jacobian.determinant() < 0;
            if (isLost)
                EXPECT_FALSE(core::project(camera, pointAt(camera, n, 500))) << r << " at " << angle;
            else if (r < 0.9)
                EXPECT_TRUE(core::project(camera, pointAt(camera, n, 500))) << r << " at " << angle;
        }
    }
}

TEST(LensCoverage, IsThePartOfTheImageWithinTheFold) {
    EXPECT_EQ(core::lensCoverage(makeCamera({})), 1);
    for (const Camera& camera : allLenses())
        EXPECT_EQ(core::lensCoverage(camera), 1) << camera.distortion.size() << camera.fisheye;
    // r (1 - 0.96 r^2) grows up to r = 0.5893 and is 0.3928 there: a disc of 0.3928 fx by 0.3928 fy.
    Camera camera = makeCamera({-0.96, 0, 0, 0});
    camera.intrinsics << 1000, 0, 639.5, 0, 1000, 479.5, 0, 0, 1;
    EXPECT_NEAR(core::lensCoverage(camera), M_PI * 392.8 * 392.8 / (1280 * 960), 0.005);
}

TEST(Camera, IsInsideFromThePixelEdges) {
    const core::ImageSize size{640, 480};
    EXPECT_TRUE(core::isInside(size, {-0.5, -0.5}));
    EXPECT_TRUE(core::isInside(size, {639.49, 479.49}));
    EXPECT_FALSE(core::isInside(size, {639.5, 10}));
    EXPECT_FALSE(core::isInside(size, {10, 479.5}));
    EXPECT_FALSE(core::isInside(size, {-0.51, 10}));
    EXPECT_FALSE(core::isInside(size, {10, -0.51}));
    EXPECT_FALSE(core::isInside(size, {std::numeric_limits<double>::quiet_NaN(), 10}));
}

TEST(Camera, CroppedShiftsAndScalesPixelEdges) {
    test::RandomValues random("cropped");
    for (const Camera& camera : allLenses()) {
        for (const double scale : {1.0, 0.5, 0.25, 3.0}) {
            const Vector2d topLeft(random.between(-50, 300), random.between(-50, 300));
            const Camera window = core::cropped(camera, topLeft, {200, 100}, scale);
            EXPECT_EQ(window.size, (core::ImageSize{200, 100}));
            for (int trial = 0; trial < 10; ++trial) {
                const Vector3d point = pointAt(camera, random.vector(2, 0.5), random.between(300, 900));
                const Vector2d expected = ((*core::project(camera, point) - topLeft).array() + 0.5) * scale - 0.5;
                EXPECT_LT((*core::project(window, point) - expected).norm(), 1e-9);
            }
        }
    }
}

TEST(Camera, CroppedByHalfPutsTheCornerOfFourPixelsInTheMiddleOfOne) {
    Camera camera = makeCamera({});
    const Camera half = core::cropped(camera, {0, 0}, {640, 480}, 0.5);
    const auto ray = core::viewingRay(camera, {10.5, 20.5}); // where pixels 10, 11 and 20, 21 meet
    const auto px = core::project(half, camera.centreInWorld() + 500 * ray->direction);
    EXPECT_LT((*px - Vector2d(5, 10)).norm(), 1e-9);
}

TEST(Camera, HasALensOnlyIfItBends) {
    EXPECT_FALSE(makeCamera({}).hasLens());
    EXPECT_FALSE(makeCamera({0, 0, 0, 0, 0}).hasLens());
    EXPECT_TRUE(makeCamera({0, 0, 0, 1e-5, 0}).hasLens());
    EXPECT_TRUE(makeCamera({0, 0, 0, 0}, true).hasLens()) << "a fisheye without coefficients still is one";
}

TEST(Camera, CentreIsMappedToTheOrigin) {
    const Camera camera = makeCamera({});
    EXPECT_LT((camera.cameraFromWorld * camera.centreInWorld()).norm(), 1e-10);
}

} // namespace
