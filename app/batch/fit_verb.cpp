// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/batch/frame_arguments.h"
#include "app/batch/interrupt.h"
#include "app/batch/verbs.h"
#include "core/contour/rasteriser.h"
#include "core/fitting/method_name.h"
#include "core/fitting/pose_estimator.h"
#include "core/io/files/json_file.h"

namespace app {

namespace {

using nlohmann::ordered_json;

struct FitArguments {
    std::string dataset, sequence, method = "dch-thres", out;
    int start = 0, test = 0, threads = 1;
    bool profile = false;
};

/// Seconds of the stages, over all threads; what no stage accounts for is known only when there is one thread.
void printProfile(const core::FitResult& result, int threads) {
    const core::FitProfile& profile = result.profile;
    const std::pair<const char*, double> stages[] = {{"contours", profile.contours}, {"transforms", profile.transforms},
                                                     {"skinning", profile.skinning}, {"rims", profile.rims},
                                                     {"matching", profile.matching}, {"solving", profile.solving},
                                                     {"scoring", profile.scoring}};
    double known = 0;
    for (const auto& [name, seconds] : stages)
        known += seconds;
    const double whole = threads == 1 ? result.seconds : known;
    const auto print = [whole](const char* name, double seconds) {
        std::printf("%-12s %8.1f ms  %3.0f %%\n", name, 1000 * seconds, 100 * seconds / whole);
    };
    for (const auto& [name, seconds] : stages)
        print(name, seconds);
    if (threads == 1)
        print("other", result.seconds - known);
    else
        print("all threads", known);
    std::printf("%-12s %8.1f ms\n", threads == 1 ? "all" : "elapsed", 1000 * result.seconds);
}

ordered_json historyToJson(const core::FitResult& result) {
    ordered_json history = ordered_json::array();
    for (const core::FitIteration& iteration : result.history) {
        history.push_back({{"iteration", iteration.iteration},
                           {"costMm2", iteration.costMm2},
                           {"matches", iteration.matches},
                           {"rejected", iteration.rejected},
                           {"stepMm", iteration.stepMm}});
    }
    return history;
}

/// sigmaMm: standard deviation of the joint's place, the root of the covariance's trace.
ordered_json jointsToJson(const core::Dataset& dataset, const core::FitResult& result, const core::HandPoses& truth) {
    ordered_json joints = ordered_json::array();
    for (std::size_t h = 0; h < dataset.hands.size(); ++h) {
        const core::Skeleton& skeleton = dataset.hands[h].skeleton;
        const auto estimated = core::jointPositions(skeleton, result.poses[h]);
        const auto recorded = core::jointPositions(skeleton, truth[h]);
        for (std::size_t b = 0; b < estimated.size(); ++b) {
            joints.push_back({{"hand", core::sideName(dataset.hands[h].side)},
                              {"name", skeleton.bones[b].name},
                              {"xyz", core::jsonOf(estimated[b])},
                              {"errorMm", (estimated[b] - recorded[b]).norm()}});
            if (result.confidence) {
                const Eigen::Matrix3d& covariance = result.confidence->jointCovarianceMm2[h][b];
                joints.back()["sigmaMm"] = std::sqrt(covariance.trace());
                joints.back()["covariance"] = core::jsonOf(covariance);
            }
        }
    }
    return joints;
}

void fit(const FitArguments& arguments) {
    const core::Method method = core::parseMethod(arguments.method);
    const core::Dataset dataset = core::readDataset(arguments.dataset);
    const core::Sequence& sequence = dataset.sequence(arguments.sequence);
    requireFrame(sequence, arguments.start, "--start");
    requireFrame(sequence, arguments.test, "--test");
    const core::Motion motion = requireMotion(dataset, sequence);
    const core::HandPoses& start = motion[static_cast<std::size_t>(arguments.start)];
    const core::HandPoses& truth = motion[static_cast<std::size_t>(arguments.test)];
    std::vector<cv::Mat> masks;
    for (const core::Camera& camera : dataset.cameras)
        masks.push_back(core::renderHandsMask(camera, dataset.hands, truth));
    const core::PoseEstimator estimator(dataset.hands, dataset.cameras);
    const core::FitResult result =
        estimator.fit(masks, start, method, interruptToken(), {}, arguments.threads, {.confidence = true});
    if (result.termination == core::FitTermination::Stopped)
        throw Interrupted(arguments.out + ": stopped; nothing was written");
    const double initialErrorMm = core::meanJointDistanceMm(dataset.hands, start, truth);
    const double errorMm = core::meanJointDistanceMm(dataset.hands, result.poses, truth);
    ordered_json file{{"method", core::methodName(method)},
                      {"sequence", sequence.name},
                      {"start", arguments.start},
                      {"test", arguments.test},
                      {"initialErrorMm", initialErrorMm},
                      {"errorMm", errorMm},
                      {"iterations", result.history.size()},
                      {"termination", core::terminationName(result.termination)},
                      {"seconds", result.seconds}};
    if (result.confidence) {
        file["doubt"] = result.confidence->doubt;
        file["contourSigmaPx"] = result.confidence->sigmaPx;
        file["overlap"] = result.confidence->overlap;
        file["systematicMm"] = result.confidence->systematic.jointMm;
    }
    file["joints"] = jointsToJson(dataset, result, truth);
    file["history"] = historyToJson(result);
    core::writeJsonFile(arguments.out, file);
    std::printf("%.3f mm from %.3f mm in %zu iterations, %.3f s (%s)\n", errorMm, initialErrorMm, result.history.size(),
                result.seconds, std::string(core::terminationName(result.termination)).c_str());
    if (result.confidence)
        std::printf("doubt %.2f: %s\n", result.confidence->doubt,
                    result.confidence->doubt < core::kTrustedDoubt ? "the silhouettes agree with the pose"
                                                                   : "the pose may be wrong");
    if (arguments.profile)
        printProfile(result, arguments.threads);
}

/// "a, b or c".
std::string methodsText() {
    const std::vector<std::string> names = core::plainMethodNames();
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
    return text;
}

} // namespace

void addFitVerb(CLI::App& program) {
    auto arguments = std::make_shared<FitArguments>();
    CLI::App* verb = program.add_subcommand(
        "fit", "Estimate the pose of a test frame from a start frame, and compare it with the recorded one");
    verb->add_option("dataset", arguments->dataset, "The dataset folder")->required();
    verb->add_option("--sequence", arguments->sequence, "Name of the sequence")->required();
    verb->add_option("--start", arguments->start, "Frame whose recorded pose the fit starts from")->required();
    verb->add_option("--test", arguments->test, "Frame whose silhouettes are fitted")->required();
    verb->add_option("--method", arguments->method, methodsText() + ", with options as in dch-thres:tau=45")
        ->required();
    verb->add_option("--threads", arguments->threads, "Threads of the one fit (1)")->check(CLI::Range(1, 256));
    verb->add_flag("--profile", arguments->profile, "Print where the time went");
    verb->add_option("--out", arguments->out, "The JSON file to write")->required();
    verb->callback([arguments] { fit(*arguments); });
}

} // namespace app
