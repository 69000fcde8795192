// SPDX-License-Identifier: MIT
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/frame_arguments.h"
#include "app/batch/verbs.h"
#include "core/contour/rasteriser.h"
#include "core/error.h"
#include "core/io/atomic_file.h"
#include "core/io/image_file.h"

namespace app {

namespace {

struct RenderArguments {
    FrameArguments where;
    std::string what = "mask";
    std::string out;
};

void render(const RenderArguments& arguments) {
    const core::Dataset dataset = core::readDataset(arguments.where.dataset);
    const core::Sequence& sequence = dataset.sequence(arguments.where.sequence);
    requireFrame(sequence, arguments.where.frame, "--frame");
    const core::Motion motion = requireMotion(dataset, sequence);
    core::ensureFolder(arguments.out);
    for (const core::Camera& camera : dataset.cameras) {
        const cv::Mat mask = core::renderHandsMask(camera, dataset.hands, motion[static_cast<std::size_t>(arguments.where.frame)]);
        core::writePng(std::filesystem::path(arguments.out) / (camera.name + ".png"), mask);
    }
}

} // namespace

void addRenderVerb(CLI::App& program) {
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App* verb = program.add_subcommand("render", "Write a picture of a frame for every camera");
    addFrameOptions(*verb, arguments->where);
    verb->add_option("--what", arguments->what, "mask: the hands' silhouette")->check(CLI::IsMember({"mask"}));
    verb->add_option("--out", arguments->out, "The folder for <camera>.png")->required();
    verb->callback([arguments] { render(*arguments); });
}

} // namespace app
