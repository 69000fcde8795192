// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <set>

#include <CLI/CLI.hpp>

#include "app/batch/option_text.h"
#include "app/batch/verbs.h"
#include "core/io/calibration.h"

namespace app {

namespace {

struct CalibrationArguments {
    std::string file, to, out, size;
    core::CalibrationOptions options;
    double scale = 0;
};

/// What a person needs to see to know that the file was understood.
void printCheck(const std::vector<core::Camera>& cameras) {
    const std::optional<Eigen::Vector3d> target = core::commonTarget(cameras);
    for (const core::Camera& camera : cameras) {
        std::printf("%s: %d x %d, focal length %.1f px", camera.name.c_str(), camera.size.width, camera.size.height, camera.intrinsics(0, 0));
        if (target) {
            const std::optional<Eigen::Vector2d> px = core::project(camera, *target);
            std::printf(", %.0f mm from where the cameras look%s", (camera.centreInWorld() - *target).norm(),
                        px && core::isInside(camera.size, *px) ? "" : " (which it does not see)");
        }
        std::printf("\n");
    }
}

void convert(CalibrationArguments arguments) {
    if (!arguments.size.empty()) {
        arguments.options.size = parseImageSize(arguments.size, "--size");
    }
    if (arguments.scale > 0) {
        arguments.options.mmPerUnit = arguments.scale;
    }
    const std::vector<core::Camera> cameras = core::readCalibration(arguments.file, arguments.options);
    core::writeCalibration(arguments.out, arguments.to, cameras);
    printCheck(cameras);
}

std::set<std::string> kindNames(bool toWrite) {
    std::set<std::string> names;
    for (const core::CalibrationKind& kind : core::calibrationKinds()) {
        if (kind.canWrite || !toWrite) {
            names.emplace(kind.name);
        }
    }
    return names;
}

} // namespace

void addCalibrationVerb(CLI::App& program) {
    auto arguments = std::make_shared<CalibrationArguments>();
    CLI::App* verb = program.add_subcommand("calibration", "Convert a calibration of another program");
    verb->add_option("file", arguments->file, "The file, or the folder for kinds with a file per camera")->required();
    verb->add_option("--from", arguments->options.kind, "Its kind, if the content does not tell")->check(CLI::IsMember(kindNames(false)));
    verb->add_option("--to", arguments->to, "The kind to write")->required()->check(CLI::IsMember(kindNames(true)));
    verb->add_option("--size", arguments->size, "Image size WxH, for files that hold none");
    verb->add_option("--mm-per-unit", arguments->scale, "Length of the file's unit in mm, if it is not the usual one")->check(CLI::PositiveNumber);
    verb->add_option("--section", arguments->options.section, "Which capture of an InterHand file");
    verb->add_option("--out", arguments->out, "The file to write")->required();
    verb->callback([arguments] { convert(*arguments); });
}

} // namespace app
