// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/batch/interrupt.h"
#include "app/batch/verbs.h"
#include "core/annotation/reconstruction.h"
#include "core/error.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/dataset/dataset.h"
#include "core/io/dataset/dataset_rig.h"
#include "core/io/files/json_file.h"
#include "core/rig/refinement_advice.h"
#include "core/rig/rig_findings.h"
#include "core/rig/rig_refinement.h"

namespace app {

namespace {

using nlohmann::ordered_json;

struct RigArguments {
    std::string dataset, rater, json, out;
    std::vector<std::string> sequences;
    bool refine = false;
};

ordered_json cameraJson(const core::CameraHealth& camera) {
    ordered_json item{{"name", camera.camera}, {"clicks", camera.clicks},
                      {"rmsPx", camera.rmsPx}, {"meanPx", {camera.meanPx.x(), camera.meanPx.y()}},
                      {"off", camera.isOff},   {"known", camera.isKnown}};
    if (!camera.isKnown)
        return item;
    item["meanSigmaPx"] = camera.meanSigmaPx;
    item["leaveOneOutPx"] = camera.leaveOneOutPx;
    item["scatterPx"] = camera.scatterPx;
    item["spreadPx"] = camera.spreadPx;
    const Eigen::Matrix2d& v = camera.variationPx;
    item["variationPx"] = {{v(0, 0), v(0, 1)}, {v(1, 0), v(1, 1)}};
    item["wrongClicks"] = camera.wrongClicks;
    if (camera.driftPx) {
        item["driftPxPer100Frames"] = {camera.driftPx->x(), camera.driftPx->y()};
        item["driftSigmaPx"] = camera.driftSigmaPx;
    }
    if (camera.delayFrames) {
        item["delayFrames"] = *camera.delayFrames;
        item["delaySigmaFrames"] = camera.delaySigmaFrames;
    }
    return item;
}

ordered_json refinementJson(const core::RigRefinement& refinement, const std::optional<double>& worldSigmaMm) {
    ordered_json cameras = ordered_json::array();
    for (const core::CameraRefinement& change : refinement.changes) {
        ordered_json item{{"name", change.camera},           {"turnDeg", change.turnDeg}, {"shiftMm", change.shiftMm},
                          {"focalShare", change.focalShare}, {"beforeRmsPx", nullptr},    {"afterRmsPx", nullptr}};
        if (std::isfinite(change.beforeRmsPx))
            item["beforeRmsPx"] = change.beforeRmsPx;
        if (std::isfinite(change.afterRmsPx))
            item["afterRmsPx"] = change.afterRmsPx;
        cameras.push_back(item);
    }
    ordered_json item{{"sigmaPx", refinement.sigmaPx},     {"joints", refinement.joints},
                      {"frames", refinement.frames},       {"wrongClicks", refinement.wrongClicks},
                      {"converged", refinement.converged}, {"cameras", cameras}};
    if (worldSigmaMm)
        item["worldSigmaMm"] = *worldSigmaMm;
    return item;
}

/// What the verb found; the names of the sequences are for the sentences.
struct RigVerdict {
    std::vector<std::string> sequences;
    core::RigHealth health;
    core::ClickSigmas sigmas;
    std::optional<core::RigRefinement> refinement;
    std::optional<double> worldSigmaMm; ///< of the refined world as a whole
};

ordered_json raterJson(const core::RigHealth& health, const std::string& rater, const core::RaterSigma& sigma) {
    ordered_json item{{"name", rater},
                      {"sigmaPx", sigma.clickPx},
                      {"assumed", sigma.isAssumed},
                      {"clicks", sigma.clicks},
                      {"wrongClicks", sigma.wrongClicks}};
    for (std::size_t c = 0; c < sigma.clickPxByCamera.size(); ++c)
        item["sigmaPxByCamera"][health.cameras[c].camera] = sigma.clickPxByCamera[c];
    return item;
}

ordered_json sequenceJson(const core::SequenceHealth& sequence, const std::vector<std::string>& names) {
    ordered_json item{{"sequence", names.at(static_cast<std::size_t>(sequence.sequence))},
                      {"clicks", sequence.clicks},
                      {"meanPx", {sequence.meanPx.x(), sequence.meanPx.y()}},
                      {"meanSigmaPx", sequence.meanSigmaPx},
                      {"off", sequence.isOff},
                      {"drifting", sequence.isDrifting}};
    if (sequence.driftPx)
        item["driftPxPer100Frames"] = {sequence.driftPx->x(), sequence.driftPx->y()};
    if (const auto& step = sequence.step) {
        item["movedAtFrame"] = step->frame;
        item["beforePx"] = {step->beforePx.x(), step->beforePx.y()};
        item["afterPx"] = {step->afterPx.x(), step->afterPx.y()};
    }
    return item;
}

void writeJson(const std::string& file, const RigVerdict& verdict) {
    const auto& [sequences, health, sigmas, refinement, worldSigmaMm] = verdict;
    ordered_json document;
    document["sigmaPx"] = refinement ? ordered_json(refinement->sigmaPx) : ordered_json(nullptr);
    document["joints"] = health.joints;
    document["frames"] = health.frames;
    document["cameras"] = ordered_json::array();
    for (std::size_t c = 0; c < health.cameras.size(); ++c) {
        ordered_json item = cameraJson(health.cameras[c]);
        if (c < sigmas.systematicPx.size())
            item["systematicPx"] = sigmas.systematicPx[c];
        for (const core::SequenceHealth& sequence : health.cameras[c].sequences)
            item["sequences"].push_back(sequenceJson(sequence, sequences));
        document["cameras"].push_back(item);
    }
    document["raters"] = ordered_json::array();
    for (const auto& [rater, sigma] : sigmas.raters)
        document["raters"].push_back(raterJson(health, rater, sigma));
    document["findings"] = core::rigFindings(health, sequences);
    if (refinement)
        document["refinement"] = refinementJson(*refinement, worldSigmaMm);
    core::checkSchema(nlohmann::json(document), "rig-health", file);
    core::writeJsonFile(file, document);
}

/// How far every rater's clicks scatter, and what the cameras add.
void printSigmas(const core::ClickSigmas& sigmas) {
    for (const auto& [rater, sigma] : sigmas.raters) {
        if (sigma.isAssumed) {
            std::printf("clicks of %s: too few to know how far they scatter; 1 px is assumed\n", rater.c_str());
            continue;
        }
        const auto [least, most] = std::minmax_element(sigma.clickPxByCamera.begin(), sigma.clickPxByCamera.end());
        std::printf("clicks of %s scatter by %.2f px per axis (%.2f to %.2f by camera)\n", rater.c_str(), sigma.clickPx,
                    *least, *most);
    }
    if (!sigmas.systematicPx.empty()) {
        const auto [least, most] = std::minmax_element(sigmas.systematicPx.begin(), sigmas.systematicPx.end());
        std::printf("the calibration's own error adds %.2f to %.2f px\n", *least, *most);
    }
}

void printHealth(const core::RigHealth& health, const std::vector<std::string>& sequences) {
    std::printf("%d joints in %d frames; residuals are clicked - projected, px\n", health.joints, health.frames);
    std::printf("%-12s %7s %7s %17s %9s %9s\n", "camera", "clicks", "rms", "mean dx, dy", "+-", "scatter");
    for (const core::CameraHealth& camera : health.cameras) {
        if (!camera.isKnown && !health.canTellCameras()) {
            std::printf("%-12s %7d   cannot be known from two cameras\n", camera.camera.c_str(), camera.clicks);
            continue;
        }
        if (!camera.isKnown) {
            std::printf("%-12s %7d   cannot be known: only %d clicks that others confirm\n", camera.camera.c_str(),
                        camera.clicks, camera.clicks);
            continue;
        }
        std::printf("%-12s %7d %7.2f %8.2f %8.2f %9.2f %9.2f%s\n", camera.camera.c_str(), camera.clicks, camera.rmsPx,
                    camera.meanPx.x(), camera.meanPx.y(), camera.meanSigmaPx, camera.scatterPx,
                    camera.isOff ? "  off" : "");
    }
    for (const std::string& sentence : core::rigFindings(health, sequences))
        std::printf("%s\n", sentence.c_str());
}

void printRefinement(const core::RigRefinement& refinement, const std::optional<double>& worldSigmaMm) {
    std::printf("refined from %d joints in %d frames; a click scatters by %.2f px per axis; %d wrong clicks\n",
                refinement.joints, refinement.frames, refinement.sigmaPx, refinement.wrongClicks);
    std::printf("%-12s %10s %10s %10s %10s %10s\n", "camera", "rms before", "rms after", "turned deg", "moved mm",
                "focal %");
    for (const core::CameraRefinement& change : refinement.changes) {
        std::printf("%-12s %10.2f %10.2f %10.3f %10.2f %+10.3f\n", change.camera.c_str(), change.beforeRmsPx,
                    change.afterRmsPx, change.turnDeg, change.shiftMm, 100 * change.focalShare);
    }
    if (worldSigmaMm)
        std::printf("distances and shapes are as good as the clicks; the world as a whole lies where the calibration "
                    "as given had it, +- %.2f mm\n",
                    *worldSigmaMm);
}

/// Whether refining is worth it, and what it still needs.
void printAdvice(const core::RigHealth& health, const std::vector<core::RigJoint>& joints, bool isPossible) {
    if (!health.canTellCameras()) {
        std::printf("two cameras cannot tell which of them is off: a refinement needs three\n");
        return;
    }
    const core::RefinementNeeds needs = core::adviseRefinement(health, joints);
    switch (isPossible ? needs.advice : core::RefinementAdvice::NeedsMoreJoints) {
    case core::RefinementAdvice::NeedsMoreJoints:
        std::printf("a refinement needs %d joints seen by three cameras or more (there are %d)\n", needs.leastJoints,
                    needs.wellSeenJoints);
        break;
    case core::RefinementAdvice::NotNeeded:
        std::printf("the calibration fits the clicks\n");
        break;
    case core::RefinementAdvice::NeedsMoreFrames:
        std::printf("refining is worth it from %d frames and %d joints on (there are %d and %d)\n",
                    needs.worthwhileFrames, needs.worthwhileJoints, health.frames, needs.wellSeenJoints);
        break;
    case core::RefinementAdvice::Worthwhile:
        std::printf("worth refining: --refine --out CAMERAS\n");
    }
}

void rig(const RigArguments& arguments) {
    if (arguments.refine == arguments.out.empty()) {
        throw core::Error(core::ErrorCode::Usage, arguments.refine ? "--refine" : "--out", "",
                          arguments.refine ? "needs --out CAMERAS" : "is for --refine");
    }
    const core::Dataset dataset = core::readDataset(arguments.dataset);
    const std::vector<core::RigJoint> joints = core::readRigJoints(dataset, arguments.sequences, arguments.rater);
    const core::RigResiduals residuals = core::computeRigResiduals(dataset.cameras, joints);
    const core::RigHealth health = core::judgeRig(dataset.cameras, joints, residuals);
    const core::ClickSigmas sigmas = core::estimateClickSigmas(dataset.cameras, joints, residuals);
    const std::vector<std::string> sequences = core::sequenceNames(dataset);
    const auto refinement = core::refineRig(dataset.cameras, joints, residuals, {}, interruptToken());
    if (interruptToken().stop_requested())
        throw Interrupted(arguments.dataset + ": stopped; nothing was written");
    std::optional<double> worldSigmaMm;
    if (const auto world =
            refinement ? core::worldCovariance(dataset.cameras, sigmas, refinement->middleInWorld) : std::nullopt)
        worldSigmaMm = core::sigmaMm(*world);
    printHealth(health, sequences);
    printSigmas(sigmas);
    if (refinement && arguments.refine)
        printRefinement(*refinement, worldSigmaMm);
    if (!arguments.refine)
        printAdvice(health, joints, refinement.has_value());
    if (!arguments.json.empty())
        writeJson(arguments.json, {sequences, health, sigmas, refinement, worldSigmaMm});
    if (!arguments.refine)
        return;
    if (!refinement) {
        throw core::Error(
            core::ErrorCode::BadInput, arguments.dataset, "annotations",
            "too few clicks to refine the calibration: " + std::to_string(core::RigRefinementOptions{}.leastJoints) +
                " joints seen by three cameras or more are needed, there are " +
                std::to_string(core::countWellSeenJoints(joints)));
    }
    core::writeCameras(arguments.out, refinement->cameras);
    std::printf("%s: the refined cameras (the dataset is as it was)\n", arguments.out.c_str());
}

} // namespace

void addRigVerb(CLI::App& program) {
    auto arguments = std::make_shared<RigArguments>();
    CLI::App* verb =
        program.add_subcommand("rig", "Judge a dataset's calibration by its clicks, and refine it into a new file");
    verb->add_option("dataset", arguments->dataset, "The dataset folder; it is never changed")->required();
    verb->add_option("--sequences", arguments->sequences, "Only these sequences, separated by commas")->delimiter(',');
    verb->add_option("--rater", arguments->rater, "Only this rater's clicks");
    verb->add_option("--json", arguments->json, "Write the findings as JSON");
    verb->add_flag("--refine", arguments->refine, "Adjust the cameras to the clicks (bundle adjustment)");
    verb->add_option("--out", arguments->out, "The cameras file that --refine writes");
    verb->callback([arguments] { rig(*arguments); });
}

} // namespace app
