// SPDX-License-Identifier: MIT
#include "core/labelling/label_pass.h"

#include <gtest/gtest.h>

#include "core/labelling/auto_labels.h"
#include "core/labelling/pass_hands.h"
#include "core/labelling/retracking.h"
#include "tests/support/simulated_pass.h"

namespace {

using core::FitSource;
using test::SimulatedPass;

std::vector<int> framesFrom(int first, int count, int step = 1) {
    std::vector<int> frames;
    for (int i = 0; i < count; ++i)
        frames.push_back(first + i * step);
    return frames;
}

core::PassOptions options(bool measureHands = false) {
    core::PassOptions options;
    options.measureHands = measureHands;
    options.threads = 2;
    return options;
}

TEST(LabelPass, BringsModelsToSilhouettesAndTracksBetweenKeyFrames) {
    SimulatedPass scene("labels");
    const auto frames = framesFrom(40, 7);
    auto settings = options();
    settings.keyEveryFrames = 6;
    const auto result = core::runLabelPass(scene.hands, scene.cameras, frames, scene, settings);
    ASSERT_TRUE(result.isFinished);
    ASSERT_EQ(result.fits.size(), frames.size());
    EXPECT_EQ(scene.detectCalls, 2);
    for (const int frame : frames) {
        const core::FrameFit& fit = result.fits.at(frame);
        EXPECT_LT(scene.errorMm(fit, result.hands, frame), 1.5) << frame;
        EXPECT_LT(fit.doubt(), 0.5) << frame;
        EXPECT_EQ(fit.source, frame == 40 || frame == 46 ? FitSource::Silhouettes : FitSource::Tracking) << frame;
    }
}

TEST(LabelPass, IsTheSameForAnyNumberOfThreadsAndGoesOnWhereItWasStopped) {
    SimulatedPass scene("resume"), again("resume");
    const auto frames = framesFrom(10, 4);
    auto settings = options();
    settings.keyEveryFrames = 3;
    std::stop_source stop;
    const auto part = core::runLabelPass(scene.hands, scene.cameras, frames, scene, settings, stop.get_token(),
                                         [&](core::PassStage stage, int, int) {
                                             if (stage == core::PassStage::Tracking)
                                                 stop.request_stop();
                                         });
    EXPECT_FALSE(part.isFinished);
    const auto keptBefore = scene.kept.size();
    EXPECT_GE(keptBefore, 3u);
    const auto rest = core::runLabelPass(scene.hands, scene.cameras, frames, scene, settings);
    settings.threads = 1;
    const auto whole = core::runLabelPass(again.hands, again.cameras, frames, again, settings);
    EXPECT_TRUE(rest.isFinished);
    for (const int frame : frames)
        for (std::size_t h = 0; h < 2; ++h)
            EXPECT_EQ(rest.fits.at(frame).hands[h].pose, whole.fits.at(frame).hands[h].pose) << frame;
}

TEST(LabelPass, TracksAKeyFrameThatTheDetectorLost) {
    SimulatedPass scene("lost");
    scene.lost = {44};
    auto settings = options();
    settings.keyEveryFrames = 2;
    const auto result = core::runLabelPass(scene.hands, scene.cameras, framesFrom(42, 5), scene, settings);
    EXPECT_EQ(result.fits.at(44).source, FitSource::Tracking);
    EXPECT_LT(scene.errorMm(result.fits.at(44), result.hands, 44), 1.5);
}

TEST(LabelPass, FindsNothingWhereTheDetectorSeesNothing) {
    SimulatedPass scene("nothing", 4);
    for (int frame = 0; frame < 10; ++frame)
        scene.lost.insert(frame);
    const auto result = core::runLabelPass(scene.hands, scene.cameras, framesFrom(0, 10), scene, options());
    EXPECT_TRUE(result.isFinished);
    EXPECT_TRUE(core::autoLabels(result, scene.cameras).empty());
}

/// Of another size than the models; much larger ones are found by their landmarks first.
TEST(LabelPass, MeasuresThePersonsHands) {
    for (const double scale : {1.04, 1.13}) {
        SimulatedPass scene("other hand");
        scene.person = core::scaledHands(scene.hands, scale);
        auto settings = options(true);
        settings.keyEveryFrames = 12;
        settings.mostPilots = 5;
        const auto frames = framesFrom(20, 5, 12);
        const auto result = core::runLabelPass(scene.hands, scene.cameras, frames, scene, settings);
        ASSERT_EQ(result.measured.size(), 2u) << scale;
        for (const core::SubjectHand& hand : result.measured)
            EXPECT_NEAR(hand.scale.value, scale, 0.012);
        for (const int frame : frames)
            EXPECT_LT(scene.errorMm(result.fits.at(frame), result.hands, frame), 2) << frame;
    }
}

TEST(LabelPass, OfTwoViewsKeepsToTheLandmarks) {
    SimulatedPass scene("two views", 2);
    const auto result = core::runLabelPass(scene.hands, scene.cameras, {30}, scene, options());
    EXPECT_EQ(result.fits.at(30).source, FitSource::Landmarks);
    EXPECT_LT(scene.errorMm(result.fits.at(30), result.hands, 30), 15);
    for (const core::AutoHand& hand : core::autoHands(result, 30, scene.cameras))
        EXPECT_GE(hand.doubt, 0.5);
}

TEST(LabelPass, LabelsAreInTheCalibrationsUnit) {
    SimulatedPass scene("centimetres");
    auto cameras = scene.cameras;
    for (core::Camera& camera : cameras)
        camera.cameraFromWorld.translation /= 10;
    const auto result = core::runLabelPass(scene.hands, cameras, {30}, scene, options());
    EXPECT_EQ(result.unitMm, 10);
    const auto labels = core::autoLabels(result, cameras);
    const auto truth = core::jointPositions(scene.hands[0].skeleton, scene.motion[30][0]);
    ASSERT_EQ(labels.at(30).size(), 2u);
    const core::AutoJoint& joint = labels.at(30)[0].joints[3];
    EXPECT_LT((joint.pointInWorld - truth[3] / 10).norm(), 0.3);
    EXPECT_LT(joint.covariance.trace(), 0.3);
    ASSERT_FALSE(joint.views.empty());
    for (const core::AutoView& view : joint.views)
        EXPECT_LT((view.px - *core::project(cameras[static_cast<std::size_t>(view.camera)], truth[3] / 10)).norm(), 3);
}

/// As a person who places every joint where it is.
core::CorrectedFrame correctedAt(const SimulatedPass& scene, int frame) {
    core::CorrectedFrame corrected;
    corrected.frame = frame;
    for (std::size_t h = 0; h < 2; ++h) {
        const auto truth =
            core::jointPositions(scene.hands[h].skeleton, scene.motion[static_cast<std::size_t>(frame)][h]);
        for (std::size_t b = 0; b < truth.size(); ++b) {
            core::TriangulatedPoint point;
            point.pointInWorld = truth[b];
            point.covariance *= 0.2;
            corrected.joints[{scene.hands[h].side, scene.hands[h].skeleton.bones[b].name}] = point;
        }
    }
    return corrected;
}

TEST(Retracking, GoesFromACorrectedFrameToBothSidesUpToAReviewedOne) {
    SimulatedPass scene("retrack");
    const auto result =
        core::retrack(scene.hands, scene.cameras, correctedAt(scene, 50), framesFrom(47, 7), {52}, scene, options());
    std::vector<int> reached;
    for (const auto& [frame, fit] : result.fits) {
        reached.push_back(frame);
        EXPECT_LT(scene.errorMm(fit, result.hands, frame), 1.5) << frame;
    }
    EXPECT_EQ(reached, (std::vector{47, 48, 49, 50, 51}));
    EXPECT_EQ(scene.detectCalls, 0);
}

TEST(Retracking, TwoViewsDoNotTellTheNeighbours) {
    SimulatedPass scene("two views", 2);
    const auto result =
        core::retrack(scene.hands, scene.cameras, correctedAt(scene, 50), framesFrom(47, 7), {}, scene, options());
    ASSERT_EQ(result.fits.size(), 1u);
    EXPECT_LT(scene.errorMm(result.fits.at(50), result.hands, 50), 1.5);
}

/// A person who places the fingertips of a hand elsewhere is followed, whatever the silhouettes say.
TEST(Retracking, ThePersonsJointsCountMoreThanSilhouettes) {
    SimulatedPass scene("moved");
    auto corrected = correctedAt(scene, 50);
    for (auto& [id, point] : corrected.joints)
        if (id.hand == core::Side::Left)
            point.pointInWorld += Eigen::Vector3d(0, 0, 15);
    const auto result = core::retrack(scene.hands, scene.cameras, corrected, {50}, {}, scene, options());
    const auto joints = core::jointPositions(result.hands[0].skeleton, result.fits.at(50).hands[0].pose);
    const auto wrist = corrected.joints.at({core::Side::Left, result.hands[0].skeleton.bones[0].name}).pointInWorld;
    EXPECT_LT((joints[0] - wrist).norm(), 4);
}

} // namespace
