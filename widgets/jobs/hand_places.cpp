// SPDX-License-Identifier: MIT
#include "widgets/jobs/hand_places.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <opencv2/imgproc.hpp>

#include "core/annotation/reconstruction.h"
#include "core/io/dataset/frames.h"

namespace widgets {

namespace {

constexpr double kAroundHandMm = 35;    // flesh around the joints, and the tips beyond the last ones
constexpr double kAroundFewMm = 110;    // the rest of a hand of which little is known
constexpr std::size_t kMostOfAHand = 8; // joints
constexpr double kAroundMarks = 0.12;   // of the image's longer side
constexpr int kFramesTried = 12;

void include(QRectF& box, const QPointF& px, double reachPx) {
    const QRectF around(px.x() - reachPx, px.y() - reachPx, 2 * reachPx, 2 * reachPx);
    box = box.isNull() ? around : box.united(around);
}

/// Frames with marks, the nearest one first.
std::vector<int> framesFrom(const core::AnnotationSet& set, int frame) {
    std::vector<int> frames = core::annotatedFrames(set);
    std::stable_sort(frames.begin(), frames.end(),
                     [frame](int a, int b) { return std::abs(a - frame) < std::abs(b - frame); });
    return frames;
}

/// 3D joints of one frame, per hand, whoever marked them.
std::vector<HandPlace> handsOfFrame(const core::AnnotationSet& set, const std::vector<core::Camera>& cameras,
                                    int frame) {
    std::vector<HandPlace> hands{{core::Side::Left, {}, false}, {core::Side::Right, {}, false}};
    core::ReconstructionOptions options;
    options.details = false;
    for (const std::string& rater : core::ratersOf(set, frame)) {
        for (const auto& [joint, found] : core::reconstructFrame(set, cameras, frame, rater, options)) {
            auto& points = hands[joint.hand == core::Side::Left ? 0 : 1].pointsInWorld;
            if (found.hasPoint())
                points.push_back(found.result.point->pointInWorld);
            else if (found.proposal)
                points.push_back(*found.proposal);
        }
    }
    return hands;
}

} // namespace

std::vector<HandPlace> handsInPose(const std::vector<core::HandModel>& hands, const core::HandPoses& poses) {
    std::vector<HandPlace> places;
    for (std::size_t i = 0; i < hands.size() && i < poses.size(); ++i)
        if (poses[i].size() > 0)
            places.push_back({hands[i].side, core::jointPositions(hands[i].skeleton, poses[i]), true});
    return places;
}

std::vector<HandPlace> handsOfMarks(const core::AnnotationSet& set, const std::vector<core::Camera>& cameras,
                                    int frame) {
    std::vector<HandPlace> places{{core::Side::Left, {}, false}, {core::Side::Right, {}, false}};
    int tried = 0;
    for (const int at : framesFrom(set, frame)) {
        const auto found = handsOfFrame(set, cameras, at);
        for (std::size_t i = 0; i < places.size(); ++i)
            if (places[i].pointsInWorld.empty())
                places[i] = found[i];
        const bool bothKnown = !places[0].pointsInWorld.empty() && !places[1].pointsInWorld.empty();
        if (bothKnown || ++tried == kFramesTried)
            break;
    }
    std::erase_if(places, [](const HandPlace& place) { return place.pointsInWorld.empty(); });
    return places;
}

std::optional<QRectF> withinImage(const core::Camera& camera, const QRectF& box) {
    const QRectF seen = box.intersected(QRectF(-0.5, -0.5, camera.size.width, camera.size.height));
    return seen.width() > 1 && seen.height() > 1 ? std::optional(seen) : std::nullopt;
}

std::optional<QRectF> handsInView(const core::Camera& camera, const std::vector<HandPlace>& hands) {
    QRectF all;
    for (const HandPlace& hand : hands) {
        const double aroundMm = hand.pointsInWorld.size() >= kMostOfAHand ? kAroundHandMm : kAroundFewMm;
        QRectF box;
        bool isSeen = false;
        for (const Eigen::Vector3d& point : hand.pointsInWorld) {
            const auto px = core::project(camera, point);
            if (!px)
                continue;
            const double depthMm = (camera.cameraFromWorld.rotation * point + camera.cameraFromWorld.translation).z();
            include(box, {px->x(), px->y()}, aroundMm * std::abs(camera.intrinsics(0, 0)) / depthMm);
            isSeen = isSeen || core::isInside(camera.size, *px);
        }
        if (const auto seen = isSeen ? withinImage(camera, box) : std::nullopt)
            all = all.isNull() ? *seen : all.united(*seen);
    }
    return all.isNull() ? std::nullopt : std::optional(all);
}

std::optional<QRectF> marksInView(const core::Camera& camera, const core::AnnotationSet& set, int frame) {
    const double reach = kAroundMarks * std::max(camera.size.width, camera.size.height);
    for (const int at : framesFrom(set, frame)) {
        QRectF box;
        for (const auto& [key, mark] : core::marksOfFrame(set, at))
            if (key.camera == camera.name && mark.hasPlace())
                include(box, {mark.px.x(), mark.px.y()}, reach);
        if (!box.isNull())
            return withinImage(camera, box);
    }
    return std::nullopt;
}

std::vector<QRectF> handsOfMasks(const core::Dataset& dataset, const core::Sequence& sequence, int frame) {
    std::vector<QRectF> boxes;
    for (const cv::Mat& mask : core::readFrameMasks(dataset.folder, sequence, dataset.cameras, frame)) {
        const cv::Rect box = mask.empty() ? cv::Rect() : cv::boundingRect(mask);
        boxes.emplace_back(box.empty() ? QRectF() : QRectF(box.x - 0.5, box.y - 0.5, box.width, box.height));
    }
    return boxes;
}

} // namespace widgets
