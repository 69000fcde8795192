// SPDX-License-Identifier: MIT
#include "core/fitting/ray_equations.h"

#include <memory>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <ceres/ceres.h>
#include <ceres/rotation.h>
#include <gtest/gtest.h>

#include "tests/support/spatial_twists.h"
#include "tests/support/two_finger_hand.h"

namespace {

using core::HandLinearisation;
using core::NormalEquations;
using core::Pose;
using core::RayCorrespondence;
using core::SkinnedSurface;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kPoseSize = 12;

/// A hand in some pose, a level of its surface and rays near its skin.
class RayEquations : public testing::Test {
protected:
    /// (1 - t) A + t B of the surface's own vertices and weights, by the product of exponentials.
    Vector3d chordPoint(const RayCorrespondence& c, const Pose& pose) const {
        const std::vector<core::RigidMotion> motions = test::spatialMotions(m_hand.skeleton, pose);
        const auto vertex = [&](int v) {
            const Vector3d rest = m_surface.restPositions[static_cast<std::size_t>(v)].cast<double>();
            Vector3d sum = Vector3d::Zero();
            for (int e = m_surface.firstWeight[v]; e < m_surface.firstWeight[v + 1]; ++e) {
                const auto entry = static_cast<std::size_t>(e);
                sum += static_cast<double>(m_surface.weightValue[entry]) *
                       (motions[static_cast<std::size_t>(m_surface.weightBone[entry])] * rest);
            }
            return sum;
        };
        return (1 - c.t) * vertex(c.vertexA) + c.t * vertex(c.vertexB);
    }

    std::vector<RayCorrespondence> randomCorrespondences(int count, bool weighted, double tangentWeight = 1) {
        std::vector<RayCorrespondence> list;
        for (int i = 0; i < count; ++i) {
            RayCorrespondence c;
            const auto& edge =
                m_surface.edges[static_cast<std::size_t>(m_random.below(static_cast<int>(m_surface.edges.size())))];
            c.vertexA = edge[0];
            c.vertexB = edge[1];
            c.t = m_random.between(0, 1);
            c.point = chordPoint(c, m_pose) + m_random.point(0.2); // as if lifted off the chord
            c.rayDirection = m_random.direction();
            c.rayPoint = c.point + m_random.point(4) - 700 * c.rayDirection;
            c.normal = m_random.direction();
            c.weight = weighted ? m_random.between(0.1, 2) : 1;
            c.tangentWeight = tangentWeight;
            list.push_back(c);
        }
        return list;
    }

    NormalEquations equationsOf(const std::vector<RayCorrespondence>& list) const {
        NormalEquations equations;
        equations.reset(kPoseSize);
        HandLinearisation(m_hand, m_surface, m_pose).accumulate(list, equations);
        return equations;
    }

    /// Half the weighted sum of squared distances when the hand has moved to `pose`; bulges move along with their
    /// chord.
    double cost(const std::vector<RayCorrespondence>& list, const Pose& pose) const {
        double sum = 0;
        for (const RayCorrespondence& c : list) {
            const Vector3d moved = c.point + chordPoint(c, pose) - chordPoint(c, m_pose);
            const Vector3d offset = moved - c.rayPoint;
            const Vector3d side = (c.normal - c.normal.dot(c.rayDirection) * c.rayDirection).normalized();
            const double across = side.dot(offset), along = c.rayDirection.cross(side).dot(offset);
            sum += 0.5 * c.weight * (across * across + c.tangentWeight * along * along);
        }
        return sum;
    }

