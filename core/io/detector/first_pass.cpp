// SPDX-License-Identifier: MIT
#include "core/io/detector/first_pass.h"

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/detector/pass_source.h"
#include "core/io/files/content_hash.h"

namespace core {

namespace {

/// Raised whenever a change makes passes end in other labels: steps of different revisions are never mixed.
constexpr int kPassRevision = 3;

std::uint64_t hashOf(const NetworkGraph& graph) {
    std::uint64_t hash = 0;
    for (const NetworkTensor& tensor : graph.tensors)
        hash = hash * 31 + contentHash(tensor.values.data(), tensor.values.size() * sizeof(float));
    return hash;
}

std::uint64_t hashOf(const std::vector<HandModel>& hands) {
    std::uint64_t hash = 0;
    for (const HandModel& hand : hands) {
        for (const Eigen::Vector3d& vertex : hand.mesh.vertices)
            hash = hash * 31 + contentHash(vertex.data(), sizeof(Eigen::Vector3d));
        for (const Bone& bone : hand.skeleton.bones)
            hash = hash * 31 + contentHash(bone.worldFromBoneAtRest.translation.data(), sizeof(Eigen::Vector3d));
    }
    return hash;
}

JournalWork workOf(const Dataset& dataset, const Sequence& sequence, const DetectorNetworks& networks,
                   const std::vector<int>& frames, const std::vector<HandModel>& hands, const PassOptions& options) {
    JournalWork work;
    work.detections = detectionWork(dataset, sequence, networks);
    work.fits =
        nlohmann::json{
            kPassRevision,           kEstimatorRevision,   contentHash(frames.data(), frames.size() * sizeof(int)),
            hashOf(hands),           sequence.masks,       options.keyEveryFrames,
            options.withSilhouettes, options.measureHands, options.mostPilots,
            options.leastDoubt,      options.mostGapFrames}
            .dump();
    return work;
}

} // namespace

std::string detectionWork(const Dataset& dataset, const Sequence& sequence, const DetectorNetworks& networks) {
    const std::string cameras = camerasToJson(dataset.cameras).dump();
    return std::filesystem::absolute(dataset.folder).lexically_normal().string() + ", " + sequence.name + ", " +
           std::to_string(contentHash(cameras.data(), cameras.size())) + ", " +
           std::to_string(hashOf(networks.palms) ^ hashOf(networks.landmarks));
}

FirstPassResult runFirstPass(const Dataset& dataset, const Sequence& sequence, const DetectorNetworks& networks,
                             const std::vector<int>& frames, const FirstPassOptions& options, std::stop_token stop,
                             const FirstPassCallbacks& callbacks) {
    const std::vector<HandModel>& hands = dataset.hands.empty() ? options.otherHands : dataset.hands;
    if (hands.empty())
        throw Error(ErrorCode::BadInput, (dataset.folder / "dataset.json").string(), "hands",
                    "there is no hand model to start from");
    std::optional<DetectionJournal> journal;
    if (!options.journal.empty())
        journal.emplace(options.journal, workOf(dataset, sequence, networks, frames, hands, options),
                        dataset.cameras.size());
    DatasetPassSource source(dataset, sequence, &networks, journal ? &*journal : nullptr);
    FirstPassResult result;
    result.resumedFrames = journal ? static_cast<int>(journal->frames().size()) : 0;
    PassSink sink;
    if (callbacks.frame)
        sink = [&](const PassResult& pass, int frame) {
            callbacks.frame(frame, autoHands(pass, frame, dataset.cameras));
        };
    PassOptions passOptions = options;
    passOptions.landmarksAreJoints = dataset.hands.empty();
    result.pass = runLabelPass(hands, dataset.cameras, frames, source, passOptions, stop, callbacks.progress, sink);
    result.isFinished = result.pass.isFinished;
    result.labels = autoLabels(result.pass, dataset.cameras);
    return result;
}

void finishFirstPass(const FirstPassOptions& options) {
    std::error_code ignored;
    if (!options.journal.empty())
        std::filesystem::remove(options.journal, ignored);
}

AutoLabels retrackFrames(const Dataset& dataset, const Sequence& sequence, const std::vector<HandModel>& hands,
                         const std::vector<Camera>& cameras, const CorrectedFrame& corrected,
                         const std::vector<int>& frames, const std::vector<int>& reviewed, const PassOptions& options,
                         std::stop_token stop, const FirstPassCallbacks& callbacks) {
    DatasetPassSource source(dataset, sequence, nullptr, nullptr);
    PassSink sink;
    if (callbacks.frame)
        sink = [&](const PassResult& pass, int frame) {
            callbacks.frame(frame, autoHands(pass, frame, dataset.cameras));
        };
    return autoLabels(
        retrack(hands, cameras, corrected, frames, reviewed, source, options, stop, callbacks.progress, sink),
        dataset.cameras);
}

} // namespace core
