// SPDX-License-Identifier: MIT
#include "tests/support/fitting_scene.h"

#include <algorithm>

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

} // namespace test
