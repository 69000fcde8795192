// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/contour/forearm.h"
#include "core/geometry/camera.h"
#include "core/hand/hand_model.h"
#include "core/segmentation/hand_in_view.h"
#include "core/segmentation/seeds.h"

namespace core {

struct ModelSeedOptions {
    double bandMm = 6;    ///< by which the posed model may be wrong: within it the picture decides
    double marginMm = 12; ///< background around it that colours are learnt from
};

/// A posed hand model as a picture's seeds.
struct ModelSeeds {
    Seeds seeds;
    cv::Mat model; ///< its silhouette: CV_8U of the window's size, 0 and 255
    cv::Mat arms;  ///< 255 where an arm goes on beyond a model's end; of the same size
    double bandPx = 0;
    std::vector<ForearmLine> cuts; ///< where the models end
};

/// Seeds of the hands of a picture by their posed models: farther inside the silhouette than the band is sure
/// foreground, farther outside sure background. Hands with an empty pose are left out; the window is empty if none is
/// seen.
ModelSeeds modelSeeds(const Camera& camera, const std::vector<HandModel>& hands, const HandPoses& poses,
                      const ModelSeedOptions& options = {});

/// Where a posed model ends towards the forearm, as a line of the picture; none if the arm is seen from its end.
std::optional<ForearmLine> modelEnd(const Camera& camera, const HandModel& hand, const Pose& pose);

} // namespace core
