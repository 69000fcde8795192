// SPDX-License-Identifier: MIT
#include "tests/benchmarks/benchmark_scene.h"

#include <filesystem>

#include "core/contour/rasteriser.h"
#include "core/io/demo/demo_dataset.h"
#include "core/io/import/tzionas_import.h"

namespace test {

namespace {

constexpr int kFrame = 80;

struct Recording {
    core::Dataset dataset;
    core::Motion motion;
};

Recording recordedOrDemo() {
    const std::filesystem::path recorded = std::filesystem::path(HANDLENS_SHARED_DATA) / "tzionas-hands";
    if (std::filesystem::exists(recorded / "02")) {
        core::TzionasImportOptions options;
        options.sequenceFolders = {recorded / "02"};
        options.modelFiles = recorded / "model";
        const core::ImportedDataset imported = core::importTzionas(options);
        return {imported.dataset, imported.motions[0]};
    }
    const core::NewDataset demo = core::makeDemoDataset();
    return {demo.dataset, demo.motions[0]};
}

BenchmarkScene makeScene() {
    Recording recording = recordedOrDemo();
    BenchmarkScene scene{std::move(recording.dataset), std::move(recording.motion), {}, {}, {}, {}, {}};
    scene.start = scene.motion[kFrame - 5];
    scene.poses = scene.motion[kFrame];
    core::ContourOptions onGrid;
    onGrid.offsetPx = 0;
    for (const core::Camera& camera : scene.dataset.cameras) {
        scene.masks.push_back(core::renderHandsMask(camera, scene.dataset.hands, scene.poses));
        scene.contours.push_back(core::orientedContour(scene.masks.back(), onGrid));
    }
    const cv::Point margin(60, 60);
    const cv::Rect bounds = core::maskBounds(scene.masks[0]);
    scene.region = cv::Rect(bounds.tl() - margin, bounds.br() + margin) & cv::Rect({0, 0}, scene.masks[0].size());
    return scene;
}

} // namespace

const BenchmarkScene& benchmarkScene() {
    static const BenchmarkScene scene = makeScene();
    return scene;
}

} // namespace test
