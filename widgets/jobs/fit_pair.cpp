// SPDX-License-Identifier: MIT
#include "widgets/jobs/fit_pair.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <opencv2/imgproc.hpp>

#include "core/annotation/sequence_points.h"
#include "core/contour/rasteriser.h"
#include "core/io/dataset/frames.h"
#include "widgets/jobs/hand_model_fit.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

/// Where a mask's silhouette lies, with some room around it.
QRectF roomyBounds(const cv::Mat& mask) {
    constexpr double kRoom = 0.25; // of the longer side
    const cv::Rect box = mask.empty() ? cv::Rect() : cv::boundingRect(mask);
    if (box.empty())
        return {};
    const double room = kRoom * std::max(box.width, box.height);
    return QRectF(box.x, box.y, box.width, box.height).adjusted(-room, -room, room, room);
}

/// Empty if they are too few for every hand.
std::optional<core::HandPoses> posesFromMarks(const FitSource& source, int frame) {
    core::JointPoints points;
    for (auto& [joint, found] : core::reconstructFrame(source.annotations, source.dataset->cameras, frame, source.rater,
                                                       {source.sigmas.optionsFor(source.rater), false, std::nullopt}))
        if (found.hasPoint())
            points.emplace(joint, *found.result.point);
    const auto fit = fitModelToPoints(*source.dataset, frame, points);
    const bool whole = fit && std::all_of(fit->poses.begin(), fit->poses.end(),
                                          [](const core::Pose& pose) { return pose.size() > 0; });
    return whole ? std::optional(fit->poses) : std::nullopt;
}

/// One per camera. Empty if there is no mask file of the frame.
std::vector<cv::Mat> targetMasks(const FitSource& source, const FitRequest& request, const core::HandPoses& truePoses) {
    const core::Dataset& dataset = *source.dataset;
    std::vector<cv::Mat> masks;
    if (request.target == FitTarget::Masks) {
        masks = core::readFrameMasks(dataset.folder, source.sequence, dataset.cameras, request.test);
        if (std::all_of(masks.begin(), masks.end(), [](const cv::Mat& mask) { return mask.empty(); }))
            masks.clear();
        return masks;
    }
    for (const core::Camera& camera : dataset.cameras)
        masks.push_back(core::renderHandsMask(camera, dataset.hands, truePoses));
    return masks;
}

} // namespace

QString fitRefusalText(FitRefusal refusal) {
    constexpr LocalText text{"widgets::FitPair"};
    switch (refusal) {
    case FitRefusal::NoStartPose:
        return text(QT_TRANSLATE_NOOP(
            "widgets::FitPair",
            "This sequence has no recorded motion: mark some joints of every hand in the start frame, "
            "and the fit starts from the hand model fitted to them."));
    case FitRefusal::NoTestMasks:
        return text(QT_TRANSLATE_NOOP("widgets::FitPair", "There is no mask file of the test frame."));
    }
    return {};
}

std::variant<FitPair, FitRefusal> prepareFitPair(const FitSource& source, const FitRequest& request) {
    const core::Dataset& dataset = *source.dataset;
    const bool recorded = !source.motion->empty();
    FitPair pair;
    const auto start = recorded ? std::optional((*source.motion)[static_cast<std::size_t>(request.start)])
                                : posesFromMarks(source, request.start);
    if (!start)
        return FitRefusal::NoStartPose;
    pair.startPoses = *start;
    if (recorded)
        pair.truePoses = (*source.motion)[static_cast<std::size_t>(request.test)];
    pair.masks = targetMasks(source, request, pair.truePoses);
    if (pair.masks.empty())
        return FitRefusal::NoTestMasks;
    for (std::size_t camera = 0; camera < pair.masks.size(); ++camera) {
        const cv::Mat& mask = pair.masks[camera];
        // Mask files may show arms, and more: the models say where the hands are.
        QRectF hands;
        if (request.target == FitTarget::Masks && !mask.empty())
            hands = roomyBounds(core::renderHandsMask(dataset.cameras[camera], dataset.hands,
                                                      recorded ? pair.truePoses : pair.startPoses));
        pair.handsPx.push_back(hands.isEmpty() ? roomyBounds(mask) : hands);
        pair.outlinesPx.push_back(request.target == FitTarget::Masks ? outlinesOf(mask) : std::vector<QLineF>{});
    }
    if (request.target == FitTarget::Masks) // the realistic setup: against annotated joints
        pair.reference = core::meanJointPoints(source.annotations, dataset.cameras, request.test, source.sigmas);
    if (recorded && pair.reference.empty())
        pair.reference = core::namedJointPositions(dataset.hands, pair.truePoses);
    pair.initialErrorMm = errorAgainst(pair, dataset, pair.startPoses);
    pair.trueErrorMm =
        recorded ? errorAgainst(pair, dataset, pair.truePoses) : std::numeric_limits<double>::quiet_NaN();
    return pair;
}

/// Outer ones, and holes.
std::vector<QLineF> outlinesOf(const cv::Mat& mask) {
    std::vector<QLineF> lines;
    if (mask.empty())
        return lines;
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(mask, contours, cv::RETR_CCOMP, cv::CHAIN_APPROX_TC89_KCOS);
    for (const std::vector<cv::Point>& contour : contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const cv::Point& a = contour[i];
            const cv::Point& b = contour[(i + 1) % contour.size()];
            lines.emplace_back(a.x, a.y, b.x, b.y);
        }
    }
    return lines;
}

double errorAgainst(const FitPair& pair, const core::Dataset& dataset, const core::HandPoses& poses) {
    return core::jointErrors(core::jointNames(dataset.hands), core::namedJointPositions(dataset.hands, poses),
                             pair.reference)
        .meanMm;
}

} // namespace widgets
