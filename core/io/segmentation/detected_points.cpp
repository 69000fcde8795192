// SPDX-License-Identifier: MIT
#include "core/io/segmentation/detected_points.h"

#include <string>

#include "core/detection/hand_sides.h"
#include "core/io/detector/first_pass.h"
#include "core/io/detector/pass_source.h"

namespace core {

SequencePoints pointsOfDetections(const std::vector<Camera>& cameras, const std::map<int, ViewDetections>& views) {
    std::map<int, std::vector<SpatialHand>> hands;
    for (const auto& [frame, detections] : views)
        hands[frame] = groupDetections(cameras, detections);
    SequencePoints points;
    for (const auto& [frame, sided] : giveSides(hands))
        for (const SidedHand& hand : sided)
            for (std::size_t i = 0; i < kLandmarkCount; ++i)
                if (const auto& landmark = hand.hand.landmarks[i])
                    points[frame].emplace(JointId{hand.side, std::string(landmarkName(i))}, landmark->triangulated);
    return points;
}

std::optional<SequencePoints> detectPoints(const Dataset& dataset, const Sequence& sequence,
                                           const DetectorNetworks& networks, const std::vector<int>& frames,
                                           const std::filesystem::path& journalFile, std::stop_token stop,
                                           const std::function<void(int done, int total)>& progress) {
    DetectionJournal journal(journalFile, {detectionWork(dataset, sequence, networks), {}}, dataset.cameras.size());
    DatasetPassSource source(dataset, sequence, &networks, &journal);
    const int total = static_cast<int>(frames.size());
    int done = 0;
    const auto views = detectFrames(dataset.cameras, frames, source, PassOptions().mostGapFrames, stop,
                                    [&] { progress(++done, total); });
    if (stop.stop_requested())
        return std::nullopt;
    return pointsOfDetections(dataset.cameras, views);
}

} // namespace core
