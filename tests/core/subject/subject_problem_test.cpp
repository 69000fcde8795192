// SPDX-License-Identifier: MIT
#include "core/subject/subject_problem.h"

#include <gtest/gtest.h>

#include "tests/support/problem_checks.h"
#include "tests/support/two_finger_hand.h"

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST(SubjectProblem, GradientIsThatOfTheCost) {
    const std::vector<core::ShapeSpace> spaces{core::ShapeSpace(test::twoFingerHands()[0]),
                                               core::ShapeSpace(test::twoFingerHands()[1])};
    test::RandomValues random("subject gradient");
    std::vector<core::SubjectPose> frames(2);
    std::vector<core::OutlineMatch> outline;
    for (int f = 0; f < 2; ++f) {
        for (int h = 0; h < 2; ++h) {
            const core::Skeleton& skeleton = spaces[static_cast<std::size_t>(h)].model().skeleton;
            frames[static_cast<std::size_t>(f)].start.emplace_back(test::somePose(skeleton, random));
            auto& targets = frames[static_cast<std::size_t>(f)].targets.emplace_back();
            for (int b = 1; b < 5; ++b)
                targets.push_back({b, random.point(60), 0.3 * Matrix3d::Identity()});
            for (int i = 0; i < 20; ++i) {
                const int count = static_cast<int>(spaces[0].model().mesh.vertices.size());
                outline.push_back({f, h, random.below(count), random.below(count), 0.3, random.point(0.1),
                                   random.point(300), random.direction(), 0.7});
            }
        }
    }
    const core::SubjectProblem problem(spaces, frames, outline, {});
    Eigen::VectorXd x = problem.start();
    for (int h = 0; h < 2; ++h) {
        const int at = problem.shapeOffset(static_cast<std::size_t>(h));
        x[at] = 0.04;
        x[at + 1] = 0.8;
        x.segment(at + 2, spaces[0].segmentCount()) = random.vector(spaces[0].segmentCount(), 0.05);
    }
    test::expectGradient(problem, x, 1e-6);
}

TEST(ShapeSpace, ScaleAndGirthAreThoseOfTheirDefinition) {
    const core::HandModel model = test::twoFingerHand(core::Side::Left);
    const core::ShapeSpace space(model);
    core::HandShape shape = space.modelShape();
    shape[0] = std::log(1.03);
    shape[1] = 1;
    const core::HandModel hand = space.shaped(shape);
    const auto normals = core::vertexNormals(model.mesh);
    const Vector3d centre = model.skeleton.centreAtRest;
    for (std::size_t v = 0; v < normals.size(); v += 7) {
        const Vector3d expected = centre + 1.03 * (model.mesh.vertices[v] + normals[v] - centre);
        EXPECT_LT((hand.mesh.vertices[v] - expected).norm(), 1e-9);
    }
    EXPECT_NEAR(hand.skeleton.bones[1].lengthMm, 1.03 * model.skeleton.bones[1].lengthMm, 1e-9);
}

TEST(ShapeSpace, ALongerBoneMovesWhatHangsOnIt) {
    const core::HandModel model = test::twoFingerHand(core::Side::Left);
    const core::ShapeSpace space(model);
    const int pip = model.skeleton.boneIndex("index_pip");
    for (int a = 0; a < space.segmentCount(); ++a) {
        const core::ShapeSegment& segment = space.segments()[static_cast<std::size_t>(a)];
        if (segment.end != pip)
            continue;
        core::HandShape shape = space.modelShape();
        shape[space.lengthIndex(a)] = 0.1;
        const core::HandModel hand = space.shaped(shape);
        EXPECT_NEAR(space.lengthMm(a, shape), 46.2, 1e-9);
        for (std::size_t v = 0; v < model.mesh.vertices.size(); ++v) {
            const bool isTip = model.weights.firstEntry[v + 1] == model.weights.firstEntry[v] + 1 &&
                               model.weights.entries[static_cast<std::size_t>(model.weights.firstEntry[v])].bone == pip;
            const Vector3d moved = hand.mesh.vertices[v] - model.mesh.vertices[v];
            if (isTip)
                EXPECT_LT((moved - 0.1 * segment.alongAtRest).norm(), 1e-9);
            else
                EXPECT_LT(moved.norm(), 4.2 + 1e-9);
        }
    }
}

} // namespace
