// SPDX-License-Identifier: MIT
#include "core/labelling/retracking.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/labelling/landmark_fit.h"
#include "core/labelling/pass_plan.h"
#include "core/subject/calibration_unit.h"
#include "core/subject/hand_tips.h"
#include "core/subject/subject_estimate.h"

namespace core {

namespace {

constexpr double kStepShare = 0.8; ///< of the last step: hands slow down

/// The joints of one hand that are known, in the calibration's unit: the person's, and the labels' where it has none.
std::vector<JointTarget> targetsOf(const HandModel& hand, const CorrectedFrame& corrected) {
    std::vector<JointTarget> targets;
    for (std::size_t b = 0; b < hand.skeleton.bones.size(); ++b) {
        const std::string& name = hand.skeleton.bones[b].name;
        const auto placed = corrected.joints.find(JointId{hand.side, name});
        if (placed != corrected.joints.end()) {
            targets.push_back({static_cast<int>(b), placed->second.pointInWorld, placed->second.covariance});
            continue;
        }
        for (const AutoHand& label : corrected.labels)
            for (const AutoJoint& joint : label.joints)
                if (label.side == hand.side && joint.name == name)
                    targets.push_back({static_cast<int>(b), joint.pointInWorld, joint.covariance});
    }
    return targets;
}

std::vector<JointTarget> inMm(std::vector<JointTarget> targets, double unitMm) {
    for (JointTarget& target : targets) {
        target.pointInWorld *= unitMm;
        target.covariance *= unitMm * unitMm;
    }
    return targets;
}

/// Whether joints that a person has placed are elsewhere in a fit, beyond what clicks and models leave open.
bool contradicts(const FrameFit& fit, const std::vector<HandModel>& hands, const CorrectedFrame& corrected,
                 double unitMm) {
    constexpr double kModelMm = 4, kSigmas = 3;
    for (std::size_t h = 0; h < hands.size(); ++h) {
        if (fit.hands[h].pose.size() == 0)
            continue;
        const auto joints = jointPositions(hands[h].skeleton, fit.hands[h].pose);
        for (std::size_t b = 0; b < joints.size(); ++b) {
            const auto placed = corrected.joints.find(JointId{hands[h].side, hands[h].skeleton.bones[b].name});
            if (placed == corrected.joints.end())
                continue;
            const double sigmaMm = unitMm * std::sqrt(placed->second.covariance.trace());
            if ((joints[b] - unitMm * placed->second.pointInWorld).norm() > kModelMm + kSigmas * sigmaMm)
                return true;
        }
    }
    return false;
}

/// Of the corrected frame, from its joints and then from its silhouettes; the joints alone if these contradict, or if
/// there are too few views of them.
FrameFit correctedFit(const FrameFitter& fitter, const std::vector<std::vector<JointTarget>>& targets,
                      const FrameEvidence& evidence, const CorrectedFrame& corrected, double unitMm, double leastDoubt,
                      const std::stop_token& stop) {
    FrameFit fit;
    fit.source = FitSource::Correction;
    fit.hands.resize(targets.size());
    LandmarkFitOptions options;
    options.modelSigmaMm = 1;
    for (std::size_t h = 0; h < targets.size(); ++h) {
        const HandModel& hand = fitter.hands()[h];
        if (auto found = fitToTargets(hand, targets[h], usualStarts(hand.skeleton), options))
            fit.hands[h] = {std::move(found->pose), std::move(found->jointCovarianceMm2), 0};
    }
    if (fit.isEmpty() || !evidence.showsPoses())
        return fit;
    FrameFit refined = fitter.bySilhouettes(evidence, fit.poses(), 2, FitSource::Correction, stop);
    return refined.doubt() < leastDoubt && !contradicts(refined, fitter.hands(), corrected, unitMm) ? refined : fit;
}

} // namespace

PassResult retrack(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                   const CorrectedFrame& corrected, const std::vector<int>& frames, const std::vector<int>& reviewed,
                   PassSource& source, const PassOptions& options, std::stop_token stop, const PassProgress& progress,
                   const PassSink& sink) {
    PassResult result;
    SubjectFrame known;
    for (const HandModel& hand : hands) {
        result.hands.push_back(withTips(hand));
        known.targets.push_back(targetsOf(result.hands.back(), corrected));
    }
    result.unitMm = unitMmOf(annotatedOverModelLength(result.hands, {known}));
    std::vector<std::vector<JointTarget>> targets;
    for (const auto& list : known.targets)
        targets.push_back(inMm(list, result.unitMm));
    std::vector<Camera> metric = cameras;
    for (Camera& camera : metric)
        camera.cameraFromWorld.translation *= result.unitMm;
    const FrameFitter fitter(result.hands, metric, options.threads);
    const FrameFit start = correctedFit(fitter, targets, source.evidence(corrected.frame), corrected, result.unitMm,
                                        options.leastDoubt, stop);
    if (start.isEmpty() || stop.stop_requested())
        return result;
    int done = 0;
    const auto keep = [&](int frame, const FrameFit& fit) {
        result.fits[frame] = fit;
        if (sink)
            sink(result, frame);
        if (progress)
            progress(PassStage::Tracking, ++done, static_cast<int>(frames.size()));
    };
    keep(corrected.frame, start);
    for (const int direction : {1, -1}) {
        FrameFit last = start;
        HandPoses before;
        int at = corrected.frame;
        while (const auto next = nextFrame(frames, at, direction, options.mostGapFrames)) {
            if (stop.stop_requested() || std::binary_search(reviewed.begin(), reviewed.end(), *next))
                break;
            const FrameEvidence evidence = source.evidence(*next);
            if (!evidence.showsPoses())
                break;
            FrameFit fit = fitter.bySilhouettes(evidence, predictedPoses(last.poses(), before, kStepShare), 1,
                                                FitSource::Tracking, stop);
            if (stop.stop_requested() || fit.doubt() >= options.leastDoubt)
                break;
            keep(*next, fit);
            before = last.poses();
            last = std::move(fit);
            at = *next;
        }
    }
    result.isFinished = !stop.stop_requested();
    return result;
}

} // namespace core
