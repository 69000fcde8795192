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

/// A detector that takes the hands for smaller ones than they are.
TEST(LabelPass, SilhouettesSayWhetherLandmarksShowAnotherHand) {
    SimulatedPass scene("landmarks off");
    scene.seenScale = 0.88;
    auto settings = options(true);
    settings.keyEveryFrames = 12;
    settings.mostPilots = 3;
    const auto frames = framesFrom(20, 3, 12);
    const auto result = core::runLabelPass(scene.hands, scene.cameras, frames, scene, settings);
    ASSERT_EQ(result.measured.size(), 2u);
    for (const core::SubjectHand& hand : result.measured)
        EXPECT_NEAR(hand.scale.value, 1, 0.012);
    for (const int frame : frames) {
        EXPECT_LT(scene.errorMm(result.fits.at(frame), result.hands, frame), 2) << frame;
        EXPECT_LT(result.fits.at(frame).doubt(), 0.5) << frame;
    }
}

TEST(LabelPass, HandsOfAPersonThatCouldNotBeMeasuredAreDoubted) {
    test::SimulatedPass scene("unmeasured");
    const std::vector<int> frames{10, 20, 30};
    for (const int frame : frames) {
        core::FrameFit fit;
        fit.source = core::FitSource::Silhouettes;
        for (const core::Pose& pose : scene.motion[static_cast<std::size_t>(frame)])
            fit.hands.push_back({pose, {}, frame == 10 ? 0.2 : 0.4}); // one pilot is sure, two are not
        for (std::size_t h = 0; h < fit.hands.size(); ++h)
            fit.hands[h].jointCovarianceMm2.assign(core::withTips(scene.hands[h]).skeleton.bones.size(),
                                                   Eigen::Matrix3d::Identity());
        scene.remember("pilot", frame, fit);
        scene.remember("key", frame, fit);
    }
    const auto result = core::runLabelPass(scene.hands, scene.cameras, frames, scene, options(true));
    EXPECT_TRUE(result.measured.empty());
    EXPECT_NEAR(result.fits.at(10).doubt(), 0.6, 1e-9);
    EXPECT_NEAR(result.fits.at(20).doubt(), 0.7, 1e-9);
}

TEST(LabelPass, OfTwoViewsKeepsToTheLandmarks) {
    SimulatedPass scene("two views", 2);
    const auto result = core::runLabelPass(scene.hands, scene.cameras, {30}, scene, options());
    EXPECT_EQ(result.fits.at(30).source, FitSource::Landmarks);
    EXPECT_LT(scene.errorMm(result.fits.at(30), result.hands, 30), 15);
    for (const core::AutoHand& hand : core::autoHands(result, 30, scene.cameras))
        EXPECT_GE(hand.doubt, 0.5);
}

