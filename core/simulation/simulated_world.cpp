// SPDX-License-Identifier: MIT
#include "core/simulation/simulated_world.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

#include "core/contour/rasteriser.h"
#include "core/numeric/normal.h"
#include "core/simulation/forearm_surface.h"
#include "core/subject/hand_shape.h"

namespace core {

namespace {

constexpr double kSmoothPx = 6; ///< of the noise along the outline
constexpr double kStepPx = 3;   ///< by which the mask's step is blurred before it is cut again

cv::Rect grown(const cv::Rect& box, int margin, const cv::Size& size) {
    return cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
           cv::Rect({}, size);
}

} // namespace

std::uint64_t drawSeed(std::uint64_t seed, const std::string& name) {
    return RandomGenerator(seed ^ stableHash(name)).next();
}

std::vector<Camera> perturbedCameras(const std::vector<Camera>& cameras, const RigError& error, std::uint64_t seed) {
    std::vector<Camera> moved = cameras;
    for (Camera& camera : moved) {
        RandomGenerator random(drawSeed(seed, "rig/" + camera.name));
        const auto vector = [&](double sigma) {
            const double x = standardNormal(random), y = standardNormal(random), z = standardNormal(random);
            return Eigen::Vector3d(sigma * Eigen::Vector3d(x, y, z));
        };
        const Eigen::Matrix3d turn = rotationExp(vector(error.turnDeg * std::numbers::pi / 180));
        RigidMotion& pose = camera.cameraFromWorld;
        pose.rotation = turn * pose.rotation;
        pose.translation = turn * pose.translation + vector(error.shiftMm);
        const double focal = 1 + error.focalShare * standardNormal(random);
        camera.intrinsics(0, 0) *= focal;
        camera.intrinsics(1, 1) *= focal;
    }
    return moved;
}

std::vector<HandModel> otherHands(const std::vector<HandModel>& hands, const Imperfection& imperfection,
                                  std::uint64_t seed) {
    std::vector<HandModel> others;
    for (const HandModel& hand : hands) {
        const ShapeSpace space(hand);
        HandShape shape = space.modelShape();
        shape[0] = std::log(imperfection.scale);
        shape[1] = imperfection.girthMm;
        RandomGenerator random(drawSeed(seed, "bones"));
        for (int a = 0; a < space.segmentCount(); ++a)
            shape[space.lengthIndex(a)] = imperfection.lengthShare * standardNormal(random);
        others.push_back(space.shaped(shape));
    }
    return others;
}

SimulatedWorld simulatedWorld(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                              const Imperfection& imperfection, std::uint64_t seed) {
    const bool isOther = imperfection.scale != 1 || imperfection.girthMm != 0 || imperfection.lengthShare != 0;
    return {isOther ? otherHands(hands, imperfection, seed) : hands,
            imperfection.rig == RigError{} ? cameras : perturbedCameras(cameras, imperfection.rig, seed),
            imperfection.forearm, imperfection.contourPx, seed};
}

ContourNoise::ContourNoise(const cv::Mat& mask, double mostPx, std::uint64_t seed)
    : m_size(mask.size()) {
    const cv::Rect lit = cv::boundingRect(mask);
    if (lit.empty())
        return;
    m_window = grown(lit, static_cast<int>(std::ceil(4 * (mostPx + kStepPx))), mask.size());
    m_noise.create(m_window.size(), CV_32F);
    RandomGenerator random(seed);
    for (int y = 0; y < m_noise.rows; ++y)
        for (int x = 0; x < m_noise.cols; ++x)
            m_noise.at<float>(y, x) = static_cast<float>(standardNormal(random));
    cv::GaussianBlur(m_noise, m_noise, {}, kSmoothPx, kSmoothPx, cv::BORDER_REFLECT_101);
    mask(m_window).convertTo(m_soft, CV_32F);
    cv::GaussianBlur(m_soft, m_soft, {}, kStepPx, kStepPx, cv::BORDER_REPLICATE);
}

cv::Mat ContourNoise::applied(double sigmaPx) const {
    cv::Mat noisy = cv::Mat::zeros(m_size, CV_8U);
    if (m_window.empty())
        return noisy;
    // White noise has this deviation after the blur; a step blurred by s has the slope 255 / (sqrt(2 pi) s).
    const double deviation = 1 / (2 * std::sqrt(std::numbers::pi) * kSmoothPx);
    const double slope = 255 / (std::sqrt(2 * std::numbers::pi) * kStepPx);
    cv::Mat moved = m_soft.clone();
    moved += m_noise * (sigmaPx * slope / deviation);
    noisy(m_window).setTo(255, moved > 127.5);
    return noisy;
}

cv::Mat withContourNoise(const cv::Mat& mask, double sigmaPx, std::uint64_t seed) {
    return ContourNoise(mask, sigmaPx, seed).applied(sigmaPx);
}

std::vector<cv::Mat> simulatedMasks(const SimulatedWorld& world, const HandPoses& poses, const std::string& name) {
    std::vector<std::vector<Eigen::Vector3d>> vertices;
    std::vector<ForearmSurface> forearms;
    std::vector<PosedSurface> surfaces;
    vertices.reserve(world.hands.size());
    forearms.reserve(world.hands.size());
    for (std::size_t h = 0; h < world.hands.size(); ++h) {
        vertices.push_back(posedVertices(world.hands[h], poses[h]));
        surfaces.push_back({&vertices.back(), &world.hands[h].mesh.triangles});
        if (world.forearm) {
            forearms.push_back(forearmSurface(world.hands[h], poses[h]));
            surfaces.push_back({&forearms.back().verticesInWorld, &forearms.back().triangles});
        }
    }
    std::vector<cv::Mat> masks;
    for (const Camera& camera : world.cameras) {
        masks.push_back(renderMask(camera, surfaces));
        if (world.contourPx > 0) {
            masks.back() =
                withContourNoise(masks.back(), world.contourPx, drawSeed(world.seed, name + "/" + camera.name));
        }
    }
    return masks;
}

} // namespace core
