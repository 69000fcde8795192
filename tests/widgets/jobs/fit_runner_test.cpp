// SPDX-License-Identifier: MIT
#include "widgets/jobs/fit_runner.h"

#include <cmath>

#include <QSignalSpy>

#include <gtest/gtest.h>

#include "core/annotation/edits.h"
#include "core/contour/rasteriser.h"
#include "core/io/footage/image_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tiny_dataset.h"
#include "tests/support/wait_until.h"

namespace {

using widgets::FitRequest;
using widgets::FitTarget;

class FitRunnerTest : public testing::Test {
protected:
    FitRunnerTest() {
        test::writeTinyDataset(folder / "ds");
        auto read = std::make_shared<core::Dataset>(core::readDataset(folder / "ds"));
        read->sequences[0].masks = "masks/{camera}-{frame}.png";
        dataset = read;
        document.open({});
        std::filesystem::create_directories(dataset->folder / "masks");
        for (const core::Camera& camera : dataset->cameras)
            core::writePng(dataset->folder / "masks" / (camera.name + "-7.png"),
                           core::renderHandsMask(camera, dataset->hands, motion->at(7)));
    }
    void open(bool withMotion) {
        runner.setSequence(dataset, &dataset->sequences[0],
                           withMotion ? motion : std::make_shared<const core::Motion>());
    }
    /// What the run failed with; empty if it did not.
    QString run(const FitRequest& request) {
        QString failure;
        bool ended = false;
        QObject scope;
        QObject::connect(
            &runner, &widgets::FitRunner::failed, &scope,
            [&](const QString& message) {
                failure = message;
                ended = true;
            });
        QObject::connect(&runner, &widgets::FitRunner::finished, &scope, [&] { ended = true; });
        runner.run(request);
        EXPECT_TRUE(test::waitUntil([&] { return ended; }));
        return failure;
    }
    void markFrame(int frame) {
        for (std::size_t hand = 0; hand < 2; ++hand) {
            const auto joints =
                core::jointPositions(dataset->hands[hand].skeleton, motion->at(static_cast<std::size_t>(frame))[hand]);
            for (std::size_t bone = 0; bone < joints.size(); ++bone) {
                for (const core::Camera& camera : dataset->cameras)
                    document.push(
                        core::placeEdit(document.annotations(),
                                        {frame,
                                         document.rater(),
                                         {dataset->hands[hand].side, dataset->hands[hand].skeleton.bones[bone].name},
                                         camera.name},
                                        *core::project(camera, joints[bone])));
            }
        }
    }

    test::TemporaryFolder folder;
    std::shared_ptr<const core::Dataset> dataset;
    std::shared_ptr<const core::Motion> motion = std::make_shared<const core::Motion>(test::tinyMotion(30));
    widgets::JobPool pool;
    widgets::AnnotationDocument document;
    widgets::FitRunner runner{document, pool};
};

TEST_F(FitRunnerTest, MeetsMaskFilesAsItMeetsTheRecordedPose) {
    open(true);
    EXPECT_EQ(run({4, 7, {"dch-thres"}, FitTarget::Recorded}), QString());
    const auto drawn = runner.outcome();
    EXPECT_EQ(run({4, 7, {"dch-thres"}, FitTarget::Masks}), QString());
    const auto observed = runner.outcome();
    EXPECT_NEAR(observed->methods[0].errorMm, drawn->methods[0].errorMm, 1e-9) << "the same silhouettes";
    EXPECT_TRUE(drawn->outlinesPx[0].empty());
    EXPECT_GT(observed->outlinesPx[0].size(), 10u);
    const QRectF& hands = observed->handsPx[0];
    EXPECT_TRUE(hands.contains(observed->outlinesPx[0][0].p1()));
    QRectF outline;
    for (const QLineF& line : observed->outlinesPx[0])
        outline |= QRectF(line.p1(), line.p2()).normalized().adjusted(0, 0, 1e-9, 1e-9);
    EXPECT_TRUE(hands.contains(outline));
    EXPECT_LT((hands.center() - outline.center()).manhattanLength(), 0.2 * outline.width());
}

TEST_F(FitRunnerTest, FramesTheHandsThoughAMaskShowsAnArm) {
    open(true);
    run({4, 7, {"ch"}, FitTarget::Masks});
    const QRectF hands = runner.outcome()->handsPx[0];
    cv::Mat mask = runner.outcome()->masks[0].clone();
    mask.rowRange(mask.rows / 2, mask.rows).setTo(255);
    core::writePng(dataset->folder / "masks" / (dataset->cameras[0].name + "-7.png"), mask);
    run({4, 7, {"ch"}, FitTarget::Masks});
    EXPECT_EQ(runner.outcome()->handsPx[0], hands);
}

TEST_F(FitRunnerTest, AgainstMasksErrorsAreOverTheMarkedJoints) {
    open(true);
    markFrame(7);
    EXPECT_EQ(run({4, 7, {"ch"}, FitTarget::Masks}), QString());
    EXPECT_EQ(runner.outcome()->reference.size(), 4u);
    EXPECT_NEAR(runner.outcome()->initialErrorMm,
                core::meanJointDistanceMm(dataset->hands, motion->at(4), motion->at(7)), 0.01);
}

TEST_F(FitRunnerTest, SaysWhyItCannot) {
    open(true);
    EXPECT_TRUE(run({4, 9, {"ch"}, FitTarget::Masks}).contains(QStringLiteral("no mask file")));
    EXPECT_TRUE(run({4, 30, {"ch"}, FitTarget::Recorded}).contains(QStringLiteral("between 0 and 29")));
    EXPECT_TRUE(run({4, 7, {}, FitTarget::Recorded}).contains(QStringLiteral("method")));
    open(false);
    EXPECT_TRUE(run({4, 7, {"ch"}, FitTarget::Recorded}).contains(QStringLiteral("no recorded motion")));
    EXPECT_TRUE(run({4, 7, {"ch"}, FitTarget::Masks}).contains(QStringLiteral("mark some joints")));
    runner.setSequence(dataset, &dataset->sequences[1], motion);
    EXPECT_TRUE(run({4, 7, {"ch"}, FitTarget::Masks}).contains(QStringLiteral("no mask files")));
}

} // namespace
