// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/io/dataset/frames.h"
#include "core/io/segmentation/sequence_evidence.h"

namespace core {

/// Which silhouettes are to be made, and by what.
struct SegmentationWork {
    const Dataset* dataset = nullptr;
    const Sequence* sequence = nullptr;
    std::vector<int> frames;
    SilhouetteOptions options;
    const SequenceEvidence* evidence = nullptr;
    std::vector<cv::Mat> roomPictures; ///< per camera, for Background
    std::filesystem::path folder;      ///< claimed by claimMaskFolder
};

struct SegmentationSummary {
    int made = 0;              ///< masks
    int kept = 0;              ///< that were there already
    int empty = 0;             ///< of those made: no hand is seen there
    int unknown = 0;           ///< pictures that nothing was known of: no mask was made
    bool stopped = false;      ///< before the end; what was made is whole
    double secondsPerMask = 0; ///< of one core, reading and writing aside
};

/// Makes the silhouettes of all cameras in these frames, several cameras at once, and writes each as soon as it is
/// found: into a new file, then renamed. Files that are there are kept as they are. Says after each picture how many
/// are done. Throws Error.
SegmentationSummary segmentFrames(const SegmentationWork& work, const FrameSource& source, std::stop_token stop,
                                  const std::function<void(int done, int total)>& progress);

} // namespace core
