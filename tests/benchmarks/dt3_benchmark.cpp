// SPDX-License-Identifier: MIT
#include "core/distance/dt3_tensor.h"

#include <cmath>

#include <benchmark/benchmark.h>

#include "core/distance/contour_index.h"
#include "core/distance/direct_matching.h"
#include "tests/benchmarks/benchmark_scene.h"

namespace {

using test::benchmarkScene;

constexpr double kLambda = 25;
const core::OrientationBins kBins(16, true);

/// About 300 rim points of the start pose in the first camera, at whole pixels: what one iteration looks up.
const core::OrientedContour& queries() {
    static const core::OrientedContour found = [] {
        const core::OrientedContour& contour = benchmarkScene().contours[0];
        core::OrientedContour thinned;
        for (std::size_t i = 0; i < contour.size(); i += contour.size() / 300 + 1) {
            thinned.x.push_back(contour.x[i] + 9); // as far as hands move in some frames
            thinned.y.push_back(contour.y[i] - 5);
            thinned.angleRad.push_back(contour.angleRad[i] + 0.2F);
        }
        return thinned;
    }();
    return found;
}

void tensorSetUp(benchmark::State& state) {
    const test::BenchmarkScene& scene = benchmarkScene();
    for (auto _ : state)
        benchmark::DoNotOptimize(core::computeDt3Tensor(scene.contours[0], kBins, kLambda, scene.region));
    state.counters["MB"] = 2e-6 * kBins.count() * scene.region.area();
}
BENCHMARK(tensorSetUp)->Unit(benchmark::kMillisecond);

void tensorLookUp(benchmark::State& state) {
    const test::BenchmarkScene& scene = benchmarkScene();
    const core::Dt3Tensor tensor = core::computeDt3Tensor(scene.contours[0], kBins, kLambda, scene.region);
    double worst = 0;
    for (auto _ : state) {
        for (std::size_t i = 0; i < queries().size(); ++i) {
            const Eigen::Vector2d px(queries().x[i], queries().y[i]);
            benchmark::DoNotOptimize(core::nearestFromTensor(tensor, scene.contours[0], px, queries().angleRad[i]));
        }
    }
    for (std::size_t i = 0; i < queries().size(); ++i) {
        const Eigen::Vector2d px(queries().x[i], queries().y[i]);
        const double angle = queries().angleRad[i];
        const auto exact = core::nearestQuantisedPoint(scene.contours[0], kBins, px, kBins.binOf(angle), kLambda);
        const auto found = core::nearestFromTensor(tensor, scene.contours[0], px, angle);
        worst = std::max(worst, std::abs(found->distancePx - exact->distancePx));
    }
    if (worst > 1e-3)
        state.SkipWithError("tensor and direct search differ");
    state.counters["points"] = static_cast<double>(queries().size());
}
BENCHMARK(tensorLookUp)->Unit(benchmark::kMillisecond);

void directOverAllPoints(benchmark::State& state) {
    const test::BenchmarkScene& scene = benchmarkScene();
    for (auto _ : state) {
        for (std::size_t i = 0; i < queries().size(); ++i) {
            const Eigen::Vector2d px(queries().x[i], queries().y[i]);
            const int bin = kBins.binOf(queries().angleRad[i]);
            benchmark::DoNotOptimize(core::nearestQuantisedPoint(scene.contours[0], kBins, px, bin, kLambda));
        }
    }
}
BENCHMARK(directOverAllPoints)->Unit(benchmark::kMillisecond);

void directOverACellGrid(benchmark::State& state) {
    const test::BenchmarkScene& scene = benchmarkScene();
    const core::ContourIndex index(scene.contours[0], kBins);
    const float noGate = std::numeric_limits<float>::infinity();
    double worst = 0;
    for (auto _ : state) {
        for (std::size_t i = 0; i < queries().size(); ++i) {
            const int bin = kBins.binOf(queries().angleRad[i]);
            benchmark::DoNotOptimize(index.nearestDirectional(queries().x[i], queries().y[i], bin, kLambda, noGate));
        }
    }
    for (std::size_t i = 0; i < queries().size(); ++i) {
        const Eigen::Vector2d px(queries().x[i], queries().y[i]);
        const int bin = kBins.binOf(queries().angleRad[i]);
        const auto exact = core::nearestQuantisedPoint(scene.contours[0], kBins, px, bin, kLambda);
        const auto found = index.nearestDirectional(queries().x[i], queries().y[i], bin, kLambda, noGate);
        worst = std::max(worst, std::abs(static_cast<double>(found.distance) - exact->distancePx));
    }
    if (worst > 1e-2)
        state.SkipWithError("cell grid and direct search differ");
}
BENCHMARK(directOverACellGrid)->Unit(benchmark::kMillisecond);

void cellGridSetUp(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(core::ContourIndex(benchmarkScene().contours[0], kBins));
}
BENCHMARK(cellGridSetUp)->Unit(benchmark::kMillisecond);

} // namespace
