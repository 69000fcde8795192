// SPDX-License-Identifier: MIT
#include "core/segmentation/seeded_cut.h"

#include <thread>

#include <gtest/gtest.h>

#include "core/segmentation/sharp_edge.h"
#include "core/segmentation/silhouette.h"
#include "tests/core/segmentation/drawn_scene.h"

namespace core {
namespace {

const cv::Size kSceneSize(400, 360);

Seeds seedsAround(cv::Point2d centre, double sure, double unknown) {
    Seeds seeds;
    seeds.window = {40, 30, 320, 300};
    cv::Mat labels = cv::Mat::zeros(kSceneSize, CV_8U);
    labels.setTo(seedValue(Seed::ProbableBackground), test::discMask(kSceneSize, centre, unknown));
    labels.setTo(seedValue(Seed::SureForeground), test::discMask(kSceneSize, centre, sure));
    seeds.labels = labels(seeds.window).clone();
    return seeds;
}

cv::Mat scene(const cv::Mat& truth) {
    return test::composed(test::noisyColour(kSceneSize, test::kSkin, 5, 1),
                          test::noisyColour(kSceneSize, test::kGrey, 5, 2), truth, 1);
}

cv::Mat whole(const cv::Mat& part, const Seeds& seeds) {
    cv::Mat mask = cv::Mat::zeros(kSceneSize, CV_8U);
    part.copyTo(mask(seeds.window));
    return mask;
}

TEST(SeededCut, FindsTheEdgeThatTheSeedsLeaveOpen) {
    const cv::Mat truth = test::discMask(kSceneSize, {200, 180}, 80);
    const Seeds seeds = seedsAround({203, 178}, 60, 100);
    EXPECT_GT(maskOverlap(whole(seededCut(scene(truth), seeds), seeds), truth), 0.985);
}

TEST(SeededCut, FindsItInASmallerPictureAlmostAsWell) {
    const cv::Mat truth = test::discMask(kSceneSize, {200, 180}, 80);
    const Seeds seeds = seedsAround({203, 178}, 60, 100);
    SeededCutOptions small;
    small.mostPixels = 8000;
    EXPECT_GT(maskOverlap(whole(seededCut(scene(truth), seeds, small), seeds), truth), 0.975);
}

TEST(SeededCut, IsTheSameOnEveryThreadAndEveryTime) {
    const cv::Mat truth = test::discMask(kSceneSize, {200, 180}, 80), picture = scene(truth);
    const Seeds seeds = seedsAround({203, 178}, 60, 100);
    const cv::Mat first = seededCut(picture, seeds);
    cv::theRNG().next();
    cv::Mat second;
    std::thread([&] {
        for (int i = 0; i < 5; ++i)
            cv::theRNG().next();
        second = seededCut(picture, seeds);
    }).join();
    EXPECT_EQ(cv::countNonZero(first != second), 0);
    EXPECT_EQ(cv::countNonZero(first != seededCut(picture, seeds)), 0);
}

TEST(SeededCut, NeverTakesFromWhatIsSure) {
    const cv::Mat picture = test::noisyColour(kSceneSize, test::kGrey, 5, 2); // there is nothing to be seen
    const Seeds seeds = seedsAround({200, 180}, 30, 100);
    const cv::Mat mask = seededCut(picture, seeds);
    EXPECT_EQ(cv::countNonZero((seeds.labels == seedValue(Seed::SureForeground)) & (mask == 0)), 0);
    EXPECT_EQ(cv::countNonZero((seeds.labels == seedValue(Seed::SureBackground)) & (mask != 0)), 0);
}

TEST(SeededCut, AnswersWithTheSeedsWhereThereIsNothingToLearn) {
    Seeds seeds;
    seeds.window = {0, 0, 40, 40};
    seeds.labels = cv::Mat(40, 40, CV_8U, cv::Scalar(seedValue(Seed::ProbableForeground)));
    EXPECT_EQ(cv::countNonZero(seededCut(scene(cv::Mat::zeros(kSceneSize, CV_8U)), seeds)), 1600);
    EXPECT_TRUE(seededCut(scene(cv::Mat::zeros(kSceneSize, CV_8U)), Seeds()).empty());
}

TEST(SharpEdge, PutsTheEdgeWhereABlurredOneHasItsMiddle) {
    const cv::Mat truth = test::discMask(kSceneSize, {200, 180}, 80);
    const cv::Mat picture =
        test::composed(cv::Mat(kSceneSize, CV_8UC3, test::kSkin), cv::Mat(kSceneSize, CV_8UC3, test::kGrey), truth, 2);
    for (const double radius : {77.0, 83.0}) {
        const cv::Mat off = test::discMask(kSceneSize, {200, 180}, radius);
        EXPECT_LT(maskOverlap(off, truth), 0.94);
        EXPECT_GT(maskOverlap(sharpEdge(picture, off, 5), truth), 0.99) << radius;
    }
}

TEST(SharpEdge, KeepsTheMaskWhereBothSidesLookAlike) {
    const cv::Mat mask = test::discMask(kSceneSize, {200, 180}, 80), plain(kSceneSize, CV_8UC3, test::kGrey);
    EXPECT_GT(maskOverlap(sharpEdge(plain, mask, 5), mask), 0.99);
}

} // namespace
} // namespace core