    test::RandomValues m_random{"ray equations"};
    core::HandModel m_hand = test::twoFingerHand(core::Side::Left, core::exp({{30, -50, 100}, {0.3, 1.1, -0.6}}));
    SkinnedSurface m_surface = core::makeSkinnedSurface(m_hand, 700);
    Pose m_pose = test::somePose(m_hand.skeleton, m_random, 40, 1.2);
};

TEST_F(RayEquations, PointJacobianIsThatOfFiniteDifferences) {
    const HandLinearisation linearisation(m_hand, m_surface, m_pose);
    EXPECT_EQ(linearisation.poseSize(), kPoseSize);
    for (const RayCorrespondence& c : randomCorrespondences(60, false)) {
        const MatrixXd numeric =
            test::differencesByStep(m_pose, [&](const Pose& p) { return VectorXd(chordPoint(c, p)); });
        const MatrixXd jacobian = linearisation.pointJacobian(c.vertexA, c.vertexB, c.t);
        EXPECT_LT((jacobian - numeric).norm(), 1e-6 * numeric.norm());
    }
}

TEST_F(RayEquations, PointJacobianAgreesWithTheVertexJacobianOfTheModel) {
    m_surface = core::makeSkinnedSurface(m_hand, 0); // the same vertices as the mesh
    const HandLinearisation linearisation(m_hand, m_surface, m_pose);
    for (int trial = 0; trial < 30; ++trial) {
        const int v = m_random.below(static_cast<int>(m_hand.mesh.vertices.size()));
        const MatrixXd oracle = core::vertexJacobian(m_hand, m_pose, v);
        EXPECT_LT((linearisation.pointJacobian(v, v, 0.3) - oracle).norm(), 1e-3 * oracle.norm())
            << "small weights are left out";
    }
}

TEST_F(RayEquations, GradientIsThatOfFiniteDifferences) {
    for (const double tangentWeight : {1.0, 0.1, 0.0}) {
        const auto list = randomCorrespondences(150, true, tangentWeight);
        const MatrixXd numeric =
            test::differencesByStep(m_pose, [&](const Pose& p) { return VectorXd::Constant(1, cost(list, p)); });
        EXPECT_LT((equationsOf(list).gradient.transpose() - numeric).norm(), 1e-6 * numeric.norm()) << tangentWeight;
    }
}

TEST_F(RayEquations, HessianIsThatOfTheStackedJacobians) {
    const auto list = randomCorrespondences(700, true); // more than two blocks
    const NormalEquations equations = equationsOf(list);
    const HandLinearisation linearisation(m_hand, m_surface, m_pose);
    MatrixXd hessian = MatrixXd::Zero(kPoseSize, kPoseSize);
    VectorXd gradient = VectorXd::Zero(kPoseSize);
    double sum = 0;
    for (const RayCorrespondence& c : list) {
        // Three rows per correspondence: the derivative of v x d - m.
        const core::PlueckerLine ray = core::PlueckerLine::through(c.rayPoint, c.rayDirection);
        const MatrixXd rows =
            -core::crossMatrix(c.rayDirection) * linearisation.pointJacobian(c.vertexA, c.vertexB, c.t);
        hessian += c.weight * rows.transpose() * rows;
        gradient += c.weight * rows.transpose() * ray.offset(c.point);
        sum += c.weight * ray.offset(c.point).squaredNorm();
    }
    EXPECT_LT((equations.hessian - hessian).norm(), 1e-9 * hessian.norm());
    EXPECT_LT((equations.gradient - gradient).norm(), 1e-8 * gradient.norm());
    EXPECT_NEAR(equations.sumSquaredMm2, sum, 1e-8 * sum);
    EXPECT_EQ(equations.count, 700);
    EXPECT_TRUE(equations.hessian.isApprox(equations.hessian.transpose(), 1e-14)) << "both triangles are filled in";
}

TEST_F(RayEquations, DoNotDependOnHowTheyAreSplit) {
    const auto list = randomCorrespondences(500, true);
    const NormalEquations whole = equationsOf(list);
    const HandLinearisation linearisation(m_hand, m_surface, m_pose);
    NormalEquations sum, inTurns;
    sum.reset(kPoseSize);
    inTurns.reset(kPoseSize);
    for (std::size_t begin = 0; begin < list.size(); begin += 130) {
        const std::vector<RayCorrespondence> part(list.begin() + static_cast<std::ptrdiff_t>(begin),
                                                  list.begin() +
                                                      static_cast<std::ptrdiff_t>(std::min(begin + 130, list.size())));
        sum += equationsOf(part);
        linearisation.accumulate(part, inTurns);
    }
    for (const NormalEquations* parts : {&sum, &inTurns}) {
        EXPECT_TRUE(parts->hessian.isApprox(whole.hessian, 1e-12));
        EXPECT_TRUE(parts->gradient.isApprox(whole.gradient, 1e-10));
        EXPECT_NEAR(parts->sumSquaredMm2, whole.sumSquaredMm2, 1e-9 * whole.sumSquaredMm2);
        EXPECT_EQ(parts->count, whole.count);
    }
}

TEST_F(RayEquations, NormalsAlongTheRayKeepTheEquationsFinite) {
    auto list = randomCorrespondences(80, false);
    const NormalEquations expected = equationsOf(list);
    for (RayCorrespondence& c : list)
        c.normal = c.rayDirection;
    const NormalEquations equations = equationsOf(list);
    EXPECT_TRUE(equations.hessian.isApprox(expected.hessian, 1e-10)) << "the full distance has no preferred side";
    EXPECT_TRUE(equations.gradient.isApprox(expected.gradient, 1e-8));
}

TEST_F(RayEquations, NoMatchesGiveZeroEquations) {
    const NormalEquations equations = equationsOf({});
    EXPECT_EQ(equations.hessian, MatrixXd::Zero(kPoseSize, kPoseSize));
    EXPECT_EQ(equations.gradient, VectorXd::Zero(kPoseSize));
    EXPECT_EQ(equations.count, 0);
}

/// The residual v(s) x d - m with exact exponentials, for Ceres to differentiate at s = 0.
class RayResidual {
public:
    RayResidual(const core::HandModel& hand, const SkinnedSurface& surface, const Pose& pose,
                const RayCorrespondence& c, const Vector3d& chord)
        : m_hand(hand)
        , m_surface(surface)
        , m_pose(pose)
        , m_correspondence(c)
        , m_bulge(c.point - chord) {}

