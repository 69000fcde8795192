// SPDX-License-Identifier: MIT
#pragma once

namespace core {

/// How far the cameras of a recording are from their calibration file: standard deviations, per camera.
struct RigError {
    double turnDeg = 0;    ///< rotation about each axis, through the camera's own centre
    double shiftMm = 0;    ///< translation along each of the camera's axes
    double focalShare = 0; ///< of the focal length, both axes together
    bool operator==(const RigError&) const = default;
};

/// A rig that was calibrated well and not touched since, and one that was knocked: its views are 3 to 9 px off.
inline constexpr RigError kStudioRig{0.02, 0.2, 0.0003};
inline constexpr RigError kCasualRig{0.08, 0.7, 0.001};

/// How a recording differs from the cameras and hands that its dataset holds. All zero: not at all.
struct Imperfection {
    double contourPx = 0;   ///< standard deviation of the silhouettes' outlines across themselves
    bool forearm = false;   ///< an arm is seen beyond the model's end
    double scale = 1;       ///< of the person's hands against the model
    double girthMm = 0;     ///< by which they are thicker, along the normals
    double lengthShare = 0; ///< standard deviation of each bone's length beyond the scale
    RigError rig;
    bool operator==(const Imperfection&) const = default;
};

} // namespace core
