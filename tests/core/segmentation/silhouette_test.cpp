// SPDX-License-Identifier: MIT
#include "core/segmentation/silhouette.h"

#include <gtest/gtest.h>

#include "core/contour/rasteriser.h"
#include "core/io/demo/demo_hands.h"
#include "core/segmentation/landmark_seeds.h"
#include "core/segmentation/model_seeds.h"
#include "tests/core/segmentation/drawn_scene.h"
#include "tests/support/camera_ring.h"
#include "tests/support/tiny_hands.h"

namespace core {
namespace {

/// The tiny hands before a grey room, seen by one camera without a lens.
struct TinyScene {
    std::vector<HandModel> hands = test::tinyHands();
    Camera camera = test::cameraRing(4, false)[1];
    HandPoses poses = test::tinyMotion(8)[7];
    cv::Mat truth = renderHandsMask(camera, hands, poses);
    cv::Mat picture = test::composed(test::noisyColour(truth.size(), test::kSkin, 4, 1),
                                     test::noisyColour(truth.size(), test::kGrey, 4, 2), truth, 0.8);

    cv::Mat byModel(const HandPoses& assumed, double bandMm = 6) const {
        SilhouetteOptions options;
        options.bandMm = bandMm;
        HandEvidence evidence;
        evidence.poses = assumed;
        const auto found = findSilhouette(picture, camera, hands, evidence, {}, options);
        return found ? found->mask : cv::Mat();
    }
};

TEST(SilhouetteByModel, IsThatOfThePosedHandInThePicture) {
    const TinyScene scene;
    ASSERT_GT(cv::countNonZero(scene.truth), 10'000);
    EXPECT_GT(maskOverlap(scene.byModel(scene.poses), scene.truth), 0.98);
}

TEST(SilhouetteByModel, FollowsThePictureWhereThePoseIsOff) {
    const TinyScene scene;
    HandPoses off = scene.poses;
    for (Pose& pose : off)
        pose[0] += 3, pose[1] -= 3;
    const double itself = maskOverlap(renderHandsMask(scene.camera, scene.hands, off), scene.truth);
    EXPECT_LT(itself, 0.92);
    EXPECT_GT(maskOverlap(scene.byModel(off), scene.truth), 0.97);
}

TEST(SilhouetteByModel, NeedsAPose) {
    const TinyScene scene;
    EXPECT_TRUE(scene.byModel({}).empty());
    EXPECT_TRUE(scene.byModel({Pose(), Pose()}).empty());
    EXPECT_FALSE(scene.byModel({scene.poses[0], Pose()}).empty()) << "one hand is enough";
}

TEST(SilhouetteByModel, IsEmptyWhereTheHandsAreOutsideThePicture) {
    const TinyScene scene;
    HandPoses away = scene.poses;
    for (Pose& pose : away)
        pose[1] += 2000;
    const cv::Mat mask = scene.byModel(away);
    ASSERT_EQ(mask.size(), scene.truth.size());
    EXPECT_EQ(cv::countNonZero(mask), 0);
}

TEST(SilhouetteByModel, EndsWhereTheModelDoesThoughAnArmGoesOn) {
    const std::vector<HandModel>& hands = demoHands(); // the tiny ones end in a point
    TinyScene scene{.hands = {hands[0]}, .poses = {hands[0].skeleton.restPose()}};
    const auto line = modelEnd(scene.camera, scene.hands[0], scene.poses[0]);
    ASSERT_TRUE(line);
    const cv::Point2d from((line->from.x() + line->to.x()) / 2, (line->from.y() + line->to.y()) / 2);
    const cv::Point2d to = from + 200 * cv::Point2d(line->away.x(), line->away.y());
    cv::Mat arm = cv::Mat::zeros(scene.truth.size(), CV_8U);
    cv::line(arm, from, to, cv::Scalar(255), 60);
    test::noisyColour(arm.size(), test::kSkin, 4, 5).copyTo(scene.picture, arm & ~scene.truth);
    EXPECT_GT(maskOverlap(scene.byModel(scene.poses), scene.truth), 0.96);
}

/// Five fingers with thick lines, as the landmarks run; a hand as large as in a picture.
struct DrawnHand {
    Camera camera = test::cameraRing(4, false)[1];
    LandmarkPoints points;
    cv::Mat truth, picture;

    DrawnHand() {
        points[0] = Eigen::Vector3d(0, -90, 0);
        for (int finger = 0; finger < 5; ++finger)
            for (int joint = 0; joint < 4; ++joint)
                points[static_cast<std::size_t>(1 + 4 * finger + joint)] =
                    Eigen::Vector3d(24.0 * (finger - 2), 22.0 * joint, 0);
        const HandInView hand = handInView(camera, points, 3);
        truth = cv::Mat::zeros(camera.size.height, camera.size.width, CV_8U);
        const auto at = [&](std::size_t i) { return cv::Point(cvRound(hand.px[i]->x()), cvRound(hand.px[i]->y())); };
        const int thick = cvRound(0.18 * hand.palmPx);
        std::vector<cv::Point> palm;
        for (std::size_t finger = 0; finger < 5; ++finger) {
            palm.push_back(at(1 + 4 * finger));
            cv::line(truth, at(0), at(1 + 4 * finger), cv::Scalar(255), thick);
            for (std::size_t joint = 0; joint < 3; ++joint)
                cv::line(truth, at(1 + 4 * finger + joint), at(2 + 4 * finger + joint), cv::Scalar(255), thick);
        }
        palm.push_back(at(0));
        cv::fillPoly(truth, std::vector{palm}, cv::Scalar(255));
        cv::line(truth, at(0), {cvRound(hand.forearmEnd->x()), cvRound(hand.forearmEnd->y())}, cv::Scalar(255),
                 cvRound(0.55 * hand.palmPx)); // an arm that goes on
        picture = test::composed(test::noisyColour(truth.size(), test::kSkin, 4, 1),
                                 test::noisyColour(truth.size(), test::kGrey, 4, 2), truth, 0.8);
    }
    Silhouette find(double forearmPalms, SegmentationMethod method = SegmentationMethod::Landmarks,
                    bool isKnown = true) const {
        SilhouetteOptions options;
        options.method = method;
        options.forearmPalms = forearmPalms;
        HandEvidence evidence;
        if (isKnown)
            evidence.landmarks = {points};
        const cv::Mat room = test::noisyColour(truth.size(), test::kGrey, 4, 3);
        return *findSilhouette(picture, camera, {}, evidence, room, options);
    }
    /// Skin that is none of the hand's.
    void addFace() {
        cv::Mat face = cv::Mat::zeros(truth.size(), CV_8U);
        cv::circle(face, kFace, 60, cv::Scalar(255), -1);
        ASSERT_EQ(cv::countNonZero(face & truth), 0);
        test::noisyColour(face.size(), test::kSkin, 4, 7).copyTo(picture, face);
    }
    static inline const cv::Point kFace{90, 90};
    /// What is on the hand's side of the line across the forearm.
    cv::Mat cutTruth(double palms) const {
        const ForearmLine line = *forearmLine(handInView(camera, points), palms);
        cv::Mat cut = truth.clone();
        for (int y = 0; y < cut.rows; ++y)
            for (int x = 0; x < cut.cols; ++x)
                if ((Eigen::Vector2d(x, y) - line.from).dot(line.away) > 0)
                    cut.at<uchar>(y, x) = 0;
        return cut;
    }
};

TEST(SilhouetteByLandmarks, HoldsFingersPalmAndForearmUpToTheCut) {
    const DrawnHand hand;
    for (const double palms : {0.0, 0.6, 1.2}) {
        const Silhouette found = hand.find(palms);
        EXPECT_GT(maskOverlap(found.mask, hand.cutTruth(palms)), 0.96) << palms;
        ASSERT_EQ(found.cuts.size(), 1u);
    }
}

TEST(SilhouetteByPicture, EndsForearmsAndLeavesOutFacesWhereJointsAreKnown) {
    DrawnHand hand;
    hand.addFace();
    for (const auto method : {SegmentationMethod::Background, SegmentationMethod::Chroma, SegmentationMethod::Skin}) {
        const Silhouette all = hand.find(0.6, method, false), found = hand.find(0.6, method);
        EXPECT_EQ(all.mask.at<uchar>(DrawnHand::kFace), 255) << methodName(method);
        EXPECT_TRUE(all.cuts.empty());
        EXPECT_GT(maskOverlap(found.mask, hand.cutTruth(0.6)), 0.95) << methodName(method);
        EXPECT_EQ(found.cuts.size(), 1u);
    }
}

TEST(SilhouetteByLandmarks, SeesBetweenTheFingers) {
    const DrawnHand hand;
    const cv::Mat mask = hand.find(0).mask;
    const HandInView view = handInView(hand.camera, hand.points);
    const Eigen::Vector2d between = (*view.px[8] + *view.px[12]) / 2;
    EXPECT_EQ(mask.at<uchar>(cvRound(between.y()), cvRound(between.x())), 0);
    EXPECT_EQ(mask.at<uchar>(cvRound(view.px[8]->y()), cvRound(view.px[8]->x())), 255);
}

TEST(SilhouetteByLandmarks, NeedsLandmarks) {
    const DrawnHand hand;
    SilhouetteOptions options;
    options.method = SegmentationMethod::Landmarks;
    EXPECT_FALSE(findSilhouette(hand.picture, hand.camera, {}, {}, {}, options));
}

TEST(ModelSeeds, AreSureOutsideTheBandAlone) {
    const TinyScene scene;
    const ModelInView view = modelInView(scene.camera, scene.hands, scene.poses);
    const Seeds seeds = modelSeeds(view);
    const cv::Mat truth = scene.truth(view.window);
    EXPECT_EQ(cv::countNonZero((seeds.labels == seedValue(Seed::SureForeground)) & ~truth), 0);
    EXPECT_EQ(cv::countNonZero((seeds.labels == seedValue(Seed::SureBackground)) & truth), 0);
    cv::Mat distance;
    cv::distanceTransform(255 - truth, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    EXPECT_EQ(cv::countNonZero((distance <= view.bandPx) & (seeds.labels == seedValue(Seed::SureBackground))), 0);
}

TEST(SegmentationMethods, HaveNamesThatReadBack) {
    for (const SegmentationMethod method : kSegmentationMethods)
        EXPECT_EQ(segmentationMethodFromName(methodName(method)), method);
    EXPECT_FALSE(segmentationMethodFromName("magic"));
}

} // namespace
} // namespace core
