// SPDX-License-Identifier: MIT
#include "core/rig/rig_findings.h"

#include <gtest/gtest.h>

#include "tests/core/rig/rig_scene.h"

namespace {

using test::RigScene;

TEST(RigResiduals, OfALeftOutViewAreThoseOfATriangulationWithoutIt) {
    RigScene scene("LeftOut");
    scene.loosen();
    const auto joints = scene.clicks({7}, 0.5);
    const core::RigResiduals rig = core::computeRigResiduals(scene.nominal, joints);
    ASSERT_EQ(rig.clicks.size(), 14u * 8);
    for (const core::RigResidual& click : rig.clicks) {
        // Oracle: the weighted point of the others, by Gauss-Newton.
        std::vector<core::Observation> others;
        for (const core::RigResidual& other : rig.clicks)
            if (other.joint == click.joint && other.camera != click.camera)
                others.push_back({other.camera, other.px,
                                  rig.spreadPx[static_cast<std::size_t>(other.camera)] / std::sqrt(other.weight)});
        const auto point =
            core::refinePoint(scene.nominal, others, rig.pointInWorld[static_cast<std::size_t>(click.joint)]);
        ASSERT_TRUE(point);
        const auto px = core::project(scene.nominal[static_cast<std::size_t>(click.camera)], *point);
        EXPECT_LT((click.px - *px - click.leftOutPx).norm(), 0.03 + 0.01 * click.leftOutPx.norm());
    }
}

TEST(RigHealth, AnExactRigHasNoFindings) {
    RigScene scene("Exact");
    const core::RigHealth health = core::judgeRig(scene.nominal, scene.clicks(RigScene::frames(6, 10)));
    EXPECT_TRUE(health.isKnown);
    EXPECT_TRUE(core::rigFindings(health).empty());
    for (const core::CameraHealth& camera : health.cameras) {
        EXPECT_LT(camera.meanPx.norm(), 0.5);
        EXPECT_NEAR(camera.scatterPx, 1.08, 0.25); // a click's 1 px, and the others' part of the point
        EXPECT_EQ(camera.clicks, 6 * 14);
    }
}

TEST(RigHealth, NamesTheCameraThatMovedAndHowFar) {
    RigScene scene("Moved");
    scene.turn(5, {0.18, -0.22, 0});
    const core::RigHealth health = core::judgeRig(scene.nominal, scene.clicks(RigScene::frames(6, 10)));
    const auto middle = Eigen::Vector3d(0, 0, 0);
    const Eigen::Vector2d shift = *core::project(scene.seen[5], middle) - *core::project(scene.nominal[5], middle);
    ASSERT_GT(shift.norm(), 8);
    for (std::size_t c = 0; c < health.cameras.size(); ++c)
        EXPECT_EQ(health.cameras[c].isOff, c == 5) << c;
    EXPECT_LT((health.cameras[5].meanPx - shift).norm(), 0.6);
    const auto findings = core::rigFindings(health);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_NE(findings[0].find("cam5 is "), std::string::npos) << findings[0];
    EXPECT_NE(findings[0].find("px off in every frame: its calibration moved"), std::string::npos) << findings[0];
}

TEST(RigHealth, ARigThatIsOffAsAWholeIsOneSentence) {
    RigScene scene("WholeRig");
    scene.loosen(3);
    const core::RigHealth health = core::judgeRig(scene.nominal, scene.clicks(RigScene::frames(6, 10)));
    const auto faults = core::findRigFaults(health);
    ASSERT_GT(faults.size(), 4u);
    EXPECT_EQ(faults.front().kind, core::RigFindingKind::WholeRigOff);
    const auto findings = core::rigFindings(health);
    ASSERT_EQ(findings.size(), 1u) << findings[1];
    EXPECT_NE(findings[0].find("the calibration as a whole does not fit the clicks"), std::string::npos);
}

TEST(RigHealth, WrongClicksAreNotTakenForAMovedCamera) {
    RigScene scene("Wrong");
    auto joints = scene.clicks(RigScene::frames(6, 10));
    for (std::size_t j = 0; j < joints.size(); j += 12)
        joints[j].clicks[3].px += Eigen::Vector2d(70, -40);
    const core::RigHealth health = core::judgeRig(scene.nominal, joints);
    EXPECT_FALSE(health.anyOff());
    EXPECT_EQ(health.cameras[3].wrongClicks, 7);
    EXPECT_EQ(health.cameras[2].wrongClicks, 0);
}

TEST(RigHealth, ALatePictureIsTakenForThatAndNotForAMovedCamera) {
    RigScene scene("Late");
    const auto joints = scene.clicks(RigScene::frames(40, 2), 0.5, 2, 1.5);
    const core::RigHealth health = core::judgeRig(scene.nominal, joints);
    ASSERT_TRUE(health.cameras[2].delayFrames);
    EXPECT_NEAR(*health.cameras[2].delayFrames, 1.5, 0.1);
    EXPECT_TRUE(health.cameras[2].isLate);
    EXPECT_FALSE(health.anyOff());
    for (std::size_t c = 0; c < health.cameras.size(); ++c)
        EXPECT_EQ(health.cameras[c].isLate, c == 2) << c << " " << *health.cameras[c].delayFrames;
}

TEST(RigHealth, WhatCannotBeKnownIsSaid) {
    RigScene scene("Few");
    auto joints = scene.clicks(RigScene::frames(4, 10));
    int kept = 0;
    for (core::RigJoint& joint : joints)
        std::erase_if(joint.clicks,
                      [&kept](const core::Observation& click) { return click.camera == 6 && ++kept > 3; });
    const core::RigHealth health = core::judgeRig(scene.nominal, joints);
    EXPECT_FALSE(health.cameras[6].isKnown);
    EXPECT_EQ(core::rigFindings(health).back(),
              "cannot be known of cam6 (3 clicks): too few clicks that others confirm");
    EXPECT_FALSE(core::judgeRig(scene.nominal, {}).isKnown);
}

/// Clicks of a camera that stands as in `seen` from `frame` on, and as in `nominal` before.
std::vector<core::RigJoint> clicksOfMove(RigScene& scene, std::size_t camera, int frame, int last, int step = 8) {
    const core::Camera moved = scene.seen[camera];
    scene.seen[camera] = scene.nominal[camera];
    auto joints = scene.clicks(RigScene::frames(frame / step, step));
    scene.seen[camera] = moved;
    const auto after = scene.clicks(RigScene::frames((last - frame) / step, step, frame));
    joints.insert(joints.end(), after.begin(), after.end());
    return joints;
}

TEST(RigHealth, ACameraThatMovesInASequenceIsToldFromOneThatIsOffAlways) {
    RigScene scene("Moves");
    scene.turn(5, {0.1, -0.1, 0});
    const core::RigHealth health = core::judgeRig(scene.nominal, clicksOfMove(scene, 5, 48, 96));
    EXPECT_TRUE(health.cameras[5].hasMoved);
    EXPECT_FALSE(health.cameras[5].isOff);
    EXPECT_FALSE(health.cameras[5].isDrifting);
    const auto faults = core::findRigFaults(health);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].kind, core::RigFindingKind::CameraMoved);
    EXPECT_EQ(faults[0].camera, 5);
    EXPECT_EQ(faults[0].frame, 48);
    EXPECT_EQ(faults[0].sequence, 0);
    const Eigen::Vector2d shift =
        *core::project(scene.seen[5], {0, 0, 0}) - *core::project(scene.nominal[5], {0, 0, 0});
    EXPECT_NEAR(faults[0].value, shift.norm(), 0.5);
    EXPECT_NE(core::rigFindings(health)[0].find("cam5 moved before frame 48: its picture lies"), std::string::npos);
}

