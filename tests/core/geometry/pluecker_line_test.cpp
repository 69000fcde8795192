// SPDX-License-Identifier: MIT
#include "core/geometry/pluecker_line.h"

#include <gtest/gtest.h>

#include "core/geometry/rigid_motion.h"
#include "tests/support/random_values.h"

namespace {

using core::PlueckerLine;
using Eigen::Vector3d;

TEST(PlueckerLine, DoesNotDependOnThePointOrTheLengthOfTheDirection) {
    test::RandomValues random("pluecker");
    for (int trial = 0; trial < 20; ++trial) {
        const Vector3d p = random.point(500), along = random.direction();
        const PlueckerLine line = PlueckerLine::through(p, along);
        const PlueckerLine same =
            PlueckerLine::through(p + random.between(-400, 400) * along, random.between(0.1, 9) * along);
        EXPECT_NEAR(line.direction.norm(), 1, 1e-14);
        EXPECT_LT((line.direction - same.direction).norm(), 1e-13);
        EXPECT_LT((line.moment - same.moment).norm(), 1e-10);
    }
}

TEST(PlueckerLine, NormOfTheOffsetIsTheDistance) {
    test::RandomValues random("offset");
    for (int trial = 0; trial < 50; ++trial) {
        const Vector3d p = random.point(500), along = random.direction(), point = random.point(500);
        const Vector3d foot = p + (point - p).dot(along) * along; // the nearest point by projection
        EXPECT_NEAR(PlueckerLine::through(p, along).offset(point).norm(), (point - foot).norm(), 1e-9);
    }
}

TEST(PlueckerLine, NearestPointToTheOriginLiesOnTheLineAndIsPerpendicular) {
    test::RandomValues random("nearest to origin");
    for (int trial = 0; trial < 20; ++trial) {
        const PlueckerLine line = PlueckerLine::through(random.point(500), random.direction());
        const Vector3d nearest = line.pointNearestOrigin();
        EXPECT_LT(line.offset(nearest).norm(), 1e-9);
        EXPECT_NEAR(nearest.dot(line.direction), 0, 1e-10);
    }
}

} // namespace
