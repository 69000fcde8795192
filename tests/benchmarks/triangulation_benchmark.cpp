// SPDX-License-Identifier: MIT
#include "core/geometry/triangulation.h"

#include <cmath>
#include <numbers>

#include <Eigen/SVD>
#include <benchmark/benchmark.h>

#include "core/numeric/random.h"
#include "tests/support/camera_ring.h"

namespace {

constexpr int kPoints = 200;

struct Clicked {
    Eigen::Vector3d truth;
    std::vector<core::Observation> observations;
};

double gaussian(core::RandomGenerator& random) {
    return std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * std::numbers::pi * random.uniform());
}

/// Points seen by 8 cameras with 1 px noise; the first `outliers` views of each are off by 25 to 80 px.
std::vector<Clicked> clickedPoints(const std::vector<core::Camera>& cameras, int outliers) {
    core::RandomGenerator random(7);
    std::vector<Clicked> points(kPoints);
    for (Clicked& point : points) {
        point.truth = {160 * random.uniform() - 80, 160 * random.uniform() - 80, 160 * random.uniform() - 80};
        const auto first = static_cast<int>(random.below(cameras.size()));
        for (int c = 0; c < static_cast<int>(cameras.size()); ++c) {
            const bool off =
                (c - first + static_cast<int>(cameras.size())) % static_cast<int>(cameras.size()) < outliers;
            const Eigen::Vector2d noise(gaussian(random), gaussian(random));
            const double angle = 2 * std::numbers::pi * random.uniform();
            const double distance = off ? 25 + 55 * random.uniform() : 0;
            const Eigen::Vector2d shift(distance * std::cos(angle), distance * std::sin(angle));
            point.observations.push_back(
                {c, *core::project(cameras[static_cast<std::size_t>(c)], point.truth) + noise + shift});
        }
    }
    return points;
}

/// The textbook's linear triangulation of all views: the null vector of stacked cross products, lens removed.
Eigen::Vector3d plainDlt(const std::vector<core::Camera>& cameras, const std::vector<core::Observation>& observations) {
    Eigen::MatrixXd rows(2 * observations.size(), 4);
    for (std::size_t i = 0; i < observations.size(); ++i) {
        const core::Camera& camera = cameras[static_cast<std::size_t>(observations[i].camera)];
        const Eigen::Vector2d normalised =
            core::undistort(camera, observations[i].px).value_or(Eigen::Vector2d::Zero());
        Eigen::Matrix<double, 3, 4> projection;
        projection << camera.cameraFromWorld.rotation, camera.cameraFromWorld.translation;
        const auto row = static_cast<Eigen::Index>(2 * i);
        rows.row(row) = normalised.x() * projection.row(2) - projection.row(0);
        rows.row(row + 1) = normalised.y() * projection.row(2) - projection.row(1);
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
    return svd.matrixV().col(3).hnormalized();
}

template <typename Triangulate>
void run(benchmark::State& state, const Triangulate& triangulateOne) {
    const std::vector<core::Camera> cameras = test::cameraRing(8);
    const std::vector<Clicked> points = clickedPoints(cameras, static_cast<int>(state.range(0)));
    double squared = 0;
    for (auto _ : state) {
        squared = 0;
        for (const Clicked& point : points)
            squared += (triangulateOne(cameras, point.observations) - point.truth).squaredNorm();
    }
    state.counters["rms_mm"] = std::sqrt(squared / kPoints);
    state.SetItemsProcessed(state.iterations() * kPoints);
}

void robustTriangulation(benchmark::State& state) {
    run(
        state,
        [](const auto& cameras, const auto& observations) {
            return core::triangulate(cameras, observations).point.value().pointInWorld;
        });
}
BENCHMARK(robustTriangulation)->ArgName("outliers")->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

void plainDltOfAllViews(benchmark::State& state) {
    run(state, plainDlt);
}
BENCHMARK(plainDltOfAllViews)->ArgName("outliers")->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

} // namespace
