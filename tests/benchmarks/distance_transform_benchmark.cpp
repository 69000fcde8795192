// SPDX-License-Identifier: MIT
#include "core/distance/distance_transform.h"

#include <cmath>
#include <string>

#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>

#include "tests/benchmarks/benchmark_scene.h"

namespace {

using test::benchmarkScene;

/// OpenCV's input: 0 at the contour, 255 elsewhere, the region alone.
cv::Mat contourPicture() {
    const test::BenchmarkScene& scene = benchmarkScene();
    cv::Mat picture(scene.region.size(), CV_8U, cv::Scalar(255));
    const core::OrientedContour& contour = scene.contours[0];
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const cv::Point pixel(static_cast<int>(std::lround(contour.x[i])), static_cast<int>(std::lround(contour.y[i])));
        picture.at<uchar>(pixel - scene.region.tl()) = 0;
    }
    return picture;
}

void exactTransformWithArgmin(benchmark::State& state) {
    const test::BenchmarkScene& scene = benchmarkScene();
    for (auto _ : state)
        benchmark::DoNotOptimize(core::computeDistanceTransform(scene.contours[0], scene.region));
    state.SetLabel(std::to_string(scene.region.width) + " x " + std::to_string(scene.region.height) + " px, " +
                   std::to_string(scene.contours[0].size()) + " points");
}
BENCHMARK(exactTransformWithArgmin)->Unit(benchmark::kMillisecond);

/// cv::distanceTransform without labels is exact (DIST_MASK_PRECISE), but knows no nearest point.
void opencvPreciseWithoutLabels(benchmark::State& state) {
    const cv::Mat picture = contourPicture();
    cv::Mat distance;
    for (auto _ : state) {
        cv::distanceTransform(picture, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
        benchmark::DoNotOptimize(distance.data);
    }
    const core::DistanceTransform ours =
        core::computeDistanceTransform(benchmarkScene().contours[0], benchmarkScene().region);
    double worst = 0;
    for (int i = 0; i < distance.rows * distance.cols; ++i) {
        worst = std::max(worst, std::abs(static_cast<double>(distance.at<float>(i / distance.cols, i % distance.cols)) -
                                         static_cast<double>(ours.distancePx[static_cast<std::size_t>(i)])));
    }
    if (worst > 1e-3)
        state.SkipWithError("the exact transforms differ");
    state.counters["worst_px"] = worst;
}
BENCHMARK(opencvPreciseWithoutLabels)->Unit(benchmark::kMillisecond);

/// With labels OpenCV falls back to a 5x5 mask: how often the labelled point is not the nearest one.
void opencvWithLabels(benchmark::State& state) {
    const cv::Mat picture = contourPicture();
    cv::Mat distance;
    cv::Mat labels;
    for (auto _ : state) {
        cv::distanceTransform(picture, distance, labels, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
        benchmark::DoNotOptimize(labels.data);
    }
    std::vector<cv::Point> pixelOf(1);
    for (int y = 0; y < picture.rows; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
            const auto label = static_cast<std::size_t>(labels.at<int>(y, x));
            if (picture.at<uchar>(y, x) == 0) {
                pixelOf.resize(std::max(pixelOf.size(), label + 1));
                pixelOf[label] = {x, y};
            }
        }
    }
    const core::DistanceTransform ours =
        core::computeDistanceTransform(benchmarkScene().contours[0], benchmarkScene().region);
    int wrong = 0;
    double worst = 0;
    for (int y = 0; y < picture.rows; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
            const cv::Point q = pixelOf[static_cast<std::size_t>(labels.at<int>(y, x))];
            const auto exact = static_cast<double>(ours.distancePx[static_cast<std::size_t>(y * picture.cols + x)]);
            const double excess = std::hypot(q.x - x, q.y - y) - exact;
            wrong += excess > 1e-3 ? 1 : 0;
            worst = std::max(worst, excess);
        }
    }
    state.counters["wrong_%"] = 100.0 * wrong / (picture.rows * picture.cols);
    state.counters["worst_px"] = worst;
}
BENCHMARK(opencvWithLabels)->Unit(benchmark::kMillisecond);

} // namespace
