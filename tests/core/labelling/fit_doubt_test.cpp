// SPDX-License-Identifier: MIT
#include "core/labelling/fit_doubt.h"

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"

namespace {

TEST(FitDoubt, OfAGoodFitIsSmallAndEverySignRaisesIt) {
    core::FitSigns good;
    good.deepPx = 0.01;
    good.overlap = 0.97;
    good.worstSigmaMm = 2;
    good.landmarkMm = 5;
    const double least = core::doubtOf(good);
    EXPECT_LT(least, 0.1);
    const auto with = [&](auto change) {
        core::FitSigns signs = good;
        change(signs);
        return core::doubtOf(signs);
    };
    EXPECT_GT(with([](auto& s) { s.deepPx = 0.6; }), 0.5);
    EXPECT_GT(with([](auto& s) { s.overlap = 0.8; }), 0.5);
    EXPECT_GT(with([](auto& s) { s.worstSigmaMm = 8; }), 0.5);
    EXPECT_GT(with([](auto& s) { s.landmarkMm = 20; }), 0.5);
    EXPECT_GT(with([](auto& s) { s.misfit = 4; }), 0.5);
    EXPECT_GT(with([](auto& s) { s.raySine = 0.1; }), 0.9);
    EXPECT_LE(with([](auto& s) { s.landmarkMm.reset(); }), least);
}

TEST(FitDoubt, ViewsThatFaceEachOtherDoNotTellDepth) {
    auto cameras = test::cameraRing(8);
    cameras[4].cameraFromWorld.translation = cameras[0].cameraFromWorld.translation;
    const Eigen::Matrix3d turn = Eigen::Vector3d(-1, 1, -1).asDiagonal();
    cameras[4].cameraFromWorld.rotation = turn * cameras[0].cameraFromWorld.rotation;
    core::SpatialHand hand;
    for (auto& landmark : hand.landmarks)
        landmark.emplace();
    const auto doubtWith = [&](std::initializer_list<int> views) {
        hand.views.clear();
        for (const int camera : views)
            hand.views[camera];
        core::FitSigns signs;
        signs.raySine = core::widestRaySine(cameras, hand);
        return core::doubtOf(signs);
    };
    EXPECT_GT(doubtWith({0, 4}), 0.9);
    EXPECT_LT(doubtWith({0, 1}), 0.05);
    EXPECT_LT(doubtWith({0, 4, 1}), 0.05);
}

TEST(FitDoubt, LandmarksLieWhereTheModelsJointsAre) {
    // asked of a hand with fewer landmarks than can be compared
    core::SpatialHand nothing;
    core::HandModel model;
    model.skeleton.bones.push_back({"wrist", -1, {}, 0});
    EXPECT_FALSE(core::landmarkDistanceMm(model, model.skeleton.restPose(), nothing));
}

} // namespace
