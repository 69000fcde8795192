// SPDX-License-Identifier: MIT
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/verbs.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/formats/points_file.h"

namespace app {

namespace {

struct TriangulateArguments {
    std::string cameras;
    std::string points;
    std::string out;
    double sigmaPx = 1;
};

void triangulatePoints(const TriangulateArguments& arguments) {
    const auto cameras = core::readCameras(arguments.cameras);
    const auto points = core::readPointClicks(arguments.points, cameras);
    core::TriangulationOptions options;
    options.sigmaPx = arguments.sigmaPx;
    std::vector<core::TriangulationResult> results;
    results.reserve(points.size());
    for (const core::PointClicks& point : points)
        results.push_back(core::triangulate(cameras, point.observations, options));
    core::writeTriangulatedPoints(arguments.out, cameras, points, results);
}

} // namespace

void addTriangulateVerb(CLI::App& program) {
    auto arguments = std::make_shared<TriangulateArguments>();
    CLI::App* verb = program.add_subcommand(
        "triangulate", "Find 3D points, with covariances and outliers, from pixels in several cameras");
    verb->add_option("--cameras", arguments->cameras, "Cameras file (handlens-cameras)")->required();
    verb->add_option("--points", arguments->points, "JSON file with the pixels of every point")->required();
    verb->add_option("--sigma-px", arguments->sigmaPx, "Standard deviation of a click per axis, px")
        ->capture_default_str()
        ->check(CLI::Range(1e-6, 1e6));
    verb->add_option("--out", arguments->out, "The JSON file to write")->required();
    verb->callback([arguments] { triangulatePoints(*arguments); });
}

} // namespace app
