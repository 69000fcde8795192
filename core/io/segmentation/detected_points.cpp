// SPDX-License-Identifier: MIT
#include "core/io/segmentation/detected_points.h"

namespace core {

SequencePoints pointsOfLabels(const AutoLabels& labels) {
    SequencePoints points;
    for (const auto& [frame, hands] : labels)
        for (const AutoHand& label : hands)
            for (std::size_t i = 0; i < kLandmarkCount; ++i)
                if (const auto& landmark = label.hand.hand.landmarks[i])
                    points[frame].emplace(JointId{label.hand.side, std::string(landmarkName(i))},
                                          landmark->triangulated);
    return points;
}

std::optional<SequencePoints> detectPoints(const Dataset& dataset, const Sequence& sequence,
                                           const DetectorNetworks& networks, const std::vector<int>& frames,
                                           const std::filesystem::path& journalFile, std::stop_token stop,
                                           const std::function<void(int done, int total)>& progress) {
    DetectionJournal journal(journalFile, firstPassWork(dataset, sequence, networks), dataset.cameras.size());
    if (!detectFrames(dataset, sequence, networks, frames, journal, stop, progress))
        return std::nullopt;
    return pointsOfLabels(labelsOf(dataset, sequence, journal.frames(), frames));
}

} // namespace core