    template <typename T>
    bool operator()(const T* step, T* residual) const {
        using Vector = Eigen::Matrix<T, 3, 1>;
        const RayCorrespondence& c = m_correspondence;
        const Vector v = T(1 - c.t) * vertex(c.vertexA, step) + T(c.t) * vertex(c.vertexB, step) + m_bulge.cast<T>();
        const Vector offset = v - c.rayPoint.cast<T>();
        const Vector crossed = offset.cross(Vector(c.rayDirection.cast<T>()));
        for (int k = 0; k < 3; ++k)
            residual[k] = std::sqrt(c.weight) * crossed[k];
        return true;
    }

private:
    template <typename T>
    static Eigen::Matrix<T, 3, 1> rotated(const Eigen::Matrix<T, 3, 1>& vector, const Eigen::Matrix<T, 3, 1>& point) {
        Eigen::Matrix<T, 3, 1> result;
        ceres::AngleAxisRotatePoint(vector.data(), point.data(), result.data());
        return result;
    }

    template <typename T>
    Eigen::Matrix<T, 3, 1> vertex(int v, const T* step) const {
        Eigen::Matrix<T, 3, 1> sum = Eigen::Matrix<T, 3, 1>::Zero();
        for (int e = m_surface.firstWeight[v]; e < m_surface.firstWeight[v + 1]; ++e) {
            const auto entry = static_cast<std::size_t>(e);
            sum += T(static_cast<double>(m_surface.weightValue[entry])) *
                   carried(m_surface.weightBone[entry],
                           m_surface.restPositions[static_cast<std::size_t>(v)].cast<double>(), step);
        }
        return sum;
    }

