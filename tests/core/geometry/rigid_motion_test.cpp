// SPDX-License-Identifier: MIT
#include "core/geometry/rigid_motion.h"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <unsupported/Eigen/MatrixFunctions>

#include "tests/support/random_values.h"

namespace {

using core::RigidMotion;
using core::Twist;
using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using std::numbers::pi;

/// Angles at which formulas change or cancel, up to pi.
const double kAngles[] = {0,    1e-300, 1e-15, 1e-12, 1e-9,   1e-7,      9.99e-5,   1.001e-4,  1e-3,
                          0.01, 0.3,    1,     2,     pi / 2, pi - 1e-3, pi - 1e-6, pi - 1e-9, pi - 1e-12};

Matrix4d matrixOf(const RigidMotion& motion) {
    Matrix4d m = Matrix4d::Identity();
    m.topLeftCorner<3, 3>() = motion.rotation;
    m.topRightCorner<3, 1>() = motion.translation;
    return m;
}

TEST(RigidMotion, CrossMatrixIsTheCrossProduct) {
    test::RandomValues random("cross matrix");
    for (int trial = 0; trial < 20; ++trial) {
        const Vector3d v = random.point(100), w = random.point(100);
        EXPECT_TRUE((core::crossMatrix(v) * w).isApprox(v.cross(w), 1e-14));
    }
}

TEST(RigidMotion, RotationExpIsTheMatrixExponential) {
    test::RandomValues random("rotation exp");
    for (const double angle : kAngles) {
        for (int trial = 0; trial < 20; ++trial) {
            const Vector3d vector = angle * random.direction();
            const Matrix3d oracle = Matrix3d(core::crossMatrix(vector)).exp();
            EXPECT_LT((core::rotationExp(vector) - oracle).cwiseAbs().maxCoeff(), 1e-13) << angle;
        }
    }
}

TEST(RigidMotion, RotationExpKeepsSmallAnglesToFullPrecision) {
    const Matrix3d rotation = core::rotationExp({0, 0, 1e-9});
    EXPECT_DOUBLE_EQ(rotation(1, 0), 1e-9);
    EXPECT_DOUBLE_EQ(rotation(0, 1), -1e-9);
}

TEST(RigidMotion, RotationLogInvertsExp) {
    test::RandomValues random("rotation log");
    for (const double angle : kAngles) {
        for (int trial = 0; trial < 50; ++trial) {
            const Vector3d vector = angle * random.direction();
            const Vector3d back = core::rotationLog(core::rotationExp(vector));
            // Relative to the angle where it is small: a joint that barely turns keeps its axis.
            EXPECT_LE((back - vector).norm(), 1e-13 + 1e-9 * std::min(angle, 1e-3)) << angle;
        }
    }
}

TEST(RigidMotion, RotationLogOfHalfATurnIsOneOfTheTwoVectors) {
    test::RandomValues random("half turn");
    std::vector<Vector3d> axes{Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ(), Vector3d(1, 1, 0).normalized(),
                               Vector3d(0, -1, 1).normalized()};
    for (int trial = 0; trial < 50; ++trial)
        axes.push_back(random.direction());
    for (const Vector3d& axis : axes) {
        const Matrix3d rotation = 2 * axis * axis.transpose() - Matrix3d::Identity();
        const Vector3d vector = core::rotationLog(rotation);
        EXPECT_NEAR(vector.norm(), pi, 1e-12);
        EXPECT_NEAR(std::abs(vector.dot(axis)), pi, 1e-12);
    }
}

TEST(RigidMotion, RotationLogStaysInTheBallOfRadiusPi) {
    test::RandomValues random("beyond pi");
    for (int trial = 0; trial < 200; ++trial) {
        const Matrix3d rotation = core::rotationExp(random.between(pi, 3 * pi) * random.direction());
        const Vector3d vector = core::rotationLog(rotation);
        EXPECT_LE(vector.norm(), pi + 1e-12);
        EXPECT_TRUE(core::rotationExp(vector).isApprox(rotation, 1e-12));
    }
}

TEST(RigidMotion, TwistExpIsTheMatrixExponential) {
    test::RandomValues random("twist exp");
    for (const double angle : kAngles) {
        for (int trial = 0; trial < 20; ++trial) {
            const Twist twist{random.point(300), angle * random.direction()};
            Matrix4d generator = Matrix4d::Zero();
            generator.topLeftCorner<3, 3>() = core::crossMatrix(twist.angular);
            generator.topRightCorner<3, 1>() = twist.linear;
            const Matrix4d oracle = generator.exp();
            EXPECT_LT((matrixOf(core::exp(twist)) - oracle).cwiseAbs().maxCoeff(), 1e-10) << angle;
        }
    }
}

TEST(RigidMotion, TwistLogInvertsExp) {
    test::RandomValues random("twist log");
    for (const double angle : kAngles) {
        for (int trial = 0; trial < 20; ++trial) {
            const Twist twist{random.point(300), angle * random.direction()};
            const Twist back = core::log(core::exp(twist));
            EXPECT_LT((back.angular - twist.angular).norm(), 1e-11) << angle;
            EXPECT_LT((back.linear - twist.linear).norm(), 1e-9) << angle;
        }
    }
}

TEST(RigidMotion, AScrewAboutAnAxisTurnsAboutIt) {
    // Murray, Li, Sastry: the twist (-w x q, w) leaves q where it is.
    test::RandomValues random("screw");
    for (int trial = 0; trial < 20; ++trial) {
        const Vector3d axis = random.direction(), q = random.point(200);
        const double angle = random.between(-3, 3);
        const RigidMotion motion = core::exp({-angle * axis.cross(q), angle * axis});
        EXPECT_LT((motion * q - q).norm(), 1e-11);
        EXPECT_LT((motion * (q + 50 * axis) - (q + 50 * axis)).norm(), 1e-11);
    }
}

TEST(RigidMotion, CompositionAndInverseAreThoseOfMatrices) {
    test::RandomValues random("composition");
    for (int trial = 0; trial < 20; ++trial) {
        const RigidMotion bFromA = core::exp({random.point(300), random.point(3)});
        const RigidMotion cFromB = core::exp({random.point(300), random.point(3)});
        EXPECT_TRUE(matrixOf(cFromB * bFromA).isApprox(matrixOf(cFromB) * matrixOf(bFromA), 1e-13));
        EXPECT_TRUE(matrixOf(core::inverse(bFromA)).isApprox(matrixOf(bFromA).inverse(), 1e-12));
        const Vector3d point = random.point(500);
        EXPECT_TRUE(((cFromB * bFromA) * point).isApprox(cFromB * (bFromA * point), 1e-13));
    }
}

TEST(RigidMotion, KnowsWhatIsARotation) {
    test::RandomValues random("is rotation");
    const Matrix3d rotation = core::rotationExp(random.point(3));
    EXPECT_TRUE(core::isRotation(rotation));
    EXPECT_TRUE(core::isRotation(rotation * (1 + 4e-4)));
    EXPECT_FALSE(core::isRotation(rotation * (1 + 6e-4))) << "R^T R - I is twice as far from 0";
    EXPECT_TRUE(core::isRotation(rotation * 1.02, 0.05));
    EXPECT_FALSE(core::isRotation(Matrix3d(-rotation))) << "a reflection";
    EXPECT_FALSE(core::isRotation(Matrix3d::Zero()));
    Matrix3d broken = rotation;
    broken(1, 2) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(core::isRotation(broken));
    broken(1, 2) = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(core::isRotation(broken));
}

TEST(RigidMotion, FindsTheNearestRotationOfAMatrixOfFewDigits) {
    test::RandomValues random("nearest rotation");
    for (int i = 0; i < 50; ++i) {
        const Matrix3d rotation = core::rotationExp(random.point(3));
        const Matrix3d written = (rotation * 1e4).array().round() / 1e4; // as a file with four digits has it
        const auto nearest = core::nearestRotation(written, 1e-3);
        ASSERT_TRUE(nearest);
        EXPECT_TRUE(core::isRotation(*nearest, 1e-12));
        EXPECT_LE((*nearest - written).norm(), (rotation - written).norm() + 1e-12)
            << "none is nearer, not even the original";
    }
    EXPECT_FALSE(core::nearestRotation(Matrix3d::Identity() * 1.1, 1e-3));
    EXPECT_FALSE(core::nearestRotation(-Matrix3d::Identity(), 1e-3));
}

} // namespace
