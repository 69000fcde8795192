// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/rig/rig_clicks.h"
#include "tests/support/camera_ring.h"
#include "tests/support/clicks.h"

namespace test {

/// Simulated clicks of a moving hand: joints (14) per frame in a volume of 160 mm.
class RigScene {
public:
    explicit RigScene(const std::string& name, int cameraCount = 8)
        : nominal(cameraRing(cameraCount))
        , seen(nominal)
        , random(randomFor(name)) {}

    double normal(double sigma) { return std::normal_distribution<double>(0, sigma)(random); }
    Eigen::Vector3d normal3(double sigma) { return {normal(sigma), normal(sigma), normal(sigma)}; }

    /// Turns a camera about its own centre.
    void turn(std::size_t camera, const Eigen::Vector3d& angleDeg) {
        core::Camera& c = seen[camera];
        const Eigen::Vector3d centre = c.centreInWorld();
        c.cameraFromWorld.rotation = core::rotationExp(angleDeg * std::numbers::pi / 180) * c.cameraFromWorld.rotation;
        c.cameraFromWorld.translation = -(c.cameraFromWorld.rotation * centre);
    }
    /// A rig that was set up in a hurry: 0.08 degrees, 0.7 mm, 0.1 % of the focal length, or more of the same.
    void loosen(double factor = 1) {
        for (std::size_t c = 0; c < seen.size(); ++c) {
            turn(c, normal3(0.08 * factor));
            seen[c].cameraFromWorld.translation += normal3(0.7 * factor);
            seen[c].intrinsics.topLeftCorner<2, 2>() *= 1 + normal(0.001 * factor);
        }
    }
    Eigen::Vector3d pointAt(int joint, double frame) const {
        const double a = 1.7 * joint, b = 0.9 * joint;
        const Eigen::Vector3d rest(60 * std::cos(a), 50 * std::sin(a), 60 * std::cos(b));
        return rest + Eigen::Vector3d(40 * std::sin(0.05 * frame + a), 30 * std::cos(0.04 * frame),
                                      20 * std::sin(0.03 * frame));
    }
    /// Clicks of the cameras that were there; `lateCamera` shows what was `lateFrames` before.
    std::vector<core::RigJoint> clicks(const std::vector<int>& frames, double sigmaPx = 1, int lateCamera = -1,
                                       double lateFrames = 0) {
        core::AnnotationSet set;
        for (const int frame : frames) {
            for (int j = 0; j < jointCount; ++j) {
                const core::JointId id{core::Side::Left, "joint" + std::to_string(j)};
                clickEverywhere(set, seen, frame, "ann", id, pointAt(j, frame), sigmaPx, &random);
                if (lateCamera >= 0)
                    clickEverywhere(set, {seen[static_cast<std::size_t>(lateCamera)]}, frame, "ann", id,
                                    pointAt(j, frame - lateFrames), sigmaPx, &random);
            }
        }
        std::vector<core::RigJoint> joints;
        core::addRigJoints(joints, set, nominal, 0);
        return joints;
    }
    static std::vector<int> frames(int count, int step, int first = 0) {
        std::vector<int> list;
        for (int i = 0; i < count; ++i)
            list.push_back(first + i * step);
        return list;
    }

    int jointCount = 14;
    std::vector<core::Camera> nominal; ///< as the file says
    std::vector<core::Camera> seen;    ///< as they were
    std::mt19937_64 random;
};

} // namespace test
