// SPDX-License-Identifier: MIT
#include "widgets/jobs/review_queue.h"

#include <gtest/gtest.h>

#include "core/annotation/edits.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/detector/auto_label_file.h"
#include "tests/support/detection/fake_first_pass.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tiny_dataset.h"
#include "tests/support/wait_until.h"

namespace {

using core::Side;

class ReviewQueueTest : public testing::Test {
protected:
    ReviewQueueTest() {
        test::writeTinyDataset(folder / "dataset");
        dataset = std::make_shared<const core::Dataset>(core::readDataset(folder / "dataset"));
        start();
    }
    void start() {
        document = std::make_unique<widgets::AnnotationDocument>();
        queue = std::make_unique<widgets::ReviewQueue>(*document, pool);
        document->setRater("ann");
        document->open(widgets::AnnotationDocument::read(core::annotationFile(*dataset, dataset->sequences[0])));
        queue->setDataset(dataset);
        settle();
    }
    void restart() {
        queue.reset();
        document.reset();
        start();
    }
    void settle() {
        ASSERT_TRUE(test::waitUntil([this] { return queue->isUpToDate(); }));
    }
    void propose(const std::map<int, double>& doubts) {
        core::AutoLabels labels;
        for (const auto& [frame, doubt] : doubts)
            for (const Side side : {Side::Left, Side::Right})
                labels[frame].push_back(test::madeUpLabel(side, frame, doubt));
        document->push(core::autoLabelEdit(document->annotations(), *dataset, labels, "ann"));
        settle();
    }
    void accept(int frame) {
        document->push(core::acceptProposalsEdit(document->annotations(), dataset->cameras, frame, "ann"));
        settle();
    }
    void click(int frame, const core::JointId& joint, const Eigen::Vector3d& at) {
        for (int camera = 0; camera < 3; ++camera) {
            const core::Camera& seen = dataset->cameras[static_cast<std::size_t>(camera)];
            document->push(
                core::placeEdit(document->annotations(), {frame, "ann", joint, seen.name}, *core::project(seen, at)));
        }
    }
    std::vector<int> order() const {
        std::vector<int> frames;
        for (const widgets::ReviewRow& row : queue->rows())
            frames.push_back(row.item.frame);
        return frames;
    }

    test::TemporaryFolder folder;
    std::shared_ptr<const core::Dataset> dataset;
    widgets::JobPool pool;
    std::unique_ptr<widgets::AnnotationDocument> document;
    std::unique_ptr<widgets::ReviewQueue> queue;
};

TEST_F(ReviewQueueTest, OrdersFramesByDoubtAndWhatALookTeachesAndWalksThroughThem) {
    propose({{0, 0.05}, {5, 0.6}, {10, 0.7}, {15, 0.6}, {20, 0.05}});
    EXPECT_EQ(order(), (std::vector{10, 5, 15, 0, 20}));
    EXPECT_EQ(queue->find(10)->item.neighbours, 2);
    EXPECT_EQ(queue->next(12), 10) << "a frame that does not wait";
    EXPECT_EQ(queue->next(10), 5);
    EXPECT_EQ(queue->next(20), 10) << "around the end";
    EXPECT_EQ(queue->openHands().size(), 5u);
    EXPECT_NEAR(queue->openHands().at(10).at(Side::Left), 0.7, 1e-9);
}

TEST_F(ReviewQueueTest, AnAcceptedFrameLeavesItAtOnceAndComesBackWithUndo) {
    propose({{0, 0.1}, {5, 0.6}});
    queue->dropFrame(5);
    EXPECT_EQ(order(), (std::vector{0}));
    accept(5);
    EXPECT_EQ(order(), (std::vector{0}));
    EXPECT_EQ(queue->reviewed(), 1);
    EXPECT_EQ(queue->next(0), std::nullopt);
    document->undoStack()->undo();
    settle();
    EXPECT_EQ(order(), (std::vector{5, 0}));
    document->undoStack()->undo();
    settle();
    EXPECT_TRUE(queue->rows().empty()) << "the proposals are taken back";
    EXPECT_TRUE(queue->openHands().empty());
}

TEST_F(ReviewQueueTest, SurvivesARestartWithItsOrderAndWhatWasReviewed) {
    propose({{0, 0.1}, {5, 0.6}, {10, 0.3}, {15, 0.2}});
    const core::JointId joint{Side::Left, "index_tip"};
    click(5, joint, test::madeUpHand(Side::Left, 5)[8].second + Eigen::Vector3d(0, 0, 10));
    accept(5);
    accept(15);
    accept(0);
    ASSERT_TRUE(queue->progress().expectedErrorMm);
    const double expected = *queue->progress().expectedErrorMm;
    EXPECT_GT(expected, 0.01);
    restart();
    EXPECT_EQ(order(), (std::vector{10}));
    EXPECT_EQ(queue->reviewed(), 3);
    ASSERT_TRUE(queue->progress().expectedErrorMm);
    EXPECT_NEAR(*queue->progress().expectedErrorMm, expected, 1e-9);
}

TEST_F(ReviewQueueTest, IsOfTheDocumentsRaterAlone) {
    propose({{0, 0.1}, {5, 0.6}});
    document->setRater("bob");
    settle();
    EXPECT_TRUE(queue->rows().empty());
    document->setRater("ann");
    settle();
    EXPECT_EQ(queue->rows().size(), 2u);
}

} // namespace
