// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/subject/subject_estimate.h"
#include "tests/support/five_finger_skeleton.h"
#include "tests/support/random_values.h"

namespace {

constexpr double kClickSigmaMm = 0.4;

/// Both hands of a person without a surface, and joints that are clicked with noise.
struct Person {
    std::vector<core::HandModel> models{2};
    std::vector<core::ShapeSpace> spaces;
    std::vector<core::HandShape> shapes;

    explicit Person(double scale) {
        for (std::size_t h = 0; h < 2; ++h) {
            models[h].side = h == 0 ? core::Side::Left : core::Side::Right;
            models[h].skeleton = test::fiveFingerSkeleton(models[h].side);
            models[h].weights.firstEntry = {0};
            spaces.emplace_back(models[h]);
            shapes.push_back(spaces[h].modelShape());
            shapes[h][0] = std::log(scale);
        }
    }
    std::vector<core::SubjectFrame> frames(int count, test::RandomValues& random, bool withRight = true) const {
        std::vector<core::SubjectFrame> all;
        for (int f = 0; f < count; ++f) {
            core::SubjectFrame& frame = all.emplace_back();
            for (std::size_t h = 0; h < 2; ++h) {
                const core::Skeleton skeleton = spaces[h].shaped(shapes[h]).skeleton;
                core::Pose pose = test::curledPose(skeleton, random.between(0.1, 0.9));
                pose.head<3>() = random.point(50);
                pose.segment<3>(3) = random.point(0.5);
                const auto joints = core::jointPositions(skeleton, pose);
                auto& targets = frame.targets.emplace_back();
                for (std::size_t b = 0; (h == 0 || withRight) && b < joints.size(); ++b) {
                    const Eigen::Vector3d noise(random.normal(), random.normal(), random.normal());
                    targets.push_back({static_cast<int>(b), joints[b] + kClickSigmaMm * noise,
                                       kClickSigmaMm * kClickSigmaMm * Eigen::Matrix3d::Identity()});
                }
            }
        }
        return all;
    }
    double lengthMm(std::size_t hand, std::size_t segment) const {
        return spaces[hand].lengthMm(static_cast<int>(segment), shapes[hand]);
    }
};

bool isIndexFinger(const core::SubjectBone& bone) {
    return bone.from.starts_with("index");
}

TEST(SubjectProportions, AFingerThatIsTenPercentLongerIsFound) {
    Person person(0.97);
    for (int a = 0; a < person.spaces[0].segmentCount(); ++a) {
        const int bone = person.spaces[0].segments()[static_cast<std::size_t>(a)].bone;
        if (person.models[0].skeleton.bones[static_cast<std::size_t>(bone)].name.starts_with("index"))
            person.shapes[0][person.spaces[0].lengthIndex(a)] = 0.1;
    }
    test::RandomValues random("longer finger");
    const core::SubjectResult result = core::estimateSubject(person.models, {}, person.frames(5, random));
    for (std::size_t h = 0; h < 2; ++h) {
        const auto& bones = result.hands[h].bones;
        for (std::size_t a = 0; a < bones.size(); ++a) {
            EXPECT_NEAR(bones[a].lengthMm, person.lengthMm(h, a), 1) << h << bones[a].from;
            EXPECT_EQ(bones[a].isUnlikeModel(), h == 0 && isIndexFinger(bones[a])) << h << bones[a].from;
        }
    }
}

TEST(SubjectProportions, NoiseAloneMakesNoDifferences) {
    const Person person(1.06);
    for (int seed = 0; seed < 10; ++seed) {
        test::RandomValues random("noise alone " + std::to_string(seed));
        const core::SubjectResult result = core::estimateSubject(person.models, {}, person.frames(5, random));
        for (const core::SubjectHand& hand : result.hands) {
            EXPECT_NEAR(hand.scale.value, 1.06, 0.003);
            for (const core::SubjectBone& bone : hand.bones)
                EXPECT_FALSE(bone.isUnlikeModel()) << seed << bone.from << bone.share;
        }
    }
}

TEST(SubjectProportions, TheTruthIsWithinTwoDeviationsInAbout95Percent) {
    int within = 0, all = 0, scalesWithin = 0, scales = 0;
    double modelSigma = 0;
    constexpr int kSeeds = 40;
    for (int seed = 0; seed < kSeeds; ++seed) {
        test::RandomValues random("coverage " + std::to_string(seed));
        Person person(std::exp(0.04 * random.normal()));
        for (int a = 0; a < person.spaces[0].segmentCount(); ++a) {
            const double share = 0.015 * random.normal();
            for (std::size_t h = 0; h < 2; ++h)
                person.shapes[h][person.spaces[h].lengthIndex(a)] = share + 0.004 * random.normal();
        }
        const core::SubjectResult result = core::estimateSubject(person.models, {}, person.frames(6, random));
        modelSigma += result.modelSigmaMm / kSeeds;
        for (std::size_t h = 0; h < 2; ++h) {
            const core::SubjectHand& hand = result.hands[h];
            double sum = 0, model = 0;
            for (std::size_t a = 0; a < hand.bones.size(); ++a) {
                const core::SubjectBone& bone = hand.bones[a];
                within += std::abs(bone.lengthMm - person.lengthMm(h, a)) < 2 * bone.sigmaMm;
                ++all;
                if (bone.to.ends_with("tip"))
                    continue;
                sum += person.lengthMm(h, a);
                model += bone.modelMm;
            }
            scalesWithin += std::abs(hand.scale.value - sum / model) < 2 * hand.scale.sigma;
            ++scales;
        }
    }
    EXPECT_NEAR(static_cast<double>(within) / all, 0.95, 0.03);
    EXPECT_GE(static_cast<double>(scalesWithin) / scales, 0.9);
    EXPECT_LT(modelSigma, 0.15) << "the joints are clicked where the model has them";
}

TEST(SubjectProportions, JointsThatAreClickedElsewhereAreKnownFromTheData) {
    Person person(1);
    test::RandomValues random("elsewhere");
    std::vector<core::SubjectFrame> frames = person.frames(6, random);
    for (core::SubjectFrame& frame : frames)
        for (auto& targets : frame.targets)
            for (core::JointTarget& target : targets)
                target.pointInWorld += 1.5 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    EXPECT_NEAR(core::estimateSubject(person.models, {}, frames).modelSigmaMm, 1.5, 0.15);
}

TEST(SubjectProportions, AHandThatIsNeverAnnotatedFollowsTheOther) {
    const Person person(1.08);
    test::RandomValues random("one hand");
    const core::SubjectResult result = core::estimateSubject(person.models, {}, person.frames(5, random, false));
    EXPECT_EQ(result.hands[0].frames, 5);
    EXPECT_EQ(result.hands[1].frames, 0);
    EXPECT_NEAR(result.hands[1].scale.value, 1.08, 0.005);
    EXPECT_GT(result.hands[1].scale.sigma, 2 * result.hands[0].scale.sigma);
}

} // namespace
