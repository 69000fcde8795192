// SPDX-License-Identifier: MIT
#include "core/labelling/retracking.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/annotation/reconstruction.h"
#include "core/labelling/landmark_fit.h"
#include "core/labelling/pass_plan.h"
#include "core/subject/calibration_unit.h"
#include "core/subject/hand_tips.h"
#include "core/subject/subject_estimate.h"

namespace core {

namespace {

constexpr double kStepShare = 0.8; ///< of the last step: hands slow down

constexpr double kGuessSigmaMm = 3;        ///< of a joint that the person has left as a program has it
constexpr double kWrongFingerSigmaMm = 15; ///< of one on a finger that the person has corrected
constexpr double kModelSigmaMm = 1;        ///< how far the measured hand's joints are from the person's
constexpr double kSameDoubt = 0.1;         ///< doubts that are so near say nothing of which fit is better

/// What is known of a hand's joints, mm: those that the person has placed, and those that programs have.
struct HandTargets {
    std::vector<JointTarget> placed, guessed;
};

/// The finger that a bone belongs to: the child of the root that it hangs on; 0 for the root.
int fingerOf(const Skeleton& skeleton, int bone) {
    while (bone > 0 && skeleton.bones[static_cast<std::size_t>(bone)].parent > 0)
        bone = skeleton.bones[static_cast<std::size_t>(bone)].parent;
    return bone;
}

HandTargets targetsOf(const HandModel& hand, const CorrectedFrame& corrected) {
    HandTargets targets;
    for (std::size_t b = 0; b < hand.skeleton.bones.size(); ++b) {
        const JointId id{hand.side, hand.skeleton.bones[b].name};
        const auto placed = corrected.joints.find(id);
        const auto guess = corrected.guesses.find(id);
        if (placed != corrected.joints.end())
            targets.placed.push_back({static_cast<int>(b), placed->second.pointInWorld, placed->second.covariance});
        else if (guess != corrected.guesses.end())
            targets.guessed.push_back({static_cast<int>(b), guess->second, Eigen::Matrix3d::Zero()});
    }
    return targets;
}

/// All of them, those that were placed first.
std::vector<JointTarget> joined(const HandTargets& targets) {
    std::vector<JointTarget> all = targets.placed;
    all.insert(all.end(), targets.guessed.begin(), targets.guessed.end());
    return all;
}

/// In mm, and as certain as they are: a guess on a finger with a placed joint says little.
HandTargets inMm(HandTargets targets, const Skeleton& skeleton, double unitMm) {
    for (JointTarget& target : targets.placed) {
        target.pointInWorld *= unitMm;
        target.covariance *= unitMm * unitMm;
    }
    for (JointTarget& target : targets.guessed) {
        const int finger = fingerOf(skeleton, target.bone);
        const bool isWrong =
            finger > 0 && std::any_of(targets.placed.begin(), targets.placed.end(),
                                      [&](const auto& one) { return fingerOf(skeleton, one.bone) == finger; });
        const double sigmaMm = isWrong ? kWrongFingerSigmaMm : kGuessSigmaMm;
        target.pointInWorld *= unitMm;
        target.covariance = sigmaMm * sigmaMm * Eigen::Matrix3d::Identity();
    }
    return targets;
}

/// Whether joints that a person has placed are elsewhere in a fit, beyond what clicks and models leave open.
bool contradicts(const FrameFit& fit, const std::vector<HandModel>& hands, const KnownJoints& placed) {
    constexpr double kModelMm = 4, kSigmas = 3;
    for (std::size_t h = 0; h < hands.size(); ++h) {
        if (fit.hands[h].pose.size() == 0)
            continue;
        const auto joints = jointPositions(hands[h].skeleton, fit.hands[h].pose);
        for (const JointTarget& target : placed[h])
            if ((joints[static_cast<std::size_t>(target.bone)] - target.pointInWorld).norm() >
                kModelMm + kSigmas * std::sqrt(target.covariance.trace()))
                return true;
    }
    return false;
}

double doubtBefore(const CorrectedFrame& corrected, int frame) {
    const auto found = corrected.doubts.find(frame);
    return found == corrected.doubts.end() ? 1 : found->second;
}

/// Of the corrected frame, from its joints and then from its silhouettes; the joints alone if these contradict or are
/// in doubt, or if there are too few views of them; then its doubt is `doubtByJoints`.
FrameFit correctedFit(const FrameFitter& fitter, const std::vector<HandTargets>& targets, const FrameEvidence& evidence,
                      double doubtByJoints, double mostDoubt, const std::stop_token& stop) {
    FrameFit fit;
    fit.source = FitSource::Correction;
    fit.hands.resize(targets.size());
    KnownJoints placed;
    for (std::size_t h = 0; h < targets.size(); ++h) {
        const HandModel& hand = fitter.hands()[h];
        LandmarkFitOptions options;
        options.modelSigmaMm = kModelSigmaMm;
        options.certain = targets[h].placed.size();
        placed.push_back(targets[h].placed);
        if (auto found = fitToTargets(hand, joined(targets[h]), usualStarts(hand.skeleton), options))
            fit.hands[h] = {std::move(found->pose), std::move(found->jointCovarianceMm2), doubtByJoints};
    }
    if (fit.isEmpty() || !evidence.showsPoses())
        return fit;
    FrameFit refined = fitter.bySilhouettes(evidence, fit.poses(), 2, FitSource::Correction, stop, placed);
    return refined.doubt() < mostDoubt && !contradicts(refined, fitter.hands(), placed) ? refined : fit;
}

/// The poses of joints of about that certainty; empty poses: hands that are not among them.
HandPoses posesOf(const FrameFitter& fitter, const std::map<JointId, Eigen::Vector3d>& joints, double unitMm) {
    CorrectedFrame labelled;
    labelled.guesses = joints;
    LandmarkFitOptions options;
    options.modelSigmaMm = kModelSigmaMm;
    HandPoses poses;
    for (const HandModel& hand : fitter.hands()) {
        const auto targets = joined(inMm(targetsOf(hand, labelled), hand.skeleton, unitMm));
        const auto fit = fitToTargets(hand, targets, usualStarts(hand.skeleton), options);
        poses.push_back(fit ? fit->pose : Pose());
    }
    return poses;
}

/// From which doubt on a fit says less than the label that is there.
double mostDoubtAt(int frame, const CorrectedFrame& corrected, const PassOptions& options) {
    return std::max(options.leastDoubt, doubtBefore(corrected, frame) + kSameDoubt);
}

/// What the frames around a corrected one are followed with.
struct Following {
    const FrameFitter& fitter;
    const CorrectedFrame& corrected;
    const PassOptions& options;
    double unitMm;
    const std::stop_token& stop;
};

/// Whether the label of a frame explains its silhouettes better than a fit of as many hands: where both are in doubt,
/// their doubts do not tell which is right.
bool isLabelBetter(const Following& following, int frame, const FrameEvidence& evidence, const FrameFit& fit) {
    if (!following.corrected.labelsAt)
        return false;
    const HandPoses poses = posesOf(following.fitter, following.corrected.labelsAt(frame), following.unitMm);
    for (std::size_t h = 0; h < poses.size(); ++h)
        if ((poses[h].size() > 0) != (fit.hands[h].pose.size() > 0))
            return false;
    return following.fitter.bySilhouettes(evidence, poses, 1, FitSource::Tracking, following.stop).overlap >
           fit.overlap;
}

/// The hands of a frame from where they were in its neighbour; none where its label is better left as it is.
std::optional<FrameFit> followingFit(const Following& following, int frame, const FrameEvidence& evidence,
                                     const HandPoses& start) {
    FrameFit fit = following.fitter.bySilhouettes(evidence, start, 1, FitSource::Tracking, following.stop);
    if (following.stop.stop_requested() || fit.doubt() >= mostDoubtAt(frame, following.corrected, following.options) ||
        (fit.doubt() >= following.options.leastDoubt && isLabelBetter(following, frame, evidence, fit)))
        return std::nullopt;
    return fit;
}

} // namespace

CorrectedFrame correctedFrame(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
                              const std::string& rater, const std::vector<Camera>& fitted) {
    CorrectedFrame corrected;
    corrected.frame = frame;
    for (auto& [id, joint] : reconstructFrame(set, cameras, frame, rater, {{}, false, std::nullopt}))
        if (joint.hasPoint() && !joint.isAccepted)
            corrected.joints.emplace(id, *joint.result.point);
        else if (joint.hasPoint())
            corrected.guesses.emplace(id, joint.result.point->pointInWorld);
        else if (joint.proposal && joint.manualViews == 0)
            corrected.guesses.emplace(id, *joint.proposal);
    if (!fitted.empty())
        for (auto& [id, joint] : reconstructFrame(set, fitted, frame, rater, {{}, false, std::nullopt}))
            if (corrected.joints.contains(id) && joint.hasPoint())
                corrected.joints[id] = *joint.result.point;
    for (const auto& [key, mark] : set.marks)
        if (key.rater == rater && (mark.isProposal() || mark.isAcceptedGuess())) {
            double& doubt = corrected.doubts.try_emplace(key.frame, 0).first->second;
            doubt = std::max(doubt, 1 - mark.likelihood.value_or(0));
        }
    corrected.labelsAt = [&set, cameras, rater](int other) {
        std::map<JointId, Eigen::Vector3d> labels;
        for (const auto& [id, joint] : reconstructFrame(set, cameras, other, rater, {{}, false, std::nullopt}))
            if (joint.hasPoint())
                labels.emplace(id, joint.result.point->pointInWorld);
            else if (joint.proposal)
                labels.emplace(id, *joint.proposal);
        return labels;
    };
    return corrected;
}

PassResult retrack(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                   const CorrectedFrame& corrected, const std::vector<int>& frames, const std::vector<int>& reviewed,
                   PassSource& source, const PassOptions& options, std::stop_token stop, const PassProgress& progress,
                   const PassSink& sink) {
    PassResult result;
    SubjectFrame known;
    std::vector<HandTargets> targets;
    for (const HandModel& hand : hands) {
        result.hands.push_back(withTips(hand));
        targets.push_back(targetsOf(result.hands.back(), corrected));
        known.targets.push_back(joined(targets.back()));
    }
    result.unitMm = unitMmOf(annotatedOverModelLength(result.hands, {known}));
    for (std::size_t h = 0; h < targets.size(); ++h)
        targets[h] = inMm(targets[h], result.hands[h].skeleton, result.unitMm);
    std::vector<Camera> metric = cameras;
    for (Camera& camera : metric)
        camera.cameraFromWorld.translation *= result.unitMm;
    const FrameFitter fitter(result.hands, metric, options.threads);
    const double doubtByJoints =
        corrected.doubts.contains(corrected.frame) ? doubtBefore(corrected, corrected.frame) : 0;
    const FrameFit start = correctedFit(fitter, targets, source.evidence(corrected.frame), doubtByJoints,
                                        mostDoubtAt(corrected.frame, corrected, options), stop);
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
            auto fit = followingFit({fitter, corrected, options, result.unitMm, stop}, *next, evidence,
                                    predictedPoses(last.poses(), before, kStepShare));
            if (!fit)
                break;
            keep(*next, *fit);
            before = last.poses();
            last = std::move(*fit);
            at = *next;
        }
    }
    result.isFinished = !stop.stop_requested();
    return result;
}

} // namespace core
