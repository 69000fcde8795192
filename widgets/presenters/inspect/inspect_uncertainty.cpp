// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect/inspect_uncertainty.h"

#include <cmath>
#include <numbers>

#include "core/annotation/reconstruction.h"
#include "core/hand/skeleton.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

constexpr int kEllipseCorners = 28;

QPointF onEllipse(const core::PixelEllipse& ellipse, int corner) {
    const double turn = 2 * std::numbers::pi * corner / kEllipseCorners;
    const double a = ellipse.halfAxesPx.x() * std::cos(turn), b = ellipse.halfAxesPx.y() * std::sin(turn);
    const double c = std::cos(ellipse.angleRad), s = std::sin(ellipse.angleRad);
    return {ellipse.centrePx.x() + c * a - s * b, ellipse.centrePx.y() + s * a + c * b};
}

} // namespace

std::vector<JointUncertainty> jointUncertainties(const core::Dataset& dataset, const MethodOutcome& method) {
    std::vector<JointUncertainty> joints;
    const auto& confidence = method.result.confidence;
    const core::HandPoses& poses = method.result.poses;
    for (std::size_t hand = 0; confidence && hand < dataset.hands.size() && hand < poses.size(); ++hand) {
        if (hand >= confidence->jointCovarianceMm2.size() || poses[hand].size() == 0)
            continue;
        const core::Skeleton& skeleton = dataset.hands[hand].skeleton;
        const auto positions = core::jointPositions(skeleton, poses[hand]);
        const auto& covariances = confidence->jointCovarianceMm2[hand];
        for (std::size_t bone = 0; bone < positions.size() && bone < covariances.size(); ++bone)
            joints.push_back(
                {{dataset.hands[hand].side, skeleton.bones[bone].name}, positions[bone], covariances[bone]});
    }
    return joints;
}

void addUncertainty(const std::vector<JointUncertainty>& joints, const core::Camera& camera, OverlayShapes& shapes) {
    for (const JointUncertainty& joint : joints) {
        const auto ellipse = core::projectedEllipse(camera, joint.pointInWorld, joint.covarianceInWorld);
        if (!ellipse)
            continue;
        const QColor colour = fingerColour(joint.joint.joint);
        for (int corner = 0; corner < kEllipseCorners; ++corner)
            shapes.lines.push_back({onEllipse(*ellipse, corner), onEllipse(*ellipse, corner + 1), colour});
    }
}

} // namespace widgets
