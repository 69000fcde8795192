// SPDX-License-Identifier: MIT
#include "core/labelling/outline_rig.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/segmentation/model_seeds.h"

namespace core {

namespace {

constexpr double kOutlineReachPx = 20; ///< how far beside each other outlines are compared
constexpr double kOutlineRobustPx = 3; ///< distances beyond count ever less (Cauchy)
constexpr std::size_t kFewestOutlinePoints = 60;
constexpr int kShiftRounds = 12;
constexpr double kWorthwhileShiftPx = 2; ///< root mean square of the shifts
constexpr std::size_t kFewestRigFrames = 3;

using Outline = std::vector<cv::Point>;

/// The models' outline in a window, without what an arm may cover.
Outline freeOutline(const ModelInView& view) {
    std::vector<Outline> lines;
    cv::findContours(view.model.clone(), lines, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
    cv::Mat nearArm;
    cv::distanceTransform(255 - view.arms, nearArm, cv::DIST_L2, 3);
    const bool hasArms = cv::countNonZero(view.arms) > 0;
    Outline free;
    for (const Outline& line : lines)
        for (const cv::Point& at : line)
            if (!hasArms || nearArm.at<float>(at) > view.bandPx)
                free.push_back(at);
    return free;
}

} // namespace

std::optional<Eigen::Vector2d> outlineShift(const Camera& camera, const std::vector<HandModel>& hands,
                                            const HandPoses& poses, const cv::Mat& mask) {
    if (mask.empty())
        return std::nullopt;
    const ModelInView view = modelInView(camera, hands, poses, {18, 18});
    if (view.window.empty())
        return std::nullopt;
    const Outline points = freeOutline(view);
    const cv::Mat seen = signedDistance(mask(view.window), cv::DIST_MASK_PRECISE);
    const cv::Mat drawn = signedDistance(view.model, cv::DIST_MASK_PRECISE);
    cv::Mat gradientX, gradientY;
    cv::Sobel(drawn, gradientX, CV_32F, 1, 0, 3, 1.0 / 8);
    cv::Sobel(drawn, gradientY, CV_32F, 0, 1, 3, 1.0 / 8);
    const cv::Rect inside(0, 0, seen.cols, seen.rows);
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();
    for (int round = 0; round < kShiftRounds; ++round) {
        Eigen::Matrix2d hessian = Eigen::Matrix2d::Identity() * 1e-6;
        Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
        std::size_t used = 0;
        for (const cv::Point& point : points) {
            const cv::Point at(point.x + cvRound(shift.x()), point.y + cvRound(shift.y()));
            if (!inside.contains(at))
                continue;
            // Inward of the drawn outline, so that neighbouring outlines of the observed one do not turn it around.
            const Eigen::Vector2d slope(gradientX.at<float>(point), gradientY.at<float>(point));
            const Eigen::Vector2d normal = slope.normalized();
            const Eigen::Vector2d rest = shift - Eigen::Vector2d(cvRound(shift.x()), cvRound(shift.y()));
            const double distance = static_cast<double>(seen.at<float>(at)) -
                                    static_cast<double>(drawn.at<float>(point)) + normal.dot(rest);
            if (slope.norm() < 0.5 || std::abs(distance) > kOutlineReachPx)
                continue;
            const double weight = 1 / (1 + distance * distance / (kOutlineRobustPx * kOutlineRobustPx));
            hessian += weight * normal * normal.transpose();
            gradient += weight * distance * normal;
            ++used;
        }
        if (used < kFewestOutlinePoints)
            return std::nullopt;
        const Eigen::Vector2d step = -hessian.inverse() * gradient;
        shift += step;
        if (shift.norm() > kOutlineReachPx)
            return std::nullopt;
        if (step.norm() < 0.01)
            break;
    }
    return shift;
}

std::optional<AdjustedCameras> camerasByOutlines(const std::vector<Camera>& cameras,
                                                 const std::vector<HandModel>& hands,
                                                 const std::vector<MeasuredFrame>& frames, std::stop_token stop) {
    std::vector<RigJoint> joints;
    double squares = 0;
    int shifts = 0;
    for (std::size_t f = 0; f < frames.size() && !stop.stop_requested(); ++f) {
        std::vector<std::optional<Eigen::Vector2d>> beside;
        for (std::size_t c = 0; c < cameras.size(); ++c) {
            beside.push_back(outlineShift(cameras[c], hands, frames[f].poses, frames[f].masks[c]));
            if (beside.back()) {
                squares += beside.back()->squaredNorm();
                ++shifts;
            }
        }
        for (std::size_t h = 0; h < hands.size(); ++h) {
            if (frames[f].poses[h].size() == 0)
                continue;
            const auto points = jointPositions(hands[h].skeleton, frames[f].poses[h]);
            for (std::size_t b = 0; b < points.size(); ++b) {
                RigJoint joint{0, static_cast<int>(f), {}, {hands[h].side, hands[h].skeleton.bones[b].name}, {}};
                for (std::size_t c = 0; c < cameras.size(); ++c)
                    if (const auto px = beside[c] ? project(cameras[c], points[b]) : std::nullopt)
                        joint.clicks.push_back({static_cast<int>(c), *px + *beside[c]});
                if (joint.clicks.size() >= 2)
                    joints.push_back(std::move(joint));
            }
        }
    }
    if (frames.size() < kFewestRigFrames || shifts == 0 || squares < shifts * kWorthwhileShiftPx * kWorthwhileShiftPx)
        return std::nullopt;
    RigRefinementOptions options;
    options.focalShare = 1e-5; // the shift of a picture tells of its direction
    options.distortion = 1e-5;
    auto refined = refineRig(cameras, joints, options, stop);
    if (!refined)
        return std::nullopt;
    return AdjustedCameras{std::move(refined->cameras), std::sqrt(squares / shifts)};
}

} // namespace core
