// SPDX-License-Identifier: MIT
#include "core/annotation/annotation_summary.h"

#include <algorithm>

#include "core/annotation/quality_checker.h"

namespace core {

namespace {

RaterSummary summaryOf(const std::string& rater, const AnnotationSet& set, const std::vector<Camera>& cameras,
                       double badRmsPx, const TriangulationOptions& options, const PictureGaps& gaps) {
    RaterSummary summary;
    summary.rater = rater;
    for (const auto& [key, mark] : set.marks)
        if (key.rater == rater && mark.isPlaced())
            (mark.placement == Placement::Manual ? summary.clicks : summary.accepted) += 1;
    for (const int frame : settledFrames(set, rater)) {
        ++summary.frames;
        for (const auto& [hand, coverage] : coverageOf(set, cameras, frame, rater, badRmsPx, options, gaps)) {
            summary.doneByFrame[frame] += coverage.finished();
            summary.joints.done += coverage.done;
            summary.joints.partial += coverage.partial;
            summary.joints.bad += coverage.bad;
            summary.joints.occluded += coverage.occluded;
        }
    }
    return summary;
}

/// Adds the points of one rater to the joints and to the lists of errors.
void addPoints(const SequencePoints& points, std::map<JointId, JointSummary>& joints, AnnotationSummary& summary) {
    for (const auto& [frame, frameJoints] : points) {
        for (const auto& [id, point] : frameJoints) {
            if (point.inlier.empty()) // accepted, not clicked
                continue;
            JointSummary& joint = joints[id];
            joint.joint = id;
            ++joint.points;
            joint.meanRmsPx += point.rmsPx;
            joint.meanSigmaMm += sigmaMm(point.covariance);
            joint.outliers += static_cast<int>(std::count(point.inlier.begin(), point.inlier.end(), false));
            summary.rmsPx.push_back(point.rmsPx);
            summary.sigmaMm.push_back(sigmaMm(point.covariance));
        }
    }
}

} // namespace

AnnotationSummary summariseAnnotations(const std::string& sequence, int frameCount, const AnnotationSet& set,
                                       const std::vector<Camera>& cameras, const std::vector<HandModel>& hands,
                                       double badRmsPx, const QualityOptions& options, std::stop_token stop,
                                       const PictureGaps& gaps, const std::optional<ClickSigmas>& sigmas) {
    AnnotationSummary summary;
    summary.sequence = sequence;
    summary.frameCount = frameCount;
    summary.proposals = static_cast<int>(
        std::count_if(set.marks.begin(), set.marks.end(), [](const auto& item) { return item.second.isProposal(); }));
    std::map<JointId, JointSummary> joints;
    std::map<std::string, SequencePoints> points;
    for (const std::string& rater : ratersOf(set)) {
        const std::vector<int> frames = settledFrames(set, rater);
        if (frames.empty())
            continue;
        QualityOptions ofRater = options;
        if (sigmas)
            ofRater.triangulation = sigmas->optionsFor(rater, options.triangulation);
        QualityChecker checker(cameras, hands, rater, ofRater);
        for (const int frame : frames) {
            if (stop.stop_requested())
                return summary;
            checker.check(set, frame);
        }
        summary.raters.push_back(summaryOf(rater, set, cameras, badRmsPx, ofRater.triangulation, gaps));
        if (sigmas)
            summary.raters.back().sigma = sigmas->of(rater);
        summary.raters.back().findings = checker.findings();
        addPoints(checker.points(), joints, summary);
        points[rater] = checker.points();
    }
    for (auto& [id, joint] : joints) {
        joint.meanRmsPx /= joint.points;
        joint.meanSigmaMm /= joint.points;
        summary.joints.push_back(joint);
    }
    std::stable_sort(summary.joints.begin(), summary.joints.end(),
                     [](const JointSummary& a, const JointSummary& b) { return a.meanSigmaMm > b.meanSigmaMm; });
    summary.agreement = compareAllRaters(set, points);
    return summary;
}

} // namespace core
