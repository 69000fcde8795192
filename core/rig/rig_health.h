// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/rig/camera_course.h"
#include "core/rig/rig_residuals.h"

namespace core {

/// What all clicks say of one camera. Residuals are clicked - projected, px, y down.
struct CameraHealth {
    std::string camera;
    int clicks = 0;
    double rmsPx = 0;                                 ///< about points made from all cameras
    Eigen::Vector2d meanPx = Eigen::Vector2d::Zero(); ///< robust mean; the point is made from the other cameras
    double meanSigmaPx = 0;                           ///< standard deviation of each of its coordinates
    /// How that mean varies from the image's middle to its edge (half its larger side): d(dx, dy) / d(x, y), px.
    Eigen::Matrix2d variationPx = Eigen::Matrix2d::Zero();
    double leaveOneOutPx = 0; ///< median distance from what the other cameras say
    double scatterPx = 0;     ///< per axis, after mean and variation are taken off
    double spreadPx = 0;      ///< per axis, of clicks and calibration error together: what a click of it is worth
    std::vector<SequenceHealth> sequences; ///< those with enough clicks of it: moves, drift, off there only
    /// Change of the mean over the frames of the sequence in which it drifts most clearly, px per 100 frames, with its
    /// standard deviation.
    std::optional<Eigen::Vector2d> driftPx;
    double driftSigmaPx = 0;
    /// By how many frames its picture lies behind the others', from residuals that go with the joints' image velocity.
    std::optional<double> delayFrames;
    double delaySigmaFrames = 0;
    int wrongClicks = 0;     ///< far off while the camera's other clicks are not
    bool isKnown = false;    ///< enough clicks to judge it
    bool isOff = false;      ///< in every frame: systematic, significant and large enough to matter
    bool isLate = false;     ///< delayFrames is significant and at least a tenth of a frame
    bool isDrifting = false; ///< in a sequence
    bool hasMoved = false;   ///< within a sequence: it has a step
};

/// The state of a calibration as the clicks show it.
struct RigHealth {
    std::vector<CameraHealth> cameras; ///< parallel to the dataset's
    int joints = 0;
    int frames = 0;
    bool isKnown = false;
    bool anyOff() const;
    /// Two cameras cannot tell which of them is off.
    bool canTellCameras() const { return cameras.size() >= 3; }
};

struct RigHealthOptions {
    int leastClicks = 12;    ///< a camera with fewer is not judged
    double leastOffPx = 1;   ///< smaller systematic residuals do not matter
    double significance = 4; ///< in standard deviations
    int widestGapFrames = 6; ///< image velocities are taken from frames no farther apart
    double leastDelayFrames = 0.1;
};

/// Judges every camera by all clicks. A wrong click is told from a camera that is off by being alone, one that moved
/// within a sequence or between two from one that is off always. `residuals` are those of the joints.
RigHealth judgeRig(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints,
                   const RigResiduals& residuals, const RigHealthOptions& options = {});
RigHealth judgeRig(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints,
                   const RigHealthOptions& options = {});

} // namespace core
