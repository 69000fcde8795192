// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/geometry/camera.h"
#include "core/hand/hand_model.h"

namespace core {

/// Makes silhouettes of hands whose poses are roughly known: pictures (BGR, per camera; empty where there is none), the
/// hands and their poses (an empty pose: that hand is not there) -> masks as PoseEstimator::fit takes them.
using SilhouetteMaker = std::function<std::vector<cv::Mat>(
    const std::vector<cv::Mat>& pictures, const std::vector<HandModel>& hands, const HandPoses& poses)>;

struct ModelSilhouetteOptions {
    double reachMm = 18; ///< how far an outline may lie from that of the posed model
    int rounds = 2;      ///< of learning colours and telling pixels apart
};

/// Tells hands from their surroundings by colour: learnt from what lies well within the posed model and well outside
/// it, decided in the band between, with a pull to the model's own outline. Arms beyond the wrist belong to the hand as
/// far as they are seen. Views side by side; the result does not depend on how many.
std::vector<cv::Mat> silhouettesByModel(const std::vector<Camera>& cameras, const std::vector<cv::Mat>& pictures,
                                        const std::vector<HandModel>& hands, const HandPoses& poses,
                                        const ModelSilhouetteOptions& options = {});

} // namespace core
