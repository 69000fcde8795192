// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/contour/forearm.h"
#include "core/geometry/camera.h"
#include "core/hand/hand_model.h"
#include "core/segmentation/hand_in_view.h"
#include "core/segmentation/seeds.h"

namespace core {

struct ModelViewOptions {
    double bandMm = 6;    ///< by which the posed model may be wrong: within it the picture decides
    double marginMm = 12; ///< background around it that colours are learnt from
};

/// Posed hand models as a camera sees them.
struct ModelInView {
    cv::Rect window;  ///< of the picture: the models, the band and the margin; empty if none is seen
    cv::Mat model;    ///< their silhouette: CV_8U of the window's size, 0 and 255
    cv::Mat arms;     ///< 255 where an arm goes on beyond a model's end; of the same size
    cv::Mat armCores; ///< the part of these around the arms' axes, where there is nothing else if there is an arm
    double bandPx = 0;
    std::vector<ForearmLine> cuts; ///< where the models end
};

/// Hands with an empty pose are left out.
ModelInView modelInView(const Camera& camera, const std::vector<HandModel>& hands, const HandPoses& poses,
                        const ModelViewOptions& options = {});

/// Seeds of the hands of a picture by their posed models: farther inside the silhouette than the band is sure
/// foreground, farther outside sure background.
Seeds modelSeeds(const ModelInView& view);

/// Where a posed model ends towards the forearm, as a line of the picture; none if the arm is seen from its end.
std::optional<ForearmLine> modelEnd(const Camera& camera, const HandModel& hand, const Pose& pose);

} // namespace core
