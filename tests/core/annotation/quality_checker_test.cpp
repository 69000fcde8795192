// SPDX-License-Identifier: MIT
#include "core/annotation/quality_checker.h"

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"
#include "tests/support/clicks.h"
#include "tests/support/five_finger_skeleton.h"

namespace {

using core::JointId;
using core::QualityFinding;
using core::QualityKind;
using core::Side;
using Eigen::Vector3d;

using test::kRater;

class Quality : public testing::Test {
protected:
    Quality() {
        for (const Side side : {Side::Left, Side::Right}) {
            core::HandModel hand;
            hand.side = side;
            hand.skeleton = test::fiveFingerSkeleton(side);
            m_hands.push_back(hand);
        }
    }
    /// Two hands side by side in every tenth frame, fingers bending more and more.
    std::map<int, std::map<JointId, Vector3d>> goodJoints() {
        std::map<int, std::map<JointId, Vector3d>> frames;
        for (int frame = 0; frame <= 40; frame += 10) {
            for (const core::HandModel& hand : m_hands) {
                core::Pose pose = test::curledPose(hand.skeleton, 0.2 + 0.01 * frame);
                pose.head<3>() = Vector3d(-80, hand.side == Side::Left ? 70 : -70, 0.2 * frame);
                const auto joints = core::jointPositions(hand.skeleton, pose);
                for (std::size_t b = 0; b < joints.size(); ++b)
                    frames[frame][{hand.side, hand.skeleton.bones[b].name}] = joints[b];
            }
        }
        return frames;
    }
    std::vector<QualityFinding> findingsOf(const std::map<int, std::map<JointId, Vector3d>>& frames) {
        m_set = {};
        for (const auto& [frame, joints] : frames)
            for (const auto& [id, point] : joints)
                test::clickEverywhere(m_set, m_cameras, frame, kRater, id, point, 0.3, &m_random);
        return core::checkSequence(m_set, m_cameras, kRater, m_hands);
    }
    static std::vector<QualityFinding> ofKind(std::vector<QualityFinding> findings, QualityKind kind) {
        std::erase_if(findings, [kind](const QualityFinding& finding) { return finding.kind != kind; });
        return findings;
    }

    std::vector<core::Camera> m_cameras = test::cameraRing(8);
    std::vector<core::HandModel> m_hands;
    core::AnnotationSet m_set;
    std::mt19937_64 m_random = test::randomFor("Quality");
};

TEST_F(Quality, FindsNothingInGoodHands) {
    const auto findings = findingsOf(goodJoints());
    EXPECT_TRUE(findings.empty()) << findings.front().text;
}

TEST_F(Quality, NamesTheBoneWhoseLengthIsOff) {
    auto frames = goodJoints();
    Vector3d& tip = frames[20][{Side::Left, "ring_tip"}];
    const Vector3d dip = frames[20][{Side::Left, "ring_dip"}];
    tip = dip + 1.25 * (tip - dip);
    const auto findings = findingsOf(frames);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].kind, QualityKind::BoneLength);
    EXPECT_EQ(findings[0].frame, 20);
    EXPECT_EQ(findings[0].joint, (JointId{Side::Left, "ring_tip"}));
    EXPECT_NEAR(findings[0].value, 25, 3);
    EXPECT_NE(findings[0].text.find("ring_dip to ring_tip"), std::string::npos);
}

TEST_F(Quality, NamesTheClickThatDisagreesAndTheJointWithoutAPoint) {
    findingsOf(goodJoints());
    m_set.marks.at({30, kRater, {Side::Right, "index_pip"}, "cam5"}).px.x() += 40;
    for (const char* camera : {"cam0", "cam1", "cam2", "cam3", "cam4", "cam6"})
        m_set.marks.erase({30, kRater, {Side::Right, "wrist"}, camera});
    m_set.marks.at({30, kRater, {Side::Right, "wrist"}, "cam7"}).px.y() += 60;
    const auto findings = ofKind(core::checkSequence(m_set, m_cameras, kRater, m_hands), QualityKind::Disagreement);
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(findings[0].camera, "cam5");
    EXPECT_NEAR(findings[0].value, 40, 3);
    EXPECT_EQ(findings[1].joint.joint, "wrist");
    EXPECT_NE(findings[1].text.find("no point from 2 views"), std::string::npos) << findings[1].text;
    EXPECT_NE(findings[1].text.find("px off"), std::string::npos) << findings[1].text;
}

TEST_F(Quality, FindsTwoJointsOnOnePixel) {
    findingsOf(goodJoints());
    const auto there = m_set.marks.at({10, kRater, {Side::Left, "index_dip"}, "cam2"});
    m_set.marks.at({10, kRater, {Side::Left, "middle_dip"}, "cam2"}).px = there.px + Eigen::Vector2d(0.5, 0);
    const auto findings = ofKind(core::checkSequence(m_set, m_cameras, kRater, m_hands), QualityKind::SharedPixel);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].camera, "cam2");
    EXPECT_NEAR(findings[0].value, 0.5, 1e-9);
    EXPECT_NE(findings[0].text.find("index_dip"), std::string::npos);
}

