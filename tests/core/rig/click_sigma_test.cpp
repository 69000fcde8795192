// SPDX-License-Identifier: MIT
#include "core/rig/click_sigma_estimate.h"

#include <gtest/gtest.h>

#include "core/rig/rig_error_model.h"
#include "core/rig/rig_refinement.h"
#include "tests/core/rig/rig_truth.h"

namespace {

using test::RigScene;

void rename(std::vector<core::RigJoint>& joints, const std::string& rater) {
    for (core::RigJoint& joint : joints)
        joint.rater = rater;
}

TEST(ClickSigmas, AreThoseOfEachRaterAndNotTheRigsError) {
    RigScene scene("Raters");
    scene.loosen(1.5);
    auto joints = scene.clicks(RigScene::frames(10, 8), 0.6), others = scene.clicks(RigScene::frames(10, 8), 1.8);
    rename(others, "bob");
    joints.insert(joints.end(), others.begin(), others.end());
    const core::ClickSigmas sigmas = core::estimateClickSigmas(scene.nominal, joints);
    EXPECT_FALSE(sigmas.of("ann").isAssumed);
    EXPECT_NEAR(sigmas.of("ann").clickPx, 0.6, 0.04);
    EXPECT_NEAR(sigmas.of("bob").clickPx, 1.8, 0.1);
    EXPECT_TRUE(sigmas.of("eve").isAssumed);
    ASSERT_EQ(sigmas.systematicPx.size(), 8u);
    double squares = 0, truth = 0;
    for (std::size_t c = 0; c < 8; ++c) {
        squares += sigmas.systematicPx[c] * sigmas.systematicPx[c];
        const Eigen::Vector2d shift =
            *core::project(scene.seen[c], {0, 0, 0}) - *core::project(scene.nominal[c], {0, 0, 0});
        truth += shift.squaredNorm() / 2;
    }
    EXPECT_NEAR(std::sqrt(squares / truth), 1, 0.35);
    const auto options = sigmas.optionsFor("ann");
    EXPECT_FALSE(options.isSigmaAssumed);
    EXPECT_NEAR(options.sigmaPxByCamera[3], std::hypot(sigmas.of("ann").clickPxByCamera[3], sigmas.systematicPx[3]),
                1e-12);
}

TEST(ClickSigmas, ACameraWithABlurredPictureHasALargerOne) {
    RigScene scene("Blurred");
    auto joints = scene.clicks(RigScene::frames(10, 8));
    for (core::RigJoint& joint : joints)
        joint.clicks[2].px += Eigen::Vector2d(scene.normal(2), scene.normal(2));
    const core::RaterSigma sigma = core::estimateClickSigmas(scene.nominal, joints).of("ann");
    for (std::size_t c = 0; c < 8; ++c)
        EXPECT_NEAR(sigma.clickPxByCamera[c], c == 2 ? 2.2 : 1, c == 2 ? 0.3 : 0.15) << c;
}

TEST(ClickSigmas, OfFewClicksAreAssumed) {
    RigScene scene("Few");
    scene.jointCount = 2;
    const core::ClickSigmas sigmas = core::estimateClickSigmas(scene.nominal, scene.clicks({3}));
    EXPECT_TRUE(sigmas.of("ann").isAssumed);
    EXPECT_EQ(sigmas.of("ann").clickPx, 1);
    EXPECT_TRUE(sigmas.optionsFor("ann").isSigmaAssumed);
    EXPECT_TRUE(core::estimateClickSigmas(scene.nominal, {}).raters.empty());
}

TEST(ClickSigmas, AMovedCameraIsTakenOutOfWhatTheOthersAreWorth) {
    RigScene scene("Apart");
    scene.turn(5, {0.18, -0.22, 0});
    const core::ClickSigmas sigmas = core::estimateClickSigmas(scene.nominal, scene.clicks(RigScene::frames(10, 8)));
    for (std::size_t c = 0; c < 8; ++c)
        if (c == 5)
            EXPECT_GT(sigmas.systematicPx[c], 4);
        else
            EXPECT_LT(sigmas.systematicPx[c], 0.6) << c;
}

TEST(ClickSigmas, ACameraWithoutClicksIsTakenToBeLikeTheOthers) {
    RigScene scene("Unseen");
    scene.loosen();
    auto joints = scene.clicks(RigScene::frames(10, 8));
    for (core::RigJoint& joint : joints)
        std::erase_if(joint.clicks, [](const core::Observation& click) { return click.camera == 4; });
    const core::ClickSigmas sigmas = core::estimateClickSigmas(scene.nominal, joints);
    EXPECT_NEAR(sigmas.systematicPx[4] / sigmas.systematicPx[3], 1, 0.1);
    EXPECT_NEAR(sigmas.of("ann").clickPxByCamera[4], sigmas.of("ann").clickPx, 1e-9);
}

TEST(ClickSigmas, WrongClicksDoNotCount) {
    RigScene scene("Wrong");
    auto joints = scene.clicks(RigScene::frames(10, 8));
    for (std::size_t j = 0; j < joints.size(); j += 10)
        joints[j].clicks[j % 8].px += Eigen::Vector2d(70, -40);
    const core::RaterSigma sigma = core::estimateClickSigmas(scene.nominal, joints).of("ann");
    EXPECT_NEAR(sigma.clickPx, 1, 0.05);
    EXPECT_GE(sigma.wrongClicks, 14);
    EXPECT_LE(sigma.wrongClicks, 16);
}

/// e^T C^-1 e has a mean of 3 where stated and true uncertainty agree. Mean over rigs, since all joints of one share
/// the error of its cameras.
TEST(ClickSigmas, StatedAndTrueUncertaintyAgreeAtEveryRigLevel) {
    for (const double level : {0.0, 0.27, 1.0}) {
        test::TruthComparison given, refined;
        constexpr int kRigs = 24, kRefined = 24;
        for (int rig = 0; rig < kRigs; ++rig) {
            RigScene scene("Nees" + std::to_string(level) + "/" + std::to_string(rig));
            scene.loosen(level);
            const auto chosen = scene.clicks(RigScene::frames(5, 16)), others = scene.clicks({4, 28, 52});
            test::add(given,
                      compareWithTruth(scene, scene.nominal, others, core::estimateClickSigmas(scene.nominal, chosen)),
                      1.0 / kRigs);
            if (rig >= kRefined)
                continue;
            const core::RigRefinement refinement = core::refineRig(scene.nominal, chosen).value();
            const std::vector<core::Camera>& cameras = refinement.cameras;
            const auto world = core::worldCovariance(scene.nominal, core::estimateClickSigmas(scene.nominal, chosen),
                                                     refinement.middleInWorld);
            ASSERT_TRUE(world);
            test::add(refined,
                      compareWithTruth(scene, cameras, others, core::estimateClickSigmas(cameras, chosen), *world),
                      1.0 / kRefined);
        }
        EXPECT_NEAR(given.neesRaw, 3, 0.5) << level;
        EXPECT_NEAR(refined.neesRaw, 3, 0.5) << level << ", with what is stated of the world as a whole";
        EXPECT_NEAR(refined.neesAligned, 3, 0.5) << level;
        EXPECT_LT(given.dropped, 0.002);
        EXPECT_LT(refined.alignedMm, 0.5);
    }
}

TEST(ClickSigmas, WhileTheyAreAssumedGoodCamerasAreKeptAndTheCovarianceGrows) {
    RigScene scene("Assumed");
    scene.loosen();
    const auto joints = scene.clicks({4, 20, 36});
    const test::TruthComparison plain = compareWithTruth(scene, scene.nominal, joints, {});
    EXPECT_LT(plain.dropped, 0.005);
    core::TriangulationOptions known;
    const auto sure = core::triangulate(scene.nominal, joints[0].clicks, known);
    known.isSigmaAssumed = true;
    const auto unsure = core::triangulate(scene.nominal, joints[0].clicks, known);
    EXPECT_GT(unsure.point->covariance.trace(), 1.5 * sure.point->covariance.trace());
    EXPECT_EQ(core::misfitFactor(3, 5), 1);
    EXPECT_DOUBLE_EQ(core::misfitFactor(50, 5), 6);
}

TEST(ClickSigmas, AreTheSameEveryTime) {
    RigScene scene("Same");
    scene.loosen();
    const auto joints = scene.clicks(RigScene::frames(5, 9));
    EXPECT_EQ(core::estimateClickSigmas(scene.nominal, joints), core::estimateClickSigmas(scene.nominal, joints));
}

} // namespace
