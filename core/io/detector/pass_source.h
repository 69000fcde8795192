// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include "core/detection/frame_detection.h"
#include "core/io/dataset/frames.h"
#include "core/io/detector/detection_journal.h"
#include "core/labelling/label_pass.h"

namespace core {

/// A sequence of a dataset as a pass needs it: pictures, given masks, the detector, and a journal.
class DatasetPassSource : public PassSource {
public:
    /// `networks` may be null: nothing is ever detected; `journal` may be null. All must outlive it.
    DatasetPassSource(const Dataset& dataset, const Sequence& sequence, const DetectorNetworks* networks,
                      DetectionJournal* journal);

    int viewCount() const override;
    FrameEvidence evidence(int frame) override;
    ViewDetections detect(int frame, const KnownHands& known) override;
    std::optional<FrameFit> recall(const std::string& step, int frame) override;
    void remember(const std::string& step, int frame, const FrameFit& fit) override;

private:
    const std::vector<cv::Mat>& pictures(int frame);

    const Dataset& m_dataset;
    const Sequence& m_sequence;
    FrameSource m_frames;
    std::unique_ptr<FrameDetector> m_detector;
    DetectionJournal* m_journal;
    int m_sinceSearch = 0;                               ///< frames in which one hand was found where it had been
    std::pair<int, std::vector<cv::Mat>> m_last{-1, {}}; ///< the frame that was read last
};

} // namespace core
