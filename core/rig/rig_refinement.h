// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/annotation/click_sigmas.h"
#include "core/rig/rig_residuals.h"

namespace core {

/// How far a calibration may be expected to be off, per camera (standard deviations of weak priors), and when to stop.
struct RigRefinementOptions {
    double turnDeg = 0.2;      ///< rotation about each axis
    double shiftMm = 2;        ///< centre, along each axis
    double focalShare = 0.003; ///< of the focal length, both axes together
    double distortion = 0.02;  ///< k1 and k2
    double startSigmaPx = 1;   ///< scatter of the clicks that the first solution assumes; then it is estimated
    double robustFactor = 3;   ///< residuals beyond that many sigma count linearly (Huber)
    int leastJoints = 20;      ///< seen by three cameras or more; with fewer there is no answer
    int maxIterations = 50;
    double functionTolerance = 1e-7; ///< ends when |cost change| < it * cost
};

/// How one camera was changed.
struct CameraRefinement {
    std::string camera;
    int clicks = 0;
    double beforeRmsPx = 0; ///< of its clicks, about points of the calibration as it was (no camera is left out)
    double afterRmsPx = 0;
    double turnDeg = 0; ///< by how much it turned
    double shiftMm = 0; ///< by how much its centre moved
    double focalShare = 0;
};

struct RigRefinement {
    std::vector<Camera> cameras;           ///< as given, but for rotation, translation, focal lengths, k1 and k2
    std::vector<CameraRefinement> changes; ///< parallel to the cameras
    double sigmaPx = 0;                    ///< scatter of a click per axis about the refined rig (robust)
    int joints = 0;                        ///< that took part
    int frames = 0;
    /// Where the middle of the clicked joints is, in both worlds: the refined one is moved there (mm).
    Eigen::Vector3d middleInWorld = Eigen::Vector3d::Zero();
    int wrongClicks = 0; ///< beyond 5 sigma of the refined rig: they took no part in the last solution
    int iterations = 0;
    bool converged = false;
};

/// Adjusts a calibration to clicks: bundle adjustment (Triggs et al. 2000) of rotations, centres, focal length and
/// k1, k2 of every camera with weak priors, over all joints that two or more cameras see, in recorded pixels, robust;
/// points are eliminated. The gauge stays: a similarity afterwards puts the spread and the mean orientation of the
/// cameras back to what they were, and the middle of the clicked joints to where most cameras saw it. One thread: the
/// result is always the same. Empty if there are fewer than three cameras with clicks or too few joints, or if it was
/// stopped.
std::optional<RigRefinement> refineRig(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints,
                                       const RigRefinementOptions& options = {}, std::stop_token stop = {});
/// The same where the residuals of the joints are known already.
std::optional<RigRefinement> refineRig(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints,
                                       const RigResiduals& residuals, const RigRefinementOptions& options = {},
                                       std::stop_token stop = {});

/// How far a refined world as a whole lies from that of a perfect calibration: covariance of the place of its middle,
/// mm^2. The middle stays where the cameras as given saw it, so it is as uncertain as their systematic part makes it,
/// (sum J^T J / systematic^2)^-1 over them. What a refined rig states of a joint holds within its own world; in the
/// true world this adds to it. `given` are the cameras before the refinement, `sigmas` estimated with them. Nothing
/// while their systematic part is not known.
std::optional<Eigen::Matrix3d> worldCovariance(const std::vector<Camera>& given, const ClickSigmas& sigmas,
                                               const Eigen::Vector3d& middleInWorld);

/// Joints that refineRig counts: seen by three cameras or more.
int countWellSeenJoints(const std::vector<RigJoint>& joints);

/// The camera with small corrections: turned by exp(angle, rad) after its rotation, its centre moved (mm), focal
/// lengths times exp(log focal), k1 and k2 added to: (angle 3, centre 3, log focal, k1, k2).
using CameraCorrection = Eigen::Matrix<double, 9, 1>;
Camera corrected(const Camera& camera, const CameraCorrection& correction);
/// Derivative of the pixel of a point by that correction, at `correction`; empty if the point is not in front.
std::optional<Eigen::Matrix<double, 2, 9>> pxByCorrection(const Camera& camera, const CameraCorrection& correction,
                                                          const Eigen::Vector3d& pointInWorld);

} // namespace core
