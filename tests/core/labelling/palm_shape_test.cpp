// SPDX-License-Identifier: MIT
#include "core/labelling/palm_shape.h"

#include <array>
#include <map>

#include <gtest/gtest.h>

#include "core/io/demo/demo_dataset.h"
#include "core/subject/hand_tips.h"
#include "tests/support/random_values.h"

namespace {

const std::array<const char*, 6> kPalm{"wrist", "thumb_cmc", "index_mcp", "middle_mcp", "ring_mcp", "little_mcp"};

/// A person whose knuckles are elsewhere than the model's: every finger moved as a whole, in the rest pose.
core::HandModel personOf(core::HandModel hand) {
    const std::map<std::string, Eigen::Vector3d> moved{{"index", {3, -4, 2}},
                                                       {"middle", {-2, 1, 5}},
                                                       {"ring", {1, 3, -3}},
                                                       {"little", {-5, 2, 2}},
                                                       {"thumb", {4, 2, 1}}};
    for (core::Bone& bone : hand.skeleton.bones) {
        const std::string finger = bone.name.substr(0, bone.name.find('_'));
        const bool isMoved = moved.contains(finger) && (finger == "thumb" || !bone.name.ends_with("_cmc"));
        if (isMoved)
            bone.worldFromBoneAtRest.translation += moved.at(finger);
    }
    return hand;
}

class PalmShape : public testing::Test {
protected:
    PalmShape()
        : model(core::withTips(demo().dataset.hands.back()))
        , person(personOf(model)) {}

    /// What is seen of the person in a frame of the demo: joints with that much noise.
    std::vector<core::JointTarget> seen(int frame, double noiseMm) const {
        test::RandomValues random("palm" + std::to_string(frame));
        const auto joints = core::jointPositions(person.skeleton, poseAt(frame));
        std::vector<core::JointTarget> targets;
        for (std::size_t b = 0; b < joints.size(); ++b) {
            const std::string& name = person.skeleton.bones[b].name;
            if (name.ends_with("_cmc") && name != "thumb_cmc")
                continue; // no detector knows these
            const Eigen::Vector3d noise(random.normal(), random.normal(), random.normal());
            targets.push_back({static_cast<int>(b), joints[b] + noiseMm * noise,
                               std::max(noiseMm * noiseMm, 0.01) * Eigen::Matrix3d::Identity()});
        }
        return targets;
    }
    std::vector<std::vector<core::JointTarget>> frames(int count, double noiseMm) const {
        std::vector<std::vector<core::JointTarget>> list;
        for (int i = 0; i < count; ++i)
            list.push_back(seen(7 * i, noiseMm));
        return list;
    }
    /// The largest difference between two hands of a distance between two joints of the palm, mm.
    static double palmDifferenceMm(const core::HandModel& a, const core::HandModel& b) {
        const auto ofA = core::jointPositions(a.skeleton, a.skeleton.restPose()),
                   ofB = core::jointPositions(b.skeleton, b.skeleton.restPose());
        double most = 0;
        for (const char* from : kPalm)
            for (const char* to : kPalm) {
                const auto i = static_cast<std::size_t>(a.skeleton.boneIndex(from)),
                           j = static_cast<std::size_t>(a.skeleton.boneIndex(to));
                most = std::max(most, std::abs((ofA[i] - ofA[j]).norm() - (ofB[i] - ofB[j]).norm()));
            }
        return most;
    }
    static const core::NewDataset& demo() {
        static const core::NewDataset made = core::makeDemoDataset();
        return made;
    }
    static const core::Pose& poseAt(int frame) {
        return demo().motions.front()[static_cast<std::size_t>(frame)].back();
    }

    const core::LandmarkFitOptions options{.areJoints = true, .modelSigmaMm = 0.5, .priorSigmaRad = 2};
    core::HandModel model, person;
};

TEST_F(PalmShape, IsFoundFromFramesOfJoints) {
    EXPECT_GT(palmDifferenceMm(model, person), 6);
    EXPECT_LT(palmDifferenceMm(core::withPalmOf(model, frames(15, 0), options), person),
              2); // metacarpals bend a little
    EXPECT_LT(palmDifferenceMm(core::withPalmOf(model, frames(15, 2), options), person), 2);
}

/// In frames that it was not measured from, too.
TEST_F(PalmShape, BringsTheModelToTheJointsOfOtherFrames) {
    const core::HandModel shaped = core::withPalmOf(model, frames(15, 0), options);
    const auto rmsMm = [&](const core::HandModel& hand, int frame) {
        const auto targets = seen(frame, 0);
        const auto fit = core::fitToTargets(hand, targets, core::usualStarts(hand.skeleton), options);
        const auto joints = core::jointPositions(hand.skeleton, fit->pose);
        double sum = 0;
        for (const core::JointTarget& target : targets)
            sum += (joints[static_cast<std::size_t>(target.bone)] - target.pointInWorld).squaredNorm();
        return std::sqrt(sum / static_cast<double>(targets.size()));
    };
    for (const int frame : {115, 130, 145})
        EXPECT_LT(rmsMm(shaped, frame), 0.4 * rmsMm(model, frame)) << frame;
}

/// Fingers keep their lengths, and the surface goes along with the joints.
TEST_F(PalmShape, MovesWholeFingers) {
    const core::HandModel shaped = core::withPalmOf(model, frames(15, 0), options);
    const auto before = core::jointPositions(model.skeleton, model.skeleton.restPose()),
               after = core::jointPositions(shaped.skeleton, shaped.skeleton.restPose());
    const auto mcp = static_cast<std::size_t>(model.skeleton.boneIndex("index_mcp")),
               tip = static_cast<std::size_t>(model.skeleton.boneIndex("index_tip"));
    EXPECT_NEAR((before[tip] - before[mcp]).norm(), (after[tip] - after[mcp]).norm(), 1e-9);
    const int dip = model.skeleton.boneIndex("index_dip");
    for (std::size_t v = 0; v < model.mesh.vertices.size(); ++v) {
        const auto first = static_cast<std::size_t>(model.weights.firstEntry[v]);
        if (model.weights.firstEntry[v + 1] == model.weights.firstEntry[v] + 1 &&
            model.weights.entries[first].bone == dip) {
            EXPECT_LT((shaped.mesh.vertices[v] - model.mesh.vertices[v] - (after[tip] - before[tip])).norm(), 1e-9);
            return;
        }
    }
    FAIL() << "no vertex belongs to the end of the index finger alone";
}

TEST_F(PalmShape, OfTwoFramesStaysTheModels) {
    EXPECT_EQ(palmDifferenceMm(core::withPalmOf(model, frames(2, 0), options), model), 0);
}

} // namespace
