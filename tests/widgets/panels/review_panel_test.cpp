// SPDX-License-Identifier: MIT
#include "widgets/panels/review/review_panel.h"

#include <set>

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>

#include "core/io/detector/auto_label_file.h"
#include "tests/support/detection/fake_first_pass.h"
#include "tests/widgets/panels/panel_fixture.h"
#include "widgets/text/review_text.h"

namespace {

using core::Side;

class ReviewPanelTest : public test::PanelTest {
protected:
    ReviewPanelTest() {
        session.firstPass.setProgram(test::fakeFirstPass(fake));
        panel.resize(320, 400);
        panel.show();
    }
    void propose(const std::map<int, double>& doubts) {
        core::AutoLabels labels;
        for (const auto& [frame, doubt] : doubts)
            for (const Side side : {Side::Left, Side::Right})
                labels[frame].push_back(test::madeUpLabel(side, frame, doubt));
        session.document.push(
            core::autoLabelEdit(session.document.annotations(), *session.opened.dataset(), labels, "ann"));
        settle();
    }
    bool says(const QString& part) {
        for (const QLabel* label : panel.findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(part))
                return true;
        return false;
    }

    std::shared_ptr<test::FakeFirstPass> fake = std::make_shared<test::FakeFirstPass>();
    widgets::ReviewPanel panel{{session.review, session.selection, session.firstPass, session.opened, session.joints}};
};

TEST_F(ReviewPanelTest, ListsTheFramesThatWaitAndARowJumpsToItsFrame) {
    const QAbstractItemModelTester tester(panel.table()->model(),
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    EXPECT_FALSE(panel.table()->isVisible());
    propose({{0, 0.05}, {5, 0.6}, {10, 0.85}});
    ASSERT_TRUE(panel.table()->isVisible());
    ASSERT_EQ(panel.table()->model()->rowCount(), 3);
    EXPECT_EQ(cell(*panel.table(), 0, widgets::ReviewModel::Frame), QStringLiteral("10"));
    EXPECT_EQ(cell(*panel.table(), 0, widgets::ReviewModel::Doubt), QStringLiteral("85"));
    EXPECT_EQ(cell(*panel.table(), 1, widgets::ReviewModel::Frame), QStringLiteral("5"));
    EXPECT_TRUE(cell(*panel.table(), 0, widgets::ReviewModel::Reason).contains(QStringLiteral("views do not agree")));
    EXPECT_TRUE(says(QStringLiteral("3 frame")));
    EXPECT_TRUE(says(QStringLiteral("2 of them doubtful")));
    EXPECT_TRUE(says(QStringLiteral("once three frames are reviewed")));
    const QRect row = panel.table()->visualRect(panel.table()->model()->index(1, 1));
    QTest::mouseClick(panel.table()->viewport(), Qt::LeftButton, {}, row.center());
    EXPECT_EQ(session.selection.frame(), 5);
    session.selection.setFrame(10);
    EXPECT_EQ(panel.table()->currentIndex().row(), 0) << "the current frame's row is the selected one";
}

TEST_F(ReviewPanelTest, ReasonsAreSaidInWords) {
    core::ProposedFrame frame;
    frame.doubt = 0.6;
    frame.joint = {Side::Right, "ring_tip"};
    std::set<QString> texts;
    for (const core::DoubtReason reason :
         {core::DoubtReason::Unsure, core::DoubtReason::HandMissing, core::DoubtReason::JointsMissing,
          core::DoubtReason::BoneLength, core::DoubtReason::Jump}) {
        frame.reason = reason;
        frame.value = reason == core::DoubtReason::BoneLength ? -0.18 : 7;
        EXPECT_TRUE(texts.insert(widgets::doubtReasonText(frame)).second);
        frame.joint.hand = Side::Left;
        EXPECT_TRUE(texts.insert(widgets::doubtReasonText(frame)).second) << "left and right are told apart";
        frame.joint.hand = Side::Right;
    }
    EXPECT_TRUE(texts.count(QStringLiteral("R ring_tip: its bone is 18 % shorter than usual")));
}

TEST_F(ReviewPanelTest, TheFormChoosesFramesHandsAndJoints) {
    widgets::FirstPassForm& form = *panel.firstPass();
    ASSERT_TRUE(form.isVisible()) << "nothing waits: the first pass is what to do";
    EXPECT_EQ(form.request().frames.size(), 30u) << "a short sequence: every frame";
    EXPECT_TRUE(form.request().joints.contains({Side::Right, "wrist"}));
    EXPECT_TRUE(form.request().joints.contains({Side::Left, "little_tip"}));
    form.setFrames(2, 20, 6);
    EXPECT_EQ(form.request().frames, (std::vector{2, 8, 14, 20}));
    form.setFrames(0, 1000, 40);
    EXPECT_EQ(form.request().frames, (std::vector{0})) << "as far as the sequence goes";
    for (QCheckBox* box : form.findChildren<QCheckBox*>())
        box->setChecked(false);
    EXPECT_EQ(form.request().joints.size(), session.joints.joints().size());
    form.start();
    EXPECT_TRUE(says(QStringLiteral("Choose a hand.")));
    EXPECT_TRUE(session.document.annotations().marks.empty());
}

TEST_F(ReviewPanelTest, TheFormMakesRoomForTheQueueAndComesBack) {
    propose({{0, 0.05}, {5, 0.6}});
    EXPECT_FALSE(panel.firstPass()->isVisible());
    panel.setFormShown(true);
    EXPECT_TRUE(panel.firstPass()->isVisible());
    EXPECT_TRUE(panel.table()->isVisible());
    session.document.undoStack()->undo();
    settle();
    panel.setFormShown(false);
    EXPECT_TRUE(panel.firstPass()->isVisible()) << "nothing waits any more";
}

} // namespace
