// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <benchmark/benchmark.h>
#include <ceres/ceres.h>

#include "core/fitting/ray_equations.h"
#include "core/numeric/box_step.h"
#include "tests/benchmarks/benchmark_scene.h"

namespace {

using test::benchmarkScene;

constexpr double kDamping = 1e-3;
constexpr int kPerCamera = 250; ///< correspondences of the hand, as many as a fit uses

/// One step's worth of work for the left hand: points of its surface in the start pose, and the rays on which they lie
/// five frames later.
struct Step {
    core::SkinnedSurface surface;
    std::vector<core::RayCorrespondence> correspondences;
};

const Step& step() {
    static const Step made = [] {
        const test::BenchmarkScene& scene = benchmarkScene();
        const core::HandModel& hand = scene.dataset.hands[0];
        Step result{core::makeSkinnedSurface(hand, 2000), {}};
        core::PosedPoints before;
        core::PosedPoints after;
        core::poseSurface(result.surface, core::boneMatrices(hand.skeleton, scene.start[0]), before);
        core::poseSurface(result.surface, core::boneMatrices(hand.skeleton, scene.poses[0]), after);
        const std::size_t count = result.surface.vertexCount();
        for (std::size_t c = 0; c < scene.dataset.cameras.size(); ++c) {
            const Eigen::Vector3d centre = scene.dataset.cameras[c].centreInWorld();
            for (std::size_t k = 0; k < kPerCamera; ++k) {
                const auto v = (k * count / kPerCamera + 3 * c) % count;
                core::RayCorrespondence correspondence;
                correspondence.vertexA = correspondence.vertexB = static_cast<int>(v);
                correspondence.point = before.positions[v].cast<double>();
                correspondence.rayPoint = centre;
                correspondence.rayDirection = (after.positions[v].cast<double>() - centre).normalized();
                correspondence.normal = before.normals[v].cast<double>().normalized();
                result.correspondences.push_back(correspondence);
            }
        }
        return result;
    }();
    return made;
}

/// Ours: normal equations and one damped step.
Eigen::VectorXd ourStep() {
    const test::BenchmarkScene& scene = benchmarkScene();
    const core::HandLinearisation linearisation(scene.dataset.hands[0], step().surface, scene.start[0]);
    core::NormalEquations equations;
    equations.reset(linearisation.poseSize());
    linearisation.accumulate(step().correspondences, equations);
    Eigen::MatrixXd hessian = equations.hessian;
    hessian.diagonal() *= 1 + kDamping;
    hessian.diagonal().array() += 1e-9;
    const Eigen::VectorXd none = Eigen::VectorXd::Constant(hessian.rows(), std::numeric_limits<double>::infinity());
    return core::boxConstrainedStep(hessian, equations.gradient, -none, none);
}

/// (v + J s) x d - m of one correspondence.
class RayResidual : public ceres::CostFunction {
public:
    RayResidual(const core::RayCorrespondence& correspondence, const Eigen::MatrixXd& jacobian) {
        const Eigen::Vector3d& d = correspondence.rayDirection;
        m_offset = (correspondence.point - correspondence.rayPoint).cross(d);
        m_jacobian.resize(3, jacobian.cols());
        for (Eigen::Index k = 0; k < jacobian.cols(); ++k)
            m_jacobian.col(k) = Eigen::Vector3d(jacobian.col(k)).cross(d);
        set_num_residuals(3);
        mutable_parameter_block_sizes()->push_back(static_cast<int>(jacobian.cols()));
    }
    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
        const Eigen::Map<const Eigen::VectorXd> s(parameters[0], m_jacobian.cols());
        Eigen::Map<Eigen::Vector3d> r(residuals);
        r = m_offset + m_jacobian * s;
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            Eigen::Map<Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>>(jacobians[0], 3, m_jacobian.cols()) =
                m_jacobian;
        }
        return true;
    }

private:
    Eigen::Vector3d m_offset;
    Eigen::Matrix<double, 3, Eigen::Dynamic> m_jacobian;
};

/// sqrt(weight_k) s_k: the damping.
class DampingResidual : public ceres::CostFunction {
public:
    explicit DampingResidual(Eigen::VectorXd weights)
        : m_roots(weights.cwiseSqrt()) {
        set_num_residuals(static_cast<int>(m_roots.size()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(m_roots.size()));
    }
    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
        for (Eigen::Index k = 0; k < m_roots.size(); ++k)
            residuals[k] = m_roots[k] * parameters[0][k];
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
                jacobians[0], m_roots.size(), m_roots.size()) = m_roots.asDiagonal();
        }
        return true;
    }

private:
    Eigen::VectorXd m_roots;
};

/// The same step by Ceres: the problem is linear, so one iteration without a trust region ends it.
Eigen::VectorXd ceresStep() {
    const test::BenchmarkScene& scene = benchmarkScene();
    const core::HandLinearisation linearisation(scene.dataset.hands[0], step().surface, scene.start[0]);
    Eigen::VectorXd s = Eigen::VectorXd::Zero(linearisation.poseSize());
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(s.size());
    ceres::Problem problem;
    for (const core::RayCorrespondence& correspondence : step().correspondences) {
        const Eigen::MatrixXd jacobian =
            linearisation.pointJacobian(correspondence.vertexA, correspondence.vertexB, correspondence.t);
        for (Eigen::Index k = 0; k < s.size(); ++k)
            diagonal[k] += Eigen::Vector3d(jacobian.col(k)).cross(correspondence.rayDirection).squaredNorm();
        problem.AddResidualBlock(new RayResidual(correspondence, jacobian), nullptr, s.data());
    }
    problem.AddResidualBlock(new DampingResidual(kDamping * diagonal + Eigen::VectorXd::Constant(s.size(), 1e-9)),
                             nullptr, s.data());
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
    options.max_num_iterations = 3;
    options.initial_trust_region_radius = 1e32;
    options.max_trust_region_radius = 1e32;
    options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 0;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return s;
}

void ourNormalEquations(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(ourStep());
    state.counters["correspondences"] = static_cast<double>(step().correspondences.size());
}
BENCHMARK(ourNormalEquations)->Unit(benchmark::kMillisecond);

void ceresOnTheSameResiduals(benchmark::State& state) {
    Eigen::VectorXd theirs;
    for (auto _ : state)
        theirs = ceresStep();
    const Eigen::VectorXd ours = ourStep();
    const double difference = (theirs - ours).norm() / ours.norm();
    if (!(difference < 1e-8))
        state.SkipWithError(("the steps differ by " + std::to_string(difference)).c_str());
    state.counters["relative_difference"] = difference;
}
BENCHMARK(ceresOnTheSameResiduals)->Unit(benchmark::kMillisecond);

} // namespace