TEST_F(Quality, FindsFingersThatWereExchanged) {
    auto frames = goodJoints();
    for (const char* joint : {"_mcp", "_pip", "_dip", "_tip"}) { // the whole finger: knuckles are out of order
        std::swap(frames[20][{Side::Right, std::string("middle") + joint}],
                  frames[20][{Side::Right, std::string("ring") + joint}]);
    }
    for (const char* joint : {"_pip", "_dip", "_tip"}) { // all but the knuckle
        std::swap(frames[30][{Side::Left, std::string("ring") + joint}],
                  frames[30][{Side::Left, std::string("little") + joint}]);
    }
    const auto findings = ofKind(findingsOf(frames), QualityKind::FingerOrder);
    ASSERT_GE(findings.size(), 2u);
    EXPECT_EQ(findings.front().frame, 20);
    EXPECT_EQ(findings.front().joint.hand, Side::Right);
    EXPECT_EQ(findings.back().frame, 30);
    EXPECT_NE(findings.back().text.find("little_pip"), std::string::npos);
}

TEST_F(Quality, FindsHandsThatWereExchangedFromAFrameOn) {
    auto frames = goodJoints();
    for (auto& [id, point] : frames[30])
        if (id.hand == Side::Left)
            std::swap(point, frames[30][{Side::Right, id.joint}]);
    const auto findings = ofKind(findingsOf(frames), QualityKind::HandMixUp);
    const auto at30 =
        std::count_if(findings.begin(), findings.end(), [](const QualityFinding& f) { return f.frame == 30; });
    EXPECT_EQ(at30, 3); // exchanged since the frame before; and the fingers of both, well bent, bend backwards
    EXPECT_TRUE(std::any_of(findings.begin(), findings.end(),
                            [](const QualityFinding& f) { return f.text.find("exchanged") != std::string::npos; }));
}

TEST_F(Quality, FindsTheWrongHandByTheWayItsFingersBend) {
    for (const Side side : {Side::Left, Side::Right}) {
        auto frames = goodJoints();
        std::map<int, std::map<JointId, Vector3d>> one;
        for (const auto& [frame, joints] : frames) {
            for (const auto& [id, point] : joints)
                if (id.hand == side) // filed under the other hand, alone in the picture
                    one[frame][{side == Side::Left ? Side::Right : Side::Left, id.joint}] = point;
        }
        const auto findings = ofKind(findingsOf(one), QualityKind::HandMixUp);
        EXPECT_GE(findings.size(), 3u); // those frames in which they bend enough
        for (const QualityFinding& finding : findings)
            EXPECT_NE(finding.text.find("other hand"), std::string::npos);
    }
}

TEST_F(Quality, AFrameLookedAtAgainIsAsGoodAsALookAtEverything) {
    findingsOf(goodJoints());
    core::QualityChecker checker(m_cameras, m_hands, kRater);
    for (const int frame : core::annotatedFrames(m_set))
        checker.check(m_set, frame);
    EXPECT_TRUE(checker.findings().empty());
    for (auto& [key, mark] : m_set.marks) // a finger of frame 20 moves: its bones, and a click
        mark.px.x() += key.frame == 20 && key.joint == JointId{Side::Left, "ring_tip"} ? 25 : 0;
    m_set.marks.at({20, kRater, {Side::Right, "index_pip"}, "cam5"}).px.x() += 40;
    std::erase_if(m_set.marks, [](const auto& entry) { return entry.first.frame == 40; });
    checker.check(m_set, 20);
    checker.check(m_set, 40);
    EXPECT_FALSE(checker.findings().empty());
    EXPECT_EQ(checker.findings(), core::checkSequence(m_set, m_cameras, kRater, m_hands));
    EXPECT_EQ(checker.points().size(), 4u);
}

TEST_F(Quality, FindsAnglesBeyondTheLimits) {
    auto frames = goodJoints();
    const core::Skeleton& skeleton = m_hands[1].skeleton;
    core::Pose pose = test::curledPose(skeleton, 0.4);
    for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
        if (skeleton.dofs[d].name == "middle_pip.flexion") {
            pose[core::kRigidDofs + static_cast<Eigen::Index>(d)] =
                skeleton.dofs[d].minRad - 0.5; // 29 degrees too far back
        }
    }
    const auto joints = core::jointPositions(skeleton, pose);
    for (std::size_t b = 0; b < joints.size(); ++b)
        frames[20][{Side::Right, skeleton.bones[b].name}] = joints[b];
    const auto findings = ofKind(findingsOf(frames), QualityKind::JointAngle);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].joint, (JointId{Side::Right, "middle_pip"}));
    EXPECT_EQ(findings[0].frame, 20);
    EXPECT_NEAR(findings[0].value, 28.6, 5);
}

TEST_F(Quality, MarksOutsideThePictureAreListed) {
    findingsOf(goodJoints());
    const JointId joint{Side::Left, "index_mcp"};
    m_set.marks[{10, kRater, joint, "cam1"}].px = {-30, 50};
    m_set.marks[{20, kRater, joint, "cam1"}] = {{-30, 50}, core::Placement::Proposed, core::MarkState::Visible};
    const auto found = ofKind(core::checkSequence(m_set, m_cameras, kRater, m_hands), QualityKind::OutsidePicture);
    ASSERT_EQ(found.size(), 1u) << "a proposal belongs to no rater";
    EXPECT_EQ(found[0].frame, 10);
    EXPECT_EQ(found[0].joint, joint);
    EXPECT_EQ(found[0].camera, "cam1");
    EXPECT_EQ(found[0].value, 30);
}

} // namespace
