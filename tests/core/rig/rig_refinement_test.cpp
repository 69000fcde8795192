// SPDX-License-Identifier: MIT
#include "core/rig/rig_refinement.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/geometry/triangulation.h"
#include "tests/core/rig/rig_scene.h"

namespace {

using test::RigScene;

/// Mean distance between points made from clicks and the true ones, as they are and after the best rigid motion, mm.
struct PointErrors {
    double raw = 0, aligned = 0;
};
PointErrors errorsOf(const RigScene& scene, const std::vector<core::Camera>& cameras,
                     const std::vector<core::RigJoint>& joints) {
    Eigen::Matrix3Xd made(3, joints.size()), wanted(3, joints.size());
    core::TriangulationOptions options;
    options.outlierFactor = 100; // all views
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const auto column = static_cast<Eigen::Index>(j);
        made.col(column) = core::triangulate(cameras, joints[j].clicks, options).point->pointInWorld;
        wanted.col(column) = scene.pointAt(std::stoi(joints[j].joint.joint.substr(5)), joints[j].frame);
    }
    const Eigen::Matrix4d motion = Eigen::umeyama(made, wanted, false);
    const Eigen::Matrix3Xd aligned = (motion.topLeftCorner<3, 3>() * made).colwise() + motion.topRightCorner<3, 1>();
    return {(made - wanted).colwise().norm().mean(), (aligned - wanted).colwise().norm().mean()};
}

TEST(CameraCorrection, JacobianIsThatOfFiniteDifferences) {
    for (const bool fisheye : {false, true}) {
        core::Camera camera = test::cameraRing(1)[0];
        camera.fisheye = fisheye;
        camera.distortion = fisheye ? std::vector<double>{-0.05, 0.02, 0.01, -0.003}
                                    : std::vector<double>{-0.12, 0.05, 0.001, -0.0008, 0.01, 0.02, -0.01, 0.03};
        core::CameraCorrection at;
        at << 0.004, -0.006, 0.003, 1.5, -2, 0.7, 0.002, 0.01, -0.02;
        const Eigen::Vector3d point(60, -80, 40);
        const auto jacobian = core::pxByCorrection(camera, at, point);
        ASSERT_TRUE(jacobian);
        for (Eigen::Index i = 0; i < 9; ++i) {
            const double step = i >= 3 && i < 6 ? 1e-3 : 1e-6;
            core::CameraCorrection more = at, less = at;
            more[i] += step;
            less[i] -= step;
            const Eigen::Vector2d difference = (*core::project(core::corrected(camera, more), point) -
                                                *core::project(core::corrected(camera, less), point)) /
                                               (2 * step);
            EXPECT_LT((jacobian->col(i) - difference).norm(), 1e-5 * (1 + difference.norm())) << i;
        }
    }
}

TEST(RigRefinement, MendsALooseRigForFramesThatItDidNotSee) {
    RigScene scene("Loose");
    scene.loosen(3);
    const auto refinement = core::refineRig(scene.nominal, scene.clicks(RigScene::frames(10, 9)));
    ASSERT_TRUE(refinement);
    const auto others = scene.clicks(RigScene::frames(12, 7, 4));
    const double clickNoise = errorsOf(scene, scene.seen, others).aligned;
    EXPECT_GT(errorsOf(scene, scene.nominal, others).aligned, 1.15 * clickNoise);
    EXPECT_LT(errorsOf(scene, refinement->cameras, others).aligned, 1.05 * clickNoise);
    EXPECT_NEAR(refinement->sigmaPx, 1, 0.08);
    EXPECT_TRUE(refinement->converged);
}

TEST(RigRefinement, AnExactRigStays) {
    RigScene scene("Exact");
    const auto refinement = core::refineRig(scene.nominal, scene.clicks(RigScene::frames(10, 9)));
    ASSERT_TRUE(refinement);
    const auto others = scene.clicks(RigScene::frames(12, 7, 4));
    EXPECT_LT(errorsOf(scene, refinement->cameras, others).aligned,
              errorsOf(scene, scene.nominal, others).aligned + 0.05);
    EXPECT_LT(errorsOf(scene, refinement->cameras, others).raw, errorsOf(scene, scene.nominal, others).raw + 0.05);
}

TEST(RigRefinement, WrongClicksDoNotMoveTheCameras) {
    RigScene scene("Wrong");
    scene.loosen();
    auto joints = scene.clicks(RigScene::frames(10, 9));
    for (std::size_t j = 0; j < joints.size(); j += 12)
        joints[j].clicks[j % 8].px += Eigen::Vector2d(-60, 80);
    const auto refinement = core::refineRig(scene.nominal, joints);
    ASSERT_TRUE(refinement);
    EXPECT_EQ(refinement->wrongClicks, 12);
    const auto others = scene.clicks(RigScene::frames(12, 7, 4));
    EXPECT_LT(errorsOf(scene, refinement->cameras, others).aligned, 1.06 * errorsOf(scene, scene.seen, others).aligned);
}

TEST(RigRefinement, KeepsScaleAndOrientationOfTheRig) {
    RigScene scene("Gauge");
    scene.loosen();
    const auto refinement = core::refineRig(scene.nominal, scene.clicks(RigScene::frames(10, 9)));
    ASSERT_TRUE(refinement);
    Eigen::Vector3d before = Eigen::Vector3d::Zero(), after = before;
    for (std::size_t c = 0; c < 8; ++c) {
        before += scene.nominal[c].centreInWorld() / 8;
        after += refinement->cameras[c].centreInWorld() / 8;
    }
    EXPECT_LT((before - after).norm(), 2);
    double spreadBefore = 0, spreadAfter = 0;
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();
    for (std::size_t c = 0; c < 8; ++c) {
        const Eigen::Vector3d from = scene.nominal[c].centreInWorld() - before;
        const Eigen::Vector3d to = refinement->cameras[c].centreInWorld() - after;
        spreadBefore += from.squaredNorm();
        spreadAfter += to.squaredNorm();
        turn += from.cross(to) / from.squaredNorm() / 8;
    }
    EXPECT_NEAR(spreadAfter / spreadBefore, 1, 1e-9);
    EXPECT_LT(turn.norm(), 1e-3);
}

TEST(RigRefinement, IsTheSameEveryTime) {
    RigScene scene("Same");
    scene.loosen();
    const auto joints = scene.clicks(RigScene::frames(5, 9));
    const auto first = core::refineRig(scene.nominal, joints), second = core::refineRig(scene.nominal, joints);
    ASSERT_TRUE(first && second);
    for (std::size_t c = 0; c < 8; ++c)
        EXPECT_EQ(first->cameras[c].cameraFromWorld.translation, second->cameras[c].cameraFromWorld.translation);
}

TEST(RigRefinement, NeedsThreeCamerasAndEnoughJoints) {
    RigScene two("Two", 2);
    EXPECT_FALSE(core::refineRig(two.nominal, two.clicks(RigScene::frames(5, 9))));
    RigScene scene("Few");
    EXPECT_FALSE(core::refineRig(scene.nominal, scene.clicks({3})));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(core::refineRig(scene.nominal, scene.clicks({3, 9, 15}), {}, stop.get_token()));
}

} // namespace
