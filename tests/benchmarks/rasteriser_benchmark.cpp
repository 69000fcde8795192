// SPDX-License-Identifier: MIT
#include "core/contour/rasteriser.h"

#include <cmath>

#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>

#include "tests/benchmarks/benchmark_scene.h"

namespace {

using test::benchmarkScene;

/// The scene's hands, posed once.
const std::vector<core::PosedSurface>& posedHands() {
    static const std::vector<std::vector<Eigen::Vector3d>> vertices = [] {
        std::vector<std::vector<Eigen::Vector3d>> posed;
        for (std::size_t h = 0; h < benchmarkScene().dataset.hands.size(); ++h)
            posed.push_back(core::posedVertices(benchmarkScene().dataset.hands[h], benchmarkScene().poses[h]));
        return posed;
    }();
    static const std::vector<core::PosedSurface> surfaces = [] {
        std::vector<core::PosedSurface> made;
        for (std::size_t h = 0; h < vertices.size(); ++h) {
            made.push_back({&vertices[h], &benchmarkScene().dataset.hands[h].mesh.triangles});
        }
        return made;
    }();
    return surfaces;
}

/// Every triangle with cv::fillConvexPoly, with 4 binary digits of sub-pixel precision.
cv::Mat filledByOpenCv(const core::Camera& camera) {
    constexpr int kShift = 4;
    cv::Mat mask(camera.size.height, camera.size.width, CV_8U, cv::Scalar(0));
    for (const core::PosedSurface& surface : posedHands()) {
        std::vector<cv::Point> px;
        for (const Eigen::Vector3d& vertex : *surface.verticesInWorld) {
            const Eigen::Vector2d p = core::project(camera, vertex).value_or(Eigen::Vector2d::Zero());
            px.emplace_back(static_cast<int>(std::lround(p.x() * (1 << kShift))),
                            static_cast<int>(std::lround(p.y() * (1 << kShift))));
        }
        for (const auto& t : *surface.triangles) {
            const cv::Point corners[3] = {px[static_cast<std::size_t>(t[0])], px[static_cast<std::size_t>(t[1])],
                                          px[static_cast<std::size_t>(t[2])]};
            cv::fillConvexPoly(mask, corners, 3, cv::Scalar(255), cv::LINE_8, kShift);
        }
    }
    return mask;
}

void pixelCentreRasteriser(benchmark::State& state) {
    const core::Camera& camera = benchmarkScene().dataset.cameras[0];
    for (auto _ : state)
        benchmark::DoNotOptimize(core::renderMask(camera, posedHands()).data);
}
BENCHMARK(pixelCentreRasteriser)->Unit(benchmark::kMillisecond);

/// How much fatter OpenCV's silhouette is: additional area over the length of the outline, in pixels.
void opencvFillConvexPoly(benchmark::State& state) {
    const core::Camera& camera = benchmarkScene().dataset.cameras[0];
    cv::Mat mask;
    for (auto _ : state) {
        mask = filledByOpenCv(camera);
        benchmark::DoNotOptimize(mask.data);
    }
    const cv::Mat ours = core::renderMask(camera, posedHands());
    const int more = cv::countNonZero(mask) - cv::countNonZero(ours);
    if (cv::countNonZero((mask == 0) & (ours != 0)) > cv::countNonZero(ours) / 1000)
        state.SkipWithError("the silhouettes differ");
    state.counters["fatter_px"] = static_cast<double>(more) / static_cast<double>(benchmarkScene().contours[0].size());
}
BENCHMARK(opencvFillConvexPoly)->Unit(benchmark::kMillisecond);

} // namespace