/// Nothing can be tracked between key frames there: the detector looks at every frame.
TEST(LabelPass, OfTwoViewsLabelsEveryFrame) {
    SimulatedPass scene("every frame", 2);
    const auto frames = framesFrom(30, 4);
    const auto result = core::runLabelPass(scene.hands, scene.cameras, frames, scene, options());
    for (const int frame : frames) {
        ASSERT_EQ(result.fits.count(frame), 1u) << frame;
        EXPECT_FALSE(result.fits.at(frame).isEmpty()) << frame;
    }
    EXPECT_EQ(scene.detectCalls, 4);
    EXPECT_EQ(scene.evidenceCalls, 0);
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

/// Doubts do not tell which of two doubtful labels is right, silhouettes do.
TEST(Retracking, KeepsALabelInDoubtThatExplainsTheSilhouettesBetter) {
    SimulatedPass scene("in doubt", 4);
    auto corrected = correctedAt(scene, 50);
    auto settings = options();
    settings.leastDoubt = 0; // every fit is in doubt
    const auto placesOf = [&](int frame) {
        std::map<core::JointId, Eigen::Vector3d> places;
        for (const auto& [id, point] : correctedAt(scene, frame).joints)
            places[id] = point.pointInWorld;
        return places;
    };
    constexpr int kNext = 51;
    const auto reached = [&](const core::CorrectedFrame& from) {
        return core::retrack(scene.hands, scene.cameras, from, {50, kNext}, {}, scene, settings).fits;
    };
    auto lost = corrected; // hands that tracking does not find from there
    for (auto& [id, point] : lost.joints)
        point.pointInWorld += Eigen::Vector3d(id.hand == core::Side::Left ? -150 : 150, 0, 0);
    const auto without = reached(lost);
    ASSERT_EQ(without.count(kNext), 1u);
    ASSERT_GT(scene.errorMm(without.at(kNext), scene.hands, kNext), 5) << "tracking finds them from there";
    lost.labelsAt = placesOf;
    EXPECT_EQ(reached(lost).count(kNext), 0u) << "a right label is replaced by a wrong one";
    corrected.labelsAt = [&](int) { return placesOf(kNext + 40); };
    const auto found = reached(corrected);
    ASSERT_EQ(found.count(kNext), 1u) << "a wrong label stays";
    EXPECT_LT(scene.errorMm(found.at(kNext), scene.hands, kNext), 1.5);
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

/// A finger that a program has bent where it is straight, in four views: the person places one joint of it.
class WrongFinger : public testing::Test {
protected:
    static constexpr int kFrame = 50;
    WrongFinger() {
        core::HandPoses wrong = scene.motion[kFrame];
        const core::Skeleton& skeleton = scene.hands[0].skeleton;
        for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
            const core::DegreeOfFreedom& dof = skeleton.dofs[d];
            const std::string& name = skeleton.bones[static_cast<std::size_t>(dof.bone)].name;
            if (name.starts_with("index") && dof.maxRad - dof.minRad > 1) {
                double& angle = wrong[0][core::kRigidDofs + static_cast<Eigen::Index>(d)];
                const double bent = -dof.minRad > dof.maxRad ? dof.minRad : dof.maxRad;
                angle = std::abs(angle - 0.8 * bent) > 0.4 ? 0.8 * bent : 0;
            }
        }
        corrected.frame = kFrame;
        for (std::size_t h = 0; h < 2; ++h) {
            const auto joints = core::jointPositions(scene.hands[h].skeleton, wrong[h]);
            for (std::size_t b = 0; b < joints.size(); ++b)
                corrected.guesses[{scene.hands[h].side, scene.hands[h].skeleton.bones[b].name}] = joints[b];
        }
    }
    Eigen::Vector3d truth(int frame, const std::string& joint) const {
        const core::Skeleton& skeleton = scene.hands[0].skeleton;
        return core::jointPositions(
            skeleton,
            scene.motion[static_cast<std::size_t>(frame)][0])[static_cast<std::size_t>(skeleton.boneIndex(joint))];
    }
    void place(const std::string& joint) {
        const core::JointId id{core::Side::Left, joint};
        core::TriangulatedPoint point;
        point.pointInWorld = truth(kFrame, joint);
        point.covariance = 0.3 * Eigen::Matrix3d::Identity();
        corrected.joints[id] = point;
        corrected.guesses.erase(id);
    }
    /// Mean over the joints of the finger beyond the knuckle.
    double errorMm(const core::PassResult& result, int frame) const {
        const core::Skeleton& skeleton = result.hands[0].skeleton;
        const auto joints = core::jointPositions(skeleton, result.fits.at(frame).hands[0].pose);
        double sum = 0;
        for (const char* name : {"index_pip", "index_dip"})
            sum += (joints[static_cast<std::size_t>(skeleton.boneIndex(name))] - truth(frame, name)).norm() / 2;
        return sum;
    }
    double guessErrorMm() const {
        double sum = 0;
        for (const char* name : {"index_pip", "index_dip"})
            sum += (corrected.guesses.at({core::Side::Left, name}) - truth(kFrame, name)).norm() / 2;
        return sum;
    }

    SimulatedPass scene{"wrong finger", 4};
    core::CorrectedFrame corrected;
};

TEST_F(WrongFinger, FollowsTheOneJointOfItThatIsPlacedThereAndInTheNextFrames) {
    ASSERT_GT(guessErrorMm(), 10);
    place("index_dip");
    const auto result =
        core::retrack(scene.hands, scene.cameras, corrected, framesFrom(kFrame - 2, 5), {}, scene, options());
    ASSERT_EQ(result.fits.size(), 5u);
    for (const auto& [frame, fit] : result.fits)
        EXPECT_LT(errorMm(result, frame), 3) << frame;
}

/// With two views no silhouettes are used: the joint alone says how the finger lies.
TEST_F(WrongFinger, FollowsTheJointWithoutSilhouettes) {
    place("index_dip");
    SimulatedPass two("wrong finger", 2);
    const auto result = core::retrack(two.hands, two.cameras, corrected, {kFrame}, {}, two, options());
    EXPECT_LT(errorMm(result, kFrame), 6);
    const core::Skeleton& skeleton = result.hands[0].skeleton;
    const auto joints = core::jointPositions(skeleton, result.fits.at(kFrame).hands[0].pose);
    EXPECT_LT((joints[static_cast<std::size_t>(skeleton.boneIndex("index_dip"))] - truth(kFrame, "index_dip")).norm(),
              1.5);
}

} // namespace
