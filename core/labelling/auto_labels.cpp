// SPDX-License-Identifier: MIT
#include "core/labelling/auto_labels.h"

#include <algorithm>
#include <cmath>

#include "core/detection/landmark_errors.h"

namespace core {

namespace {

/// A hand from the detector's landmarks alone is off by more than 5 mm every other time (docs/results.md), whatever
/// they say.
constexpr double kLeastDoubtOfLandmarks = 0.5;

/// Which landmark stands for a joint; kLandmarkCount if none does.
std::size_t landmarkOf(const std::string& joint) {
    std::size_t landmark = 0;
    while (landmark < kLandmarkCount && landmarkName(landmark) != joint)
        ++landmark;
    return landmark;
}

/// Places the joint into the cameras and lays the detector's landmarks beside it.
void addViews(AutoJoint& joint, const std::vector<Camera>& cameras, const SpatialHand* detected) {
    const std::size_t landmark = landmarkOf(joint.name);
    for (std::size_t c = 0; c < cameras.size(); ++c) {
        const auto px = project(cameras[c], joint.pointInWorld);
        if (!px || !isInside(cameras[c].size, *px))
            continue;
        AutoView view{static_cast<int>(c), *px, std::nullopt};
        if (detected && landmark < kLandmarkCount)
            if (const auto seen = detected->views.find(view.camera); seen != detected->views.end())
                view.errorPx = (seen->second.px[landmark] - *px).norm();
        joint.views.push_back(view);
    }
}

AutoHand autoHand(const HandModel& model, const FittedHand& fitted, const SpatialHand* detected,
                  const std::vector<Camera>& cameras, double unitMm) {
    AutoHand hand;
    hand.side = model.side;
    hand.doubt = fitted.doubt;
    const auto joints = jointPositions(model.skeleton, fitted.pose);
    for (std::size_t b = 0; b < joints.size(); ++b) {
        AutoJoint joint{
            model.skeleton.bones[b].name, joints[b] / unitMm, fitted.jointCovarianceMm2[b] / (unitMm * unitMm), {}};
        addViews(joint, cameras, detected);
        hand.joints.push_back(std::move(joint));
    }
    const std::string wrist(landmarkName(kWristLandmark));
    if (model.skeleton.boneIndex(wrist) < 0 && detected && detected->landmarks[kWristLandmark]) {
        const SpatialHand unbiased = withoutBias(*detected, model.side);
        const TriangulatedPoint& point = unbiased.landmarks[kWristLandmark]->triangulated;
        AutoJoint joint{wrist, point.pointInWorld / unitMm, point.covariance / (unitMm * unitMm), {}};
        addViews(joint, cameras, detected);
        hand.joints.push_back(std::move(joint));
    }
    return hand;
}

} // namespace

std::optional<double> AutoJoint::rmsPx() const {
    double sum = 0;
    int count = 0;
    for (const AutoView& view : views)
        if (view.errorPx) {
            sum += *view.errorPx * *view.errorPx;
            ++count;
        }
    return count > 0 ? std::optional(std::sqrt(sum / count)) : std::nullopt;
}

std::vector<AutoHand> autoHands(const PassResult& pass, int frame, const std::vector<Camera>& cameras) {
    const FrameFit& fit = pass.fits.at(frame);
    const auto seen = pass.detected.find(frame);
    std::vector<AutoHand> hands;
    for (std::size_t h = 0; h < fit.hands.size(); ++h) {
        if (fit.hands[h].pose.size() == 0)
            continue;
        const SpatialHand* detected = seen != pass.detected.end() && seen->second[h] ? &*seen->second[h] : nullptr;
        hands.push_back(autoHand(pass.hands[h], fit.hands[h], detected, cameras, pass.unitMm));
        hands.back().source = fit.source;
        if (fit.source == FitSource::Landmarks)
            hands.back().doubt = std::max(hands.back().doubt, kLeastDoubtOfLandmarks);
    }
    return hands;
}

AutoLabels autoLabels(const PassResult& pass, const std::vector<Camera>& cameras) {
    AutoLabels labels;
    for (const auto& [frame, fit] : pass.fits)
        if (!fit.isEmpty())
            labels[frame] = autoHands(pass, frame, cameras);
    return labels;
}

} // namespace core
