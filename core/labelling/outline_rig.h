// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/labelling/pass_hands.h"
#include "core/rig/rig_refinement.h"

namespace core {

/// By how much a silhouette lies beside the one of posed hands, px: the shift that brings most of the models' outline
/// onto the observed one. Outline where an arm may be seen takes no part. None if little of it is near an observed one.
std::optional<Eigen::Vector2d> outlineShift(const Camera& camera, const std::vector<HandModel>& hands,
                                            const HandPoses& poses, const cv::Mat& mask);

struct AdjustedCameras {
    std::vector<Camera> cameras;
    double shiftPx; ///< by which silhouettes lay beside the hands with the given cameras, root mean square
};

/// A calibration adjusted (refineRig) to how the silhouettes of several frames lie beside the hands that were fitted to
/// all of them: a camera that is off shifts its own picture in every frame. None where shifts are as small as those of
/// a good calibration (root mean square below 2 px), which outlines could only make worse, or where they do not tell.
/// The world stays where most cameras saw the hands, like that of refineRig.
std::optional<AdjustedCameras> camerasByOutlines(const std::vector<Camera>& cameras,
                                                 const std::vector<HandModel>& hands,
                                                 const std::vector<MeasuredFrame>& frames, std::stop_token stop);

} // namespace core