    /// From the rest pose along the chain of exponentials, the innermost first.
    template <typename T>
    Eigen::Matrix<T, 3, 1> carried(int bone, const Vector3d& rest, const T* step) const {
        using Vector = Eigen::Matrix<T, 3, 1>;
        const core::Skeleton& skeleton = m_hand.skeleton;
        Vector p = rest.cast<T>();
        for (; bone >= 0; bone = skeleton.bones[static_cast<std::size_t>(bone)].parent) {
            const core::RigidMotion& worldFromBone = skeleton.bones[static_cast<std::size_t>(bone)].worldFromBoneAtRest;
            for (std::size_t d = skeleton.dofs.size(); d-- > 0;) {
                if (skeleton.dofs[d].bone == bone) {
                    const std::size_t k = core::kRigidDofs + d;
                    const Vector3d axis = worldFromBone.rotation * skeleton.dofs[d].axisInBone;
                    const Vector turn = axis.cast<T>() * (T(m_pose[static_cast<Eigen::Index>(k)]) + step[k]);
                    const Vector origin = worldFromBone.translation.cast<T>();
                    p = rotated<T>(turn, p - origin) + origin;
                }
            }
        }
        const Vector centre = skeleton.centreAtRest.cast<T>(), turn = m_pose.segment<3>(3).cast<T>();
        const Vector stepTurn(step[3], step[4], step[5]), stepShift(step[0], step[1], step[2]);
        return rotated<T>(stepTurn, rotated<T>(turn, p - centre)) + centre + m_pose.head<3>().cast<T>() + stepShift;
    }

    const core::HandModel& m_hand;
    const SkinnedSurface& m_surface;
    const Pose& m_pose;
    RayCorrespondence m_correspondence;
    Vector3d m_bulge;
};

/// r + J s, linear in the step.
class LinearResidual : public ceres::SizedCostFunction<3, kPoseSize> {
public:
    LinearResidual(const Eigen::Matrix<double, 3, kPoseSize>& jacobian, const Vector3d& residual)
        : m_jacobian(jacobian)
        , m_residual(residual) {}

    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
        const Eigen::Map<const Eigen::Matrix<double, kPoseSize, 1>> step(parameters[0]);
        Eigen::Map<Vector3d>(residuals, 3) = m_residual + m_jacobian * step;
        if (jacobians && jacobians[0])
            Eigen::Map<Eigen::Matrix<double, 3, kPoseSize, Eigen::RowMajor>>(jacobians[0], 3, kPoseSize) = m_jacobian;
        return true;
    }

private:
    Eigen::Matrix<double, 3, kPoseSize> m_jacobian;
    Vector3d m_residual;
};

TEST_F(RayEquations, AStepIsTheOneOfCeres) {
    const auto list = randomCorrespondences(400, true);
    VectorXd step = VectorXd::Zero(kPoseSize);
    ceres::Problem exact;
    for (const RayCorrespondence& c : list) {
        exact.AddResidualBlock(new ceres::AutoDiffCostFunction<RayResidual, 3, kPoseSize>(
                                   new RayResidual(m_hand, m_surface, m_pose, c, chordPoint(c, m_pose))),
                               nullptr, step.data());
    }
    std::vector<double> residuals;
    ceres::CRSMatrix sparse;
    ASSERT_TRUE(exact.Evaluate({}, nullptr, &residuals, nullptr, &sparse));
    ASSERT_EQ(sparse.values.size(), static_cast<std::size_t>(sparse.num_rows * kPoseSize));
    const Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> jacobian(
        sparse.values.data(), sparse.num_rows, kPoseSize);
    const Eigen::Map<VectorXd> residual(residuals.data(), sparse.num_rows);

    ceres::Problem linear;
    for (int row = 0; row < sparse.num_rows; row += 3) {
        linear.AddResidualBlock(new LinearResidual(jacobian.middleRows<3>(row), residual.segment<3>(row)), nullptr,
                                step.data());
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.initial_trust_region_radius = options.max_trust_region_radius = 1e32; // plain Gauss-Newton
    options.min_lm_diagonal = 1e-32;
    options.max_num_iterations = 3;
    options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 1e-30;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &linear, &summary);

    const NormalEquations equations = equationsOf(list);
    const VectorXd ours = -equations.hessian.ldlt().solve(equations.gradient);
    ASSERT_GT(step.norm(), 1e-2);
    EXPECT_LT((ours - step).norm(), 1e-8 * step.norm()) << ours.transpose() << " instead of " << step.transpose();
    const VectorXd dense = -MatrixXd(jacobian).colPivHouseholderQr().solve(residual);
    EXPECT_LT((ours - dense).norm(), 1e-8 * dense.norm());
}

} // namespace
