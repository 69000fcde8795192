// SPDX-License-Identifier: MIT
#include "core/subject/subject_estimate.h"

#include <gtest/gtest.h>

#include "core/contour/rasteriser.h"
#include "core/error.h"
#include "tests/support/camera_ring.h"
#include "tests/support/two_finger_hand.h"

namespace {

/// Frames of a hand that differs from the model in a known way, as cameras see it: exact joints and silhouettes.
struct SubjectScene {
    std::vector<core::HandModel> models{test::twoFingerHand(core::Side::Left)};
    std::vector<core::Camera> cameras;
    std::vector<core::SubjectFrame> frames;

    SubjectScene(const core::HandModel& truth, int frameCount, bool withOutlines) {
        for (const core::Camera& camera : test::cameraRing(5))
            cameras.push_back(core::cropped(camera, {0, 0}, {540, 960}, 0.5));
        test::RandomValues random("subject scene");
        for (int f = 0; f < frameCount; ++f) {
            const core::Pose pose = test::somePose(truth.skeleton, random);
            core::SubjectFrame& frame = frames.emplace_back();
            const auto joints = core::jointPositions(truth.skeleton, pose);
            auto& targets = frame.targets.emplace_back();
            for (int b = 0; b < 5; ++b)
                targets.push_back({b, joints[static_cast<std::size_t>(b)], 0.01 * Eigen::Matrix3d::Identity()});
            std::vector<cv::Mat> masks;
            for (const core::Camera& camera : cameras)
                masks.push_back(core::renderHandsMask(camera, {truth}, {pose}));
            if (withOutlines)
                frame.outlines = core::makeFitTargets(cameras, masks, {}, 1);
        }
    }
};

TEST(SubjectEstimate, FindsScaleLengthsAndGirthOfAnotherHand) {
    const core::ShapeSpace space(test::twoFingerHand(core::Side::Left));
    core::HandShape shape = space.modelShape();
    shape[0] = std::log(1.03);
    shape[1] = 1;
    shape[space.lengthIndex(1)] = 0.03;
    const SubjectScene scene(space.shaped(shape), 5, true);
    const core::SubjectResult result = core::estimateSubject(scene.models, scene.cameras, scene.frames);
    ASSERT_EQ(result.hands.size(), 1u);
    EXPECT_EQ(result.outlineFrames, 5);
    EXPECT_FALSE(result.lengthsKept);
    EXPECT_NEAR(result.hands[0].girthMm.value, 1, 0.3);
    for (int a = 0; a < space.segmentCount(); ++a)
        if (space.segments()[static_cast<std::size_t>(a)].end >= 0)
            EXPECT_NEAR(result.hands[0].bones[static_cast<std::size_t>(a)].lengthMm, space.lengthMm(a, shape), 0.3);
}

TEST(SubjectEstimate, ThreeFramesWithoutMasksGiveTheScaleAndKeepTheProportions) {
    const core::ShapeSpace space(test::twoFingerHand(core::Side::Left));
    core::HandShape shape = space.modelShape();
    shape[0] = std::log(0.95);
    const SubjectScene scene(space.shaped(shape), 3, false);
    const core::SubjectResult result = core::estimateSubject(scene.models, scene.cameras, scene.frames);
    EXPECT_TRUE(result.lengthsKept);
    EXPECT_EQ(result.outlineFrames, 0);
    EXPECT_NEAR(result.hands[0].scale.value, 0.95, 0.003);
    EXPECT_NEAR(result.hands[0].girthMm.value, 0, 1e-6);
    EXPECT_NEAR(core::annotatedOverModelLength(scene.models, scene.frames), 0.95, 1e-6);
}

TEST(SubjectEstimate, OneFrameGivesTheScaleAlone) {
    const core::ShapeSpace space(test::twoFingerHand(core::Side::Left));
    core::HandShape shape = space.modelShape();
    shape[0] = std::log(1.05);
    shape[1] = 1;
    const SubjectScene scene(space.shaped(shape), 1, true);
    const core::SubjectResult result = core::estimateSubject(scene.models, scene.cameras, scene.frames);
    EXPECT_TRUE(result.girthKept);
    EXPECT_EQ(result.outlineFrames, 0);
    EXPECT_NEAR(result.hands[0].scale.value, 1.05, 0.005);
    EXPECT_NEAR(result.hands[0].girthMm.value, 0, 1e-6);
}

TEST(SubjectEstimate, NoFrameIsRefusedInWords) {
    SubjectScene scene(test::twoFingerHand(core::Side::Left), 2, false);
    for (core::SubjectFrame& frame : scene.frames)
        frame.targets[0].resize(3);
    try {
        core::estimateSubject(scene.models, scene.cameras, scene.frames);
        FAIL();
    } catch (const core::Error& error) {
        EXPECT_EQ(error.detail(),
                  "a frame with 4 or more joints of a hand in 3D is needed to measure it, and there is none");
    }
}

} // namespace
