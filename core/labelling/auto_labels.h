// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/labelling/label_pass.h"

namespace core {

/// Where a joint is seen in a camera.
struct AutoView {
    int camera = 0;
    Eigen::Vector2d px = Eigen::Vector2d::Zero(); ///< its projection, within the picture
    std::optional<double> errorPx;                ///< distance to where the detector saw it; none if it did not look
};

/// A joint that nobody clicked; lengths in the calibration's unit.
struct AutoJoint {
    std::string name;
    Eigen::Vector3d pointInWorld = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
    std::vector<AutoView> views;

    std::optional<double> rmsPx() const; ///< over the views that the detector saw it in
};

/// A hand as the first pass labels it.
struct AutoHand {
    Side side = Side::Left;
    std::vector<AutoJoint> joints;
    double doubt = 1; ///< 0 = sure .. 1 = lost
    FitSource source = FitSource::Landmarks;
};
/// By frame; frames in which nothing was found have none.
using AutoLabels = std::map<int, std::vector<AutoHand>>;

/// The hands of one frame of a pass. `cameras` as the dataset has them.
std::vector<AutoHand> autoHands(const PassResult& pass, int frame, const std::vector<Camera>& cameras);

/// The hands of all frames of a pass: the joints of the models, their tips, and, of models without a wrist, the
/// detector's.
AutoLabels autoLabels(const PassResult& pass, const std::vector<Camera>& cameras);

} // namespace core
