// SPDX-License-Identifier: MIT
#include "core/io/segmentation/detected_points.h"

namespace core {

SequencePoints pointsOfLabels(const AutoLabels& labels) {
    SequencePoints points;
    for (const auto& [frame, hands] : labels)
        for (const AutoHand& label : hands)
            for (const AutoJoint& joint : label.joints) {
                TriangulatedPoint point;
                point.pointInWorld = joint.pointInWorld;
                point.covariance = joint.covariance;
                points[frame].emplace(JointId{label.side, joint.name}, point);
            }
    return points;
}

std::optional<SequencePoints> detectPoints(const Dataset& dataset, const Sequence& sequence,
                                           const DetectorNetworks& networks, const std::vector<int>& frames,
                                           const std::filesystem::path& journalFile, std::stop_token stop,
                                           const std::function<void(int done, int total)>& progress,
                                           const std::vector<HandModel>& otherHands) {
    FirstPassOptions options;
    options.withSilhouettes = false;
    options.otherHands = otherHands;
    options.journal = journalFile;
    FirstPassCallbacks callbacks;
    callbacks.progress = [&progress](PassStage, int done, int total) { progress(done, total); };
    const FirstPassResult result = runFirstPass(dataset, sequence, networks, frames, options, stop, callbacks);
    if (!result.isFinished)
        return std::nullopt;
    return pointsOfLabels(result.labels);
}

} // namespace core
