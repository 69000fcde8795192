// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/hand/motion.h"
#include "core/simulation/simulated_world.h"

namespace core {

/// How a simulated camera takes pictures.
struct PictureOptions {
    double exposureFrames = 0.5; ///< shutter time, in frames: what moves meanwhile is blurred
    int exposures = 5;           ///< pictures that are averaged over that time
    double defocusPx = 0.7;
    double readNoise = 2;   ///< grey levels
    double shotNoise = 0.2; ///< grey levels per square root of one
};

/// What a camera sees without hands: a cluttered room, out of focus. CV_8UC3 BGR of the camera's size.
cv::Mat backgroundPicture(const Camera& camera, std::uint64_t seed);

/// A picture with the sensor's noise, other noise for every name.
cv::Mat withSensorNoise(const cv::Mat& picture, const PictureOptions& options, std::uint64_t seed);

/// The picture that camera `index` of the world takes at `frame`: the hands, and their arms if the world has them, in
/// motion before the background. Throws Error(Usage) if the motion has no such frame.
cv::Mat simulatedPicture(const SimulatedWorld& world, std::size_t index, const Motion& motion, int frame,
                         const cv::Mat& background, const PictureOptions& options, const std::string& name);

} // namespace core
