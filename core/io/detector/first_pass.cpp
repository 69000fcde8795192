// SPDX-License-Identifier: MIT
#include "core/io/detector/first_pass.h"

#include <algorithm>

#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>

#include "core/detection/frame_detection.h"
#include "core/detection/landmark_errors.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/dataset/frames.h"
#include "core/io/files/content_hash.h"

namespace core {

namespace {

constexpr int kKnownFrames = 30; ///< after which hands are no longer near where they were
constexpr int kSearchEvery = 25; ///< frames after which a second hand is looked for again

/// The pictures of all cameras, read side by side; empty where there is none.
std::vector<cv::Mat> readPictures(const FrameSource& source, std::size_t cameras, int frame) {
    std::vector<cv::Mat> pictures(cameras);
    const int count = static_cast<int>(cameras);
    cv::parallel_for_(
        cv::Range(0, count),
        [&](const cv::Range& range) {
            for (int camera = range.start; camera < range.end; ++camera)
                if (source.hasPicture(camera, frame))
                    pictures[static_cast<std::size_t>(camera)] = source.read(camera, frame);
        },
        count);
    return pictures;
}

std::uint64_t hashOf(const NetworkGraph& graph) {
    std::uint64_t hash = 0;
    for (const NetworkTensor& tensor : graph.tensors)
        hash = hash * 31 + contentHash(tensor.values.data(), tensor.values.size() * sizeof(float));
    return hash;
}

} // namespace

std::string firstPassWork(const Dataset& dataset, const Sequence& sequence, const DetectorNetworks& networks) {
    const std::string cameras = camerasToJson(dataset.cameras).dump();
    return std::filesystem::absolute(dataset.folder).lexically_normal().string() + ", " + sequence.name + ", " +
           std::to_string(contentHash(cameras.data(), cameras.size())) + ", " +
           std::to_string(hashOf(networks.palms) ^ hashOf(networks.landmarks));
}

bool detectFrames(const Dataset& dataset, const Sequence& sequence, const DetectorNetworks& networks,
                  const std::vector<int>& frames, DetectionJournal& journal, std::stop_token stop,
                  const std::function<void(int done, int total)>& progress) {
    const FrameSource source(dataset, sequence, readMotion(dataset, sequence));
    FrameDetector detector(networks, dataset.cameras);
    std::vector<SpatialHand> near;
    int nearFrame = -kKnownFrames, sinceSearch = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (stop.stop_requested())
            return false;
        const int frame = frames[i];
        if (journal.frames().count(frame) == 0) {
            if (std::abs(frame - nearFrame) > kKnownFrames)
                near.clear();
            const bool searchAnyway = near.size() == 1 && ++sinceSearch >= kSearchEvery;
            if (searchAnyway)
                sinceSearch = 0;
            journal.append(frame,
                           detector.detect(readPictures(source, dataset.cameras.size(), frame), near, searchAnyway));
        }
        near = groupDetections(dataset.cameras, journal.frames().at(frame));
        nearFrame = frame;
        progress(static_cast<int>(i) + 1, static_cast<int>(frames.size()));
    }
    return true;
}

AutoLabels labelsOf(const Dataset& dataset, const Sequence& sequence, const std::map<int, ViewDetections>& detections,
                    const std::vector<int>& frames) {
    std::map<int, std::vector<SpatialHand>> hands;
    for (const int frame : frames)
        if (const auto found = detections.find(frame); found != detections.end())
            hands[frame] = groupDetections(dataset.cameras, found->second);
    const auto sided = giveSides(hands);
    const auto doubts = doubtsOf(sided, countViews(sequence));
    AutoLabels labels;
    for (const auto& [frame, list] : sided)
        for (std::size_t i = 0; i < list.size(); ++i) {
            SidedHand hand = list[i];
            hand.hand = withoutBias(std::move(hand.hand), hand.side);
            labels[frame].push_back({std::move(hand), doubts.at(frame)[i]});
        }
    return labels;
}

} // namespace core