TEST(RigHealth, ASlowDriftIsToldFromAMove) {
    RigScene scene("Drifts");
    std::vector<core::RigJoint> joints;
    for (int frame = 0; frame < 100; frame += 8) {
        scene.seen[2] = scene.nominal[2];
        scene.turn(2, {0.0015 * frame, 0.001 * frame, 0});
        const auto more = scene.clicks({frame});
        joints.insert(joints.end(), more.begin(), more.end());
    }
    const core::RigHealth health = core::judgeRig(scene.nominal, joints);
    for (std::size_t c = 0; c < 8; ++c) {
        EXPECT_EQ(health.cameras[c].isDrifting, c == 2) << c;
        EXPECT_FALSE(health.cameras[c].hasMoved) << c;
    }
    const Eigen::Vector2d shift =
        *core::project(scene.seen[2], {0, 0, 0}) - *core::project(scene.nominal[2], {0, 0, 0});
    ASSERT_TRUE(health.cameras[2].driftPx);
    EXPECT_LT((*health.cameras[2].driftPx - shift / 0.96).norm(), 0.8);
    const auto faults = core::findRigFaults(health);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].kind, core::RigFindingKind::CameraDrifts);
}

TEST(RigHealth, ACameraThatWasMovedBetweenSequencesIsOffInThoseOnly) {
    RigScene scene("Between");
    auto joints = scene.clicks(RigScene::frames(6, 10));
    scene.turn(5, {0.1, -0.1, 0});
    auto later = scene.clicks(RigScene::frames(6, 10));
    for (core::RigJoint& joint : later)
        joint.sequence = 1;
    joints.insert(joints.end(), later.begin(), later.end());
    const auto faults = core::findRigFaults(core::judgeRig(scene.nominal, joints));
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].kind, core::RigFindingKind::CameraOffInSequence);
    EXPECT_EQ(faults[0].camera, 5);
    EXPECT_EQ(faults[0].sequences, std::vector<int>{1});
    EXPECT_NE(core::rigFindings(core::judgeRig(scene.nominal, joints), {"a", "b"})[0].find(
                  "px off in sequence b only: it stood otherwise there"),
              std::string::npos);
}

TEST(RigHealth, ALooseRigSeemsNotToMove) {
    for (int seed = 0; seed < 6; ++seed) {
        RigScene scene("Loose" + std::to_string(seed));
        scene.loosen(2);
        for (const core::CameraHealth& camera :
             core::judgeRig(scene.nominal, scene.clicks(RigScene::frames(12, 8))).cameras) {
            EXPECT_FALSE(camera.hasMoved) << camera.camera << " " << seed;
            EXPECT_FALSE(camera.isDrifting) << camera.camera << " " << seed;
        }
    }
}

} // namespace
