// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/detection/frame_detection.h"
#include "core/io/dataset/dataset.h"
#include "core/labelling/label_pass.h"
#include "core/simulation/simulated_pictures.h"

namespace trial {

/// How a simulated recording is made of a dataset's recorded motion.
struct RecordingOptions {
    core::Imperfection imperfection;
    int cameras = 8;           ///< of the dataset's, evenly drawn
    std::vector<int> views;    ///< these instead, by index
    bool hasClutter = false;   ///< a room behind the hands, sleeves and noise; else a plain backdrop
    double exposureFrames = 0; ///< motion blur
    double defocusPx = 0;      ///< blur
    double asideShare = 0;     ///< of the picture's width by which every second camera looks past the hands
    int firstFrame = 18;
    int every = 14;
    int mostFrames = 1000;
    double leastHidden = 0; ///< hiddenShare of a hand; other frames are left out
    std::uint64_t seed = 1;
};

/// Pictures of another person's hands before cameras that are not quite those of the calibration, drawn when a pass
/// asks for them, and the true joints. Processor time of drawing is counted, so that it can be taken off.
class Recording : public core::PassSource {
public:
    /// `dataset` holds hands, cameras and recorded motion; nothing is read of its pictures.
    Recording(core::Dataset dataset, const std::string& sequence, const core::DetectorNetworks& networks,
              const RecordingOptions& options);

    int viewCount() const override { return static_cast<int>(m_dataset.cameras.size()); }
    core::FrameEvidence evidence(int frame) override;
    core::ViewDetections detect(int frame, const core::KnownHands& known) override;
    std::optional<core::FrameFit> recall(const std::string&, int) override { return std::nullopt; }
    void remember(const std::string&, int, const core::FrameFit&) override {}

    /// Hands and cameras as the calibration has them.
    const core::Dataset& dataset() const { return m_dataset; }
    const std::vector<int>& frames() const { return m_frames; }
    const std::vector<core::JointId>& joints() const { return m_joints; } ///< that people click
    Eigen::Vector3d truth(int frame, const core::JointId& joint) const;
    /// Where a joint really is in a picture.
    std::optional<Eigen::Vector2d> truePx(int frame, const core::JointId& joint, std::size_t camera) const;
    /// How much of a hand is behind the other one, mean over the views.
    double hiddenShare(int frame, core::Side side) const;
    double drawingSeconds() const { return m_drawingSeconds; }

private:
    const std::vector<cv::Mat>& pictures(int frame);

    core::Dataset m_dataset;
    RecordingOptions m_options;
    core::Motion m_motion;
    std::vector<int> m_frames;
    core::SimulatedWorld m_world;
    std::vector<core::JointId> m_joints;
    std::vector<cv::Mat> m_rooms;
    core::FrameDetector m_detector;
    std::map<int, std::vector<cv::Mat>> m_pictures; ///< of the last frames
    double m_drawingSeconds = 0;
};

} // namespace trial
