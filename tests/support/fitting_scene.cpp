// SPDX-License-Identifier: MIT
#include "tests/support/fitting_scene.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "core/contour/forearm.h"
#include "core/contour/rasteriser.h"

namespace test {

void speckle(std::vector<cv::Mat>& masks) {
    for (cv::Mat& mask : masks) {
        mask = mask.clone();
        for (int k = 0; k < 24; ++k) {
            const int y = 40 + (k * 37) % (mask.rows - 80);
            for (int tries = 0, x = 30 + (k * 211) % (mask.cols - 60); tries < mask.cols; ++tries) {
                cv::Mat around = mask(cv::Rect(x - 8, y - 8, 17, 17));
                const int lit = cv::countNonZero(around);
                if (lit == (k % 2 == 0 ? 0 : 17 * 17)) {
                    around(cv::Rect(5, 5, 6, 6)).setTo(k % 2 == 0 ? 255 : 0);
                    break;
                }
                x = 30 + (x - 30 + 7) % (mask.cols - 60);
            }
        }
    }
}

FittingScene::FittingScene(std::string_view seed, int cameraCount, bool withLens) {
    for (const core::Camera& camera : cameraRing(cameraCount, withLens))
        cameras.push_back(core::cropped(camera, {0, 0}, {540, 960}, 0.5));
    RandomValues random(seed);
    for (const core::HandModel& hand : hands) {
        truth.push_back(somePose(hand.skeleton, random, 10, 0.2));
        core::Pose step(hand.skeleton.poseSize());
        step << 7 * random.direction(), 0.12 * random.direction(), random.vector(hand.skeleton.poseSize() - 6, 0.25);
        start.push_back(core::retract(truth.back(), step));
        for (std::size_t d = 0; d < hand.skeleton.dofs.size(); ++d) {
            double& angle = start.back()[core::kRigidDofs + static_cast<Eigen::Index>(d)];
            angle = std::clamp(angle, hand.skeleton.dofs[d].minRad, hand.skeleton.dofs[d].maxRad);
        }
    }
    masks = seen(truth);
}

std::vector<cv::Mat> FittingScene::seen(const core::HandPoses& poses) const {
    std::vector<cv::Mat> result;
    for (const core::Camera& camera : cameras)
        result.push_back(core::renderHandsMask(camera, hands, poses));
    return result;
}

double FittingScene::errorMm(const core::HandPoses& poses) const {
    return core::meanJointDistanceMm(hands, truth, poses);
}

void drawForearms(const FittingScene& scene, std::vector<cv::Mat>& masks) {
    for (std::size_t h = 0; h < scene.hands.size(); ++h) {
        const core::ForearmCut cut = core::forearmCut(scene.hands[h]);
        const core::Skeleton& skeleton = scene.hands[h].skeleton;
        const core::RigidMotion motion = core::boneTransforms(skeleton, scene.truth[h]).front() *
                                         core::inverse(skeleton.bones.front().worldFromBoneAtRest);
        for (double along = 5; along < 250; along += 3) {
            const Eigen::Vector3d centre = motion * (cut.centre + along * cut.direction);
            for (std::size_t c = 0; c < masks.size(); ++c) {
                const core::Camera& camera = scene.cameras[c];
                const double depth = (camera.cameraFromWorld * centre).z();
                const auto px = core::project(camera, centre);
                if (px && depth > 50)
                    cv::circle(masks[c], cv::Point(static_cast<int>(px->x()), static_cast<int>(px->y())),
                               static_cast<int>(cut.radiusMm * camera.intrinsics(0, 0) / depth), cv::Scalar(255), -1);
            }
        }
    }
}

} // namespace test
