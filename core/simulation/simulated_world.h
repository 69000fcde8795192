// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/geometry/camera.h"
#include "core/hand/hand_model.h"
#include "core/simulation/imperfection.h"

namespace core {

/// What a simulated recording is drawn from: another person's hands before cameras that are not quite those of the
/// file.
struct SimulatedWorld {
    std::vector<HandModel> hands; ///< same degrees of freedom as the model's: its poses are theirs
    std::vector<Camera> cameras;
    bool forearm = false;
    double contourPx = 0;
    std::uint64_t seed = 0;
};

/// The world behind a dataset's hands and cameras. The same for the same seed, on every machine.
SimulatedWorld simulatedWorld(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                              const Imperfection& imperfection, std::uint64_t seed);

/// Every camera turned about its centre, moved and with another focal length, by normal numbers of that size.
std::vector<Camera> perturbedCameras(const std::vector<Camera>& cameras, const RigError& error, std::uint64_t seed);

/// The hands of another person: scale, girth, and bones that differ from the scale by normal shares (both hands alike).
std::vector<HandModel> otherHands(const std::vector<HandModel>& hands, const Imperfection& imperfection,
                                  std::uint64_t seed);

/// Silhouettes of the world's hands in these poses, one per camera: CV_8U, 0 and 255. `name` tells one picture's noise
/// from another's, such as "01/20".
std::vector<cv::Mat> simulatedMasks(const SimulatedWorld& world, const HandPoses& poses, const std::string& name);

/// A silhouette whose outline moves across itself with standard deviation `sigmaPx`, smooth over about 6 px along it:
/// a soft edge with noise, cut again. From about 1.5 px on this makes specks and holes, too, as a threshold does.
cv::Mat withContourNoise(const cv::Mat& mask, double sigmaPx, std::uint64_t seed);

/// One draw of that noise for a silhouette, at any strength: the outline keeps its wiggles while they grow. Drawing it
/// takes far longer than applying it.
class ContourNoise {
public:
    /// For deviations of up to `mostPx`.
    ContourNoise(const cv::Mat& mask, double mostPx, std::uint64_t seed);
    /// CV_8U, 0 and 255, of the mask's size. At `mostPx` what withContourNoise gives for the seed.
    cv::Mat applied(double sigmaPx) const;

private:
    cv::Size m_size;
    cv::Rect m_window; ///< of the mask: all that the noise can change
    cv::Mat m_soft;    ///< of the window, CV_32F: the mask with a soft edge, 0 to 255
    cv::Mat m_noise;   ///< of the window, CV_32F: smooth noise, added in proportion to the deviation
};

/// The seed of one of many independent draws.
std::uint64_t drawSeed(std::uint64_t seed, const std::string& name);

} // namespace core
