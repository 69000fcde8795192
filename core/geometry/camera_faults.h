// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/camera.h"

namespace core {

/// What is wrong, or odd, with a calibration by itself, before anything is clicked.
enum class CameraFaultKind {
    NotARotation,  ///< R is not orthonormal, or a mirror; value: the largest entry of |R R^T - 1|, or det R if it is -1
    NoFocalLength, ///< a focal length that is not positive
    CentreOutside, ///< the principal point lies outside the image
    OtherSize,     ///< the pictures (`pictures`) have another shape than the calibrated image
    OtherScale,    ///< the same shape; value: pixels of the pictures per calibrated pixel
    SamePlace,     ///< as camera `other`
    LooksAway,     ///< where the cameras look lies behind it
    TargetUnseen,  ///< it lies in front, but outside the picture
    LensFolds,     ///< value: in which share of the image the lens model holds
    OddUnit        ///< of all cameras; value: mm from where they look (or from each other)
};

struct CameraFault {
    CameraFaultKind kind = CameraFaultKind::NotARotation;
    int camera = -1; ///< -1: all
    double value = 0;
    int other = -1;
    ImageSize pictures{};
    bool operator==(const CameraFault&) const = default;

    /// True if nothing can be made of such cameras.
    bool isFatal() const { return kind <= CameraFaultKind::OtherScale; }
};

/// Faults of each camera in order, then those of all. `pictureSizes` is parallel to cameras: of the footage as it is
/// recorded; a quarter turn is not a fault, the footage's own tag decides it. Empty if all is well.
std::vector<CameraFault> findCameraFaults(const std::vector<Camera>& cameras,
                                          const std::vector<std::optional<ImageSize>>& pictureSizes);

/// How far cameras usually are from where they look or, if they look past each other, from each other, and whether that
/// is a rig of another unit.
struct RigScale {
    double distanceMm = 0; ///< the median; 0 for a single camera
    bool hasTarget = false;
    double likelyFactor = 1; ///< by which lengths are too small (10: the file is in centimetres); 1: nothing is odd
};
RigScale rigScale(const std::vector<Camera>& cameras);

} // namespace core
