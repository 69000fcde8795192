// SPDX-License-Identifier: MIT
#include "core/labelling/fit_doubt.h"

#include <gtest/gtest.h>

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
    EXPECT_LE(with([](auto& s) { s.landmarkMm.reset(); }), least);
}

TEST(FitDoubt, LandmarksLieWhereTheModelsJointsAre) {
    // asked of a hand with fewer landmarks than can be compared
    core::SpatialHand nothing;
    core::HandModel model;
    model.skeleton.bones.push_back({"wrist", -1, {}, 0});
    EXPECT_FALSE(core::landmarkDistanceMm(model, model.skeleton.restPose(), nothing));
}

} // namespace
