// SPDX-License-Identifier: MIT
#include <functional>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/frame_arguments.h"
#include "app/batch/verbs.h"
#include "core/contour/rasteriser.h"
#include "core/contour/shaded_image.h"
#include "core/error.h"
#include "core/io/dataset/frames.h"
#include "core/io/files/atomic_file.h"
#include "core/io/footage/image_file.h"

namespace app {

namespace {

struct RenderArguments {
    FrameArguments where;
    std::string what = "mask";
    std::string out;
};

void renderFrame(const RenderArguments& arguments) {
    const core::Dataset dataset = core::readDataset(arguments.where.dataset);
    const core::Sequence& sequence = dataset.sequence(arguments.where.sequence);
    requireFrame(sequence, arguments.where.frame, "--frame");
    const auto frame = arguments.where.frame;
    std::function<cv::Mat(int)> draw;
    if (arguments.what == "image") {
        auto frames = std::make_shared<core::FrameSource>(dataset, sequence, core::readMotion(dataset, sequence));
        draw = [frames, frame](int camera) { return frames->read(camera, frame); };
    } else {
        const core::HandPoses poses = requireMotion(dataset, sequence)[static_cast<std::size_t>(frame)];
        const auto render = arguments.what == "mask" ? core::renderHandsMask : core::renderHandsShaded;
        draw = [&dataset, poses, render](int camera) {
            return render(dataset.cameras[static_cast<std::size_t>(camera)], dataset.hands, poses);
        };
    }
    core::ensureFolder(arguments.out);
    for (std::size_t c = 0; c < dataset.cameras.size(); ++c) {
        const cv::Mat picture = draw(static_cast<int>(c));
        core::writePng(std::filesystem::path(arguments.out) / (dataset.cameras[c].name + ".png"), picture);
    }
}

} // namespace

void addRenderVerb(CLI::App& program) {
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App* verb = program.add_subcommand("render", "Write a picture of a frame for every camera");
    addFrameOptions(*verb, arguments->where);
    verb->add_option("--what", arguments->what,
                     "mask: the hands' silhouette; shaded: the hands; image: the recorded picture")
        ->check(CLI::IsMember({"mask", "shaded", "image"}));
    verb->add_option("--out", arguments->out, "The folder for <camera>.png")->required();
    verb->callback([arguments] { renderFrame(*arguments); });
}

} // namespace app
