// SPDX-License-Identifier: MIT
// Annotates ten frames of the demo through the real window, with clicks that scatter as a person's do, and compares the
// exported 3D joints with the true ones. Usage: handlens_annotation_trial [sigma-px] [views]
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <set>

#include <nlohmann/json.hpp>

#include "core/io/demo/demo_dataset.h"
#include "core/io/files/json_file.h"
#include "core/io/formats/joint_files.h"
#include "tests/support/temporary_folder.h"

namespace {

using nlohmann::json;

constexpr int kFrames = 10;

struct Trial {
    core::NewDataset demo = core::makeDemoDataset();
    std::vector<std::string> joints = core::readJointList("14");
    double sigmaPx = 1;
    int views = 3;
    std::mt19937_64 random{14};

    const core::Dataset& dataset() const { return demo.dataset; }
    int frame(int index) const { return 10 + index * (dataset().sequences[0].frameCount - 20) / kFrames; }
    Eigen::Vector3d truth(std::size_t hand, const std::string& joint, int atFrame) const {
        const core::Skeleton& skeleton = dataset().hands[hand].skeleton;
        const core::HandPoses& poses = demo.motions[0][static_cast<std::size_t>(atFrame)];
        return core::jointPositions(skeleton, poses[hand])[static_cast<std::size_t>(skeleton.boneIndex(joint))];
    }
};

/// Cameras that a person would choose: well apart on the ring, another first one for every joint.
std::vector<std::size_t> chosenViews(const Trial& trial, std::size_t joint) {
    const std::size_t all = trial.dataset().cameras.size();
    std::vector<std::size_t> views;
    for (int view = 0; view < trial.views; ++view)
        views.push_back((joint + static_cast<std::size_t>(view) * all / static_cast<std::size_t>(trial.views)) % all);
    return views;
}

/// The script: per joint its clicks, then Shift+Space for the other views. Returns how many clicks there are.
int writeScript(Trial& trial, const std::filesystem::path& file) {
    std::ofstream script(file);
    std::normal_distribution<double> noise(0, trial.sigmaPx);
    int clicks = 0;
    const auto say = [&](const json& step) { script << step.dump() << '\n'; };
    for (int index = 0; index < kFrames; ++index) {
        say({{"do", "goto"}, {"sequence", trial.dataset().sequences[0].name}, {"frame", trial.frame(index)}});
        for (std::size_t hand = 0; hand < 2; ++hand) {
            for (std::size_t joint = 0; joint < trial.joints.size(); ++joint) {
                say({{"do", "select"},
                     {"hand", core::sideName(trial.dataset().hands[hand].side)},
                     {"joint", trial.joints[joint]}});
                for (const std::size_t view : chosenViews(trial, joint)) {
                    const core::Camera& camera = trial.dataset().cameras[view];
                    const Eigen::Vector2d px =
                        *core::project(camera, trial.truth(hand, trial.joints[joint], trial.frame(index)));
                    say({{"do", "click"},
                         {"camera", camera.name},
                         {"px", {px.x() + noise(trial.random), px.y() + noise(trial.random)}}});
                    ++clicks;
                }
                say({{"do", "key"}, {"keys", "Shift+Space"}});
            }
        }
    }
    say({{"do", "timing"}});
    say({{"do", "export"}, {"to", "handlens"}, {"path", "gt.json"}});
    return clicks;
}

/// Distances of the exported joints from the true ones, mm.
std::vector<double> errorsMm(const Trial& trial, const json& groundTruth) {
    std::vector<double> errors;
    for (const json& frame : groundTruth["frames"]) {
        const json& hands = frame["raters"][0]["hands"];
        for (std::size_t hand = 0; hand < 2; ++hand) {
            for (const auto& [name, joint] :
                 hands[std::string(core::sideName(trial.dataset().hands[hand].side))]["joints"].items()) {
                const Eigen::Vector3d found(joint["xyz"][0], joint["xyz"][1], joint["xyz"][2]);
                errors.push_back((found - trial.truth(hand, name, frame["frame"])).norm());
            }
        }
    }
    return errors;
}

} // namespace

int main(int argc, char** argv) {
    Trial trial;
    trial.sigmaPx = argc > 1 ? std::atof(argv[1]) : 1;
    trial.views = argc > 2 ? std::atoi(argv[2]) : 3;
    const test::TemporaryFolder folder;
    core::writeDataset(trial.demo.dataset, trial.demo.motions, folder / "demo");
    const int clicks = writeScript(trial, folder / "script.jsonl");
    const std::string command = std::string(HANDLENS_PROGRAM) + " '" + (folder / "demo").string() +
                                "' --offscreen --script '" + (folder / "script.jsonl").string() + "' --out '" +
                                (folder / "out").string() + "' > '" + (folder / "answers").string() + "'";
    if (std::system(command.c_str()) != 0) {
        std::fprintf(stderr, "the window failed\n");
        return 1;
    }
    std::ifstream answers(folder / "answers");
    double stepsMs = 0;
    json timing;
    for (std::string line; std::getline(answers, line);) {
        const json answer = json::parse(line);
        stepsMs += answer["do"] == "timing" ? 0 : answer["ms"].get<double>();
        if (answer["do"] == "timing")
            timing = answer;
    }
    const std::vector<double> errors = errorsMm(trial, core::readJsonFile(folder / "out" / "gt.json"));
    double sum = 0, squares = 0, largest = 0;
    for (const double error : errors) {
        sum += error;
        squares += error * error;
        largest = std::max(largest, error);
    }
    const double count = static_cast<double>(errors.size());
    std::printf("%d frames, %zu joints, %d clicks (%.1f per joint), %d keys; clicks scatter by %g px\n", kFrames,
                errors.size(), clicks, clicks / count, static_cast<int>(errors.size()), trial.sigmaPx);
    std::printf("3D error: mean %.3f mm, RMS %.3f mm, largest %.3f mm\n", sum / count, std::sqrt(squares / count),
                largest);
    std::printf("the window's own time: %.2f s per frame of %d steps; events %.1f ms on average, %.1f ms at most\n",
                stepsMs / 1000 / kFrames, static_cast<int>(clicks / kFrames + 2 * errors.size() / kFrames),
                timing["meanMs"].get<double>(), timing["maxMs"].get<double>());
    return errors.size() == static_cast<std::size_t>(kFrames) * 28 ? 0 : 1;
}
