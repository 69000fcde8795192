// SPDX-License-Identifier: MIT
#include "core/io/derived/measured_subject.h"

#include <algorithm>

#include "core/annotation/reconstruction.h"
#include "core/annotation/sequence_points.h"
#include "core/error.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/dataset/dataset_rig.h"
#include "core/io/dataset/frames.h"
#include "core/subject/calibration_unit.h"
#include "core/subject/hand_tips.h"

namespace core {

namespace {

/// How far people's and detectors' tips are from a model's, mm per axis.
constexpr double kTipSigmaMm = 2;
/// Boundary pixels lie 0.5 px inside an upright outline and 0.35 px inside a diagonal one.
constexpr double kOutlineOffsetPx = 0.45;

struct AnnotatedFrame {
    SubjectFrameName name;
    JointPoints points;
};

/// The rater with most joints in 3D.
std::string busiestRater(const AnnotationSet& set, const std::vector<Camera>& cameras, const ClickSigmas& sigmas) {
    std::string busiest;
    std::size_t most = 0;
    for (const std::string& rater : ratersOf(set)) {
        std::size_t count = 0;
        for (const auto& [frame, points] : sequencePoints(set, cameras, rater, sigmas.optionsFor(rater)))
            count += points.size();
        if (count > most) {
            most = count;
            busiest = rater;
        }
    }
    return busiest;
}

/// The share of the hand in the variance of a click, the rest being the calibration's.
double handShareOf(const TriangulationOptions& options) {
    const double hand = options.sigmaPx * options.sigmaPx;
    return hand / (hand + options.systematicPx * options.systematicPx);
}

/// Everything annotated in a sequence, with covariances of clicks as they scatter. What the calibration adds moves
/// neighbouring joints alike: it is left out, and what of it bends a hand is found with `SubjectResult::modelSigmaMm`.
std::vector<AnnotatedFrame> annotatedFramesOf(const Dataset& dataset, const Sequence& sequence,
                                              const std::string& wantedRater, const ClickSigmas& sigmas) {
    std::vector<AnnotatedFrame> frames;
    const AnnotationSet set = readAnnotations(dataset, sequence);
    const std::string rater = wantedRater.empty() ? busiestRater(set, dataset.cameras, sigmas) : wantedRater;
    const TriangulationOptions options = sigmas.optionsFor(rater);
    for (auto& [frame, points] : sequencePoints(set, dataset.cameras, rater, options)) {
        for (auto& [joint, point] : points)
            point.covariance *= handShareOf(options);
        frames.push_back({{sequence.name, frame}, std::move(points)});
    }
    return frames;
}

std::vector<AnnotatedFrame> annotatedFramesOf(const Dataset& dataset, const SubjectRequest& request) {
    std::vector<AnnotatedFrame> frames;
    const ClickSigmas sigmas = datasetClickSigmas(dataset);
    for (const std::string& name : request.sequences)
        for (AnnotatedFrame& frame : annotatedFramesOf(dataset, dataset.sequence(name), request.rater, sigmas))
            frames.push_back(std::move(frame));
    return frames;
}

SubjectFrame subjectFrame(const Dataset& dataset, const AnnotatedFrame& annotated) {
    SubjectFrame frame;
    for (const HandModel& hand : dataset.hands) {
        auto& targets = frame.targets.emplace_back();
        for (const auto& [id, point] : annotated.points) {
            const int bone = hand.skeleton.boneIndex(id.joint);
            if (id.hand != hand.side || bone < 0)
                continue;
            targets.push_back({bone, point.pointInWorld, point.covariance});
            if (id.joint.ends_with("_tip"))
                targets.back().covariance += kTipSigmaMm * kTipSigmaMm * Eigen::Matrix3d::Identity();
        }
    }
    return frame;
}

bool isUseful(const SubjectFrame& frame) {
    return std::any_of(
        frame.targets.begin(), frame.targets.end(),
        [](const auto& targets) { return static_cast<int>(targets.size()) >= kFewestSubjectJoints; });
}

/// Those that can measure a hand, at most so many, evenly drawn; masks are read for these only.
std::vector<SubjectFrame> chosenFrames(std::vector<AnnotatedFrame> useful, const SubjectRequest& request,
                                       MeasuredSubject& measured, const SubjectProgress& progress,
                                       const std::stop_token& stop) {
    const Dataset& dataset = measured.dataset;
    std::erase_if(useful, [&](const AnnotatedFrame& annotated) { return !isUseful(subjectFrame(dataset, annotated)); });
    measured.annotatedFrames = static_cast<int>(useful.size());
    const std::size_t count = std::min(useful.size(), static_cast<std::size_t>(std::max(0, request.mostFrames)));
    std::vector<SubjectFrame> frames;
    for (std::size_t i = 0; i < count && !stop.stop_requested(); ++i) {
        if (progress)
            progress(SubjectStage::ReadingMasks, static_cast<double>(i) / static_cast<double>(count));
        const AnnotatedFrame& annotated = useful[i * useful.size() / count];
        frames.push_back(subjectFrame(dataset, annotated));
        measured.frames.push_back(annotated.name);
        const Sequence& sequence = dataset.sequence(annotated.name.sequence);
        if (!request.withoutMasks && hasMasks(sequence)) {
            const auto masks = readFrameMasks(dataset.folder, sequence, dataset.cameras, annotated.name.frame);
            FitTargetOptions options;
            options.contour.offsetPx = kOutlineOffsetPx;
            frames.back().outlines = makeFitTargets(dataset.cameras, masks, options, 1);
        }
    }
    return frames;
}

/// Brings the cameras to mm if the hands say that they are not. True if it changed them.
bool makeMetric(MeasuredSubject& measured, const std::vector<AnnotatedFrame>& annotatedFrames) {
    std::vector<SubjectFrame> frames;
    for (const AnnotatedFrame& annotated : annotatedFrames)
        frames.push_back(subjectFrame(measured.dataset, annotated));
    measured.unitMm = unitMmOf(annotatedOverModelLength(measured.dataset.hands, frames));
    measured.isUnitKnown = isUsualUnit(measured.unitMm);
    if (measured.unitMm == 1)
        return false;
    for (Camera& camera : measured.dataset.cameras)
        camera.cameraFromWorld.translation *= measured.unitMm;
    return true;
}

/// Gives the models bones for tips if there are annotated ones.
void addAnnotatedTips(std::vector<HandModel>& hands, const std::vector<AnnotatedFrame>& frames) {
    const bool hasTips = std::any_of(frames.begin(), frames.end(), [](const AnnotatedFrame& frame) {
        return std::any_of(frame.points.begin(), frame.points.end(),
                           [](const auto& point) { return point.first.joint.ends_with("_tip"); });
    });
    for (HandModel& hand : hands)
        hand = hasTips ? withTips(hand) : hand;
}

} // namespace

MeasuredSubject measureSubject(const Dataset& original, const SubjectRequest& request, const SubjectProgress& progress,
                               std::stop_token stop) {
    const std::string name = original.folder.string();
    if (original.hands.empty())
        throw Error(ErrorCode::BadInput, name + "/dataset.json", "hands", "there is no hand model to start from");
    MeasuredSubject measured;
    measured.dataset = original;
    if (progress)
        progress(SubjectStage::ReadingAnnotations, -1);
    std::vector<AnnotatedFrame> annotated = annotatedFramesOf(measured.dataset, request);
    addAnnotatedTips(measured.dataset.hands, annotated);
    measured.rigHealth = judgeRig(original.cameras, readRigJoints(original));
    if (makeMetric(measured, annotated))
        annotated = annotatedFramesOf(measured.dataset, request);
    const std::vector<SubjectFrame> frames = chosenFrames(std::move(annotated), request, measured, progress, stop);
    if (progress)
        progress(SubjectStage::Measuring, -1);
    if (stop.stop_requested()) {
        measured.result.stopped = true;
        return measured;
    }
    try {
        measured.result = estimateSubject(measured.dataset.hands, measured.dataset.cameras, frames, {}, stop);
    } catch (const Error& error) {
        throw Error(error.code(), name, error.field(), error.detail());
    }
    for (std::size_t h = 0; h < measured.result.hands.size(); ++h) {
        HandModel& hand = measured.result.hands[h].hand;
        hand = withoutTips(hand, original.hands[h]);
        measured.dataset.hands[h] = hand;
    }
    return measured;
}

int countSubjectFrames(const Dataset& dataset, const Sequence& sequence, const std::string& rater) {
    const auto frames = annotatedFramesOf(dataset, sequence, rater, {}); // how many does not depend on sigmas
    return static_cast<int>(std::count_if(frames.begin(), frames.end(), [&](const AnnotatedFrame& annotated) {
        return isUseful(subjectFrame(dataset, annotated));
    }));
}

} // namespace core
