// SPDX-License-Identifier: MIT
#include "widgets/jobs/hand_places.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "core/annotation/edits.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tiny_dataset.h"

namespace {

using namespace widgets;
using core::Side;

class HandPlaces : public testing::Test {
protected:
    Eigen::Vector3d joint(Side hand, int frame) const {
        const std::size_t index = hand == Side::Left ? 0 : 1;
        return core::jointPositions(dataset.hands[index].skeleton, test::tinyMotion(frame + 1).back()[index])[1];
    }
    void mark(int frame, Side hand, const std::string& rater, std::initializer_list<int> cameras) {
        for (const int camera : cameras) {
            const core::Camera& seen = dataset.cameras[static_cast<std::size_t>(camera)];
            core::Mark made;
            made.px = *core::project(seen, joint(hand, frame));
            set.marks[{frame, rater, {hand, "index_mcp"}, seen.name}] = made;
        }
    }
    core::Dataset dataset = test::tinyDataset();
    core::AnnotationSet set;
};

TEST_F(HandPlaces, APosePlacesBothHandsAndTheBeginningOfTheArms) {
    const core::HandPoses poses = test::tinyMotion(5).back();
    const auto hands = handsInPose(dataset.hands, {poses[0], core::Pose()});
    ASSERT_EQ(hands.size(), 1u) << "a hand without a pose is left out";
    EXPECT_EQ(hands[0].side, Side::Left);
    EXPECT_TRUE(hands[0].startsAtRoot);
    EXPECT_LT((hands[0].pointsInWorld[0] - core::jointPositions(dataset.hands[0].skeleton, poses[0])[0]).norm(), 1e-9);
}

TEST_F(HandPlaces, TheNearestFramesMarksOfAllRatersPlaceTheHands) {
    mark(3, Side::Left, "ann", {0, 2});
    mark(20, Side::Left, "ann", {0, 2});
    mark(25, Side::Right, "bob", {1, 4});
    const auto hands = handsOfMarks(set, dataset.cameras, 18);
    ASSERT_EQ(hands.size(), 2u);
    EXPECT_LT((hands[0].pointsInWorld.front() - joint(Side::Left, 20)).norm(), 0.1);
    EXPECT_EQ(hands[1].side, Side::Right);
    EXPECT_LT((hands[1].pointsInWorld.front() - joint(Side::Right, 25)).norm(), 0.1);
    EXPECT_TRUE(handsOfMarks({}, dataset.cameras, 18).empty());
}

TEST_F(HandPlaces, TheBoxHoldsTheHandAndLiesInTheImage) {
    for (const core::Camera& camera : dataset.cameras) {
        const auto hands = handsInPose(dataset.hands, test::tinyMotion(13).back());
        const auto box = handsInView(camera, hands);
        ASSERT_TRUE(box) << camera.name;
        EXPECT_TRUE(QRectF(-0.5, -0.5, camera.size.width, camera.size.height).contains(*box));
        for (const HandPlace& hand : hands) {
            for (const Eigen::Vector3d& point : hand.pointsInWorld) {
                const Eigen::Vector2d px = *core::project(camera, point);
                EXPECT_TRUE(!core::isInside(camera.size, px) || box->contains(px.x(), px.y()));
            }
        }
    }
    HandPlace away{Side::Left, {Eigen::Vector3d(0, 100000, 0)}, false};
    EXPECT_FALSE(handsInView(dataset.cameras[0], {away})) << "a hand that is not in the picture";
}

TEST_F(HandPlaces, OneViewsMarksPlaceTheHandsInThatViewOnly) {
    mark(9, Side::Left, "ann", {3});
    const Eigen::Vector2d px = *core::project(dataset.cameras[3], joint(Side::Left, 9));
    const auto box = marksInView(dataset.cameras[3], set, 0);
    ASSERT_TRUE(box);
    EXPECT_TRUE(box->contains(px.x(), px.y()));
    EXPECT_FALSE(marksInView(dataset.cameras[4], set, 0));
}

TEST_F(HandPlaces, MasksPlaceTheHandsPerCamera) {
    test::TemporaryFolder folder;
    dataset.folder = std::filesystem::path(folder / "");
    cv::Mat mask = cv::Mat::zeros(480, 270, CV_8U);
    mask(cv::Rect(100, 200, 40, 60)) = 255;
    std::filesystem::create_directories(folder / "masks");
    cv::imwrite((folder / "masks" / "cam2_7.png").string(), mask);
    core::Sequence sequence;
    sequence.masks = "masks/{camera}_{frame}.png";
    const auto boxes = handsOfMasks(dataset, sequence, 7);
    ASSERT_EQ(boxes.size(), 8u);
    EXPECT_EQ(boxes[2], QRectF(99.5, 199.5, 40, 60));
    EXPECT_TRUE(boxes[0].isNull());
}

} // namespace
