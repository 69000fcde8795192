// SPDX-License-Identifier: MIT
#include "core/labelling/pass_hands.h"

#include <algorithm>
#include <cmath>

#include "core/labelling/landmark_fit.h"
#include "core/labelling/palm_shape.h"
#include "core/labelling/pass_plan.h"
#include "core/subject/subject_estimate.h"

namespace core {

namespace {

constexpr double kHeldSigmaMm = 6; ///< how surely the joints of a fitted pose are where it has them
/// Boundary pixels lie 0.5 px inside an upright outline and 0.35 px inside a diagonal one.
constexpr double kOutlineOffsetPx = 0.45;

SubjectFrame subjectFrame(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                          const MeasuredFrame& measured) {
    SubjectFrame frame;
    for (std::size_t h = 0; h < hands.size(); ++h) {
        auto& targets = frame.targets.emplace_back();
        if (measured.poses[h].size() == 0)
            continue;
        const auto joints = jointPositions(hands[h].skeleton, measured.poses[h]);
        for (std::size_t b = 0; b < joints.size(); ++b)
            targets.push_back(
                {static_cast<int>(b), joints[b], kHeldSigmaMm * kHeldSigmaMm * Eigen::Matrix3d::Identity()});
    }
    FitTargetOptions options;
    options.contour.offsetPx = kOutlineOffsetPx;
    frame.outlines = makeFitTargets(cameras, measured.masks, options, 1);
    return frame;
}

/// A hand that was measured from `first`, as it compares with the model that that one was measured from.
void compareWithModel(SubjectHand& hand, const SubjectHand& first) {
    hand.scale.value *= first.scale.value;
    for (std::size_t b = 0; b < std::min(hand.bones.size(), first.bones.size()); ++b) {
        SubjectBone& bone = hand.bones[b];
        bone.modelMm = first.bones[b].modelMm;
        bone.share = bone.lengthMm / (bone.modelMm * hand.scale.value) - 1;
    }
}

} // namespace

std::vector<SubjectHand> measureLandmarks(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                                          const std::map<int, HandDetections>& detected, std::size_t mostFrames,
                                          const LandmarkFitOptions& landmarks, std::stop_token stop) {
    std::vector<int> seen;
    for (const auto& [number, list] : detected)
        if (std::any_of(list.begin(), list.end(), [](const auto& hand) { return hand.has_value(); }))
            seen.push_back(number);
    std::vector<SubjectFrame> frames;
    for (const int number : evenlyDrawn(seen, mostFrames)) {
        SubjectFrame& frame = frames.emplace_back();
        const HandDetections& list = detected.at(number);
        for (std::size_t h = 0; h < hands.size(); ++h)
            frame.targets.push_back(list[h] ? landmarkTargets(hands[h], *list[h], true) : std::vector<JointTarget>{});
    }
    if (frames.empty())
        return {};
    SubjectOptions options;
    options.priors.lengthShare = 0.2; // the models are nobody's hands
    options.priors.neighbourShare = 0.2;
    const auto first = estimateSubject(hands, cameras, frames, options, stop).hands;
    std::vector<HandModel> shaped; // the palm, once fingers are about as long as they are
    for (std::size_t h = 0; h < hands.size(); ++h) {
        std::vector<std::vector<JointTarget>> targets;
        for (const SubjectFrame& frame : frames)
            targets.push_back(frame.targets[h]);
        shaped.push_back(withPalmOf(first[h].hand, targets, landmarks));
    }
    auto measured = estimateSubject(shaped, cameras, frames, options, stop).hands;
    for (std::size_t h = 0; h < hands.size(); ++h)
        compareWithModel(measured[h], first[h]);
    return measured;
}

double landmarksOverModelLength(const std::vector<HandModel>& hands, const std::map<int, HandDetections>& detected) {
    std::vector<SubjectFrame> frames;
    for (const auto& [number, list] : detected) {
        SubjectFrame& frame = frames.emplace_back();
        for (std::size_t h = 0; h < hands.size(); ++h)
            frame.targets.push_back(list[h] ? landmarkTargets(hands[h], *list[h]) : std::vector<JointTarget>{});
    }
    return annotatedOverModelLength(hands, frames);
}

std::vector<HandModel> scaledHands(const std::vector<HandModel>& hands, double scale) {
    std::vector<HandModel> scaled;
    for (const HandModel& hand : hands) {
        const ShapeSpace space(hand);
        HandShape shape = space.modelShape();
        shape[0] = std::log(scale);
        scaled.push_back(space.shaped(shape));
    }
    return scaled;
}

std::vector<SubjectHand> measureHands(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                                      const std::vector<MeasuredFrame>& frames, std::stop_token stop) {
    std::vector<SubjectFrame> subjectFrames;
    for (const MeasuredFrame& frame : frames)
        subjectFrames.push_back(subjectFrame(hands, cameras, frame));
    return estimateSubject(hands, cameras, subjectFrames, {}, stop).hands;
}

} // namespace core
