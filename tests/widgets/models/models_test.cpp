// SPDX-License-Identifier: MIT
#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include <gtest/gtest.h>

#include "core/annotation/edits.h"
#include "tests/support/clicks.h"
#include "tests/support/recordings/ring_dataset.h"
#include "widgets/models/joint_table_model.h"
#include "widgets/models/result_table_model.h"
#include "widgets/text/advice.h"

namespace {

using namespace widgets;

const core::JointId kIndex{core::Side::Left, "index_mcp"};
constexpr auto kFatal = QAbstractItemModelTester::FailureReportingMode::Fatal;

class JointTableModelTest : public testing::Test {
protected:
    JointTableModelTest() {
        document.setRater("ann");
        document.open({});
        reconstructions.setDataset(dataset);
        selection.setFrameCount(300);
        joints.setCustom({{core::Side::Right, "thumb_ip"}, kIndex});
    }
    QVariant at(int row, int column, int role = Qt::DisplayRole) const { return model.index(row, column).data(role); }
    void clickAt(int camera, Eigen::Vector2d px) {
        document.push(core::placeEdit(document.annotations(), {0, "ann", kIndex, "cam" + std::to_string(camera)}, px));
    }
    Eigen::Vector2d truth(int camera) const {
        return *core::project(dataset->cameras[static_cast<std::size_t>(camera)], {5, 6, 7});
    }

    std::shared_ptr<const core::Dataset> dataset = std::make_shared<const core::Dataset>(test::ringDataset());
    Selection selection;
    AnnotationDocument document;
    JointList joints;
    Reconstructions reconstructions{document, selection};
    JointTableModel model{joints, reconstructions};
    QAbstractItemModelTester tester{&model, kFatal};
};

TEST_F(JointTableModelTest, ShowsViewsErrorAndUncertainty) {
    EXPECT_EQ(at(1, JointTableModel::Joint), "L index_mcp");
    EXPECT_EQ(at(1, JointTableModel::Views), "");
    clickAt(0, truth(0));
    EXPECT_EQ(at(1, JointTableModel::Views), "1");
    EXPECT_EQ(at(1, JointTableModel::ErrorPx), "");
    clickAt(2, truth(2));
    EXPECT_EQ(at(1, JointTableModel::Views), "2");
    EXPECT_EQ(at(1, JointTableModel::ErrorPx), "0.00");
    EXPECT_GT(at(1, JointTableModel::SigmaMm, JointTableModel::ValueRole).toDouble(), 0.1);
    EXPECT_EQ(at(1, JointTableModel::State), "partial");
    EXPECT_EQ(at(0, JointTableModel::State), "none");
    EXPECT_FALSE(at(1, 0, JointTableModel::BadRole).toBool());
}

TEST_F(JointTableModelTest, AcceptedViewsAreToldFromClickedOnes) {
    clickAt(0, truth(0));
    clickAt(2, truth(2));
    core::Edit accept =
        core::acceptEdit(document.annotations(), dataset->cameras, selection.frame(), document.rater(), kIndex, "cam1");
    document.push(accept);
    EXPECT_EQ(at(1, JointTableModel::Views), "2+1");
    EXPECT_EQ(at(1, JointTableModel::Views, JointTableModel::ValueRole).toInt(), 3);
    EXPECT_TRUE(summaryText(kIndex, *reconstructions.find(kIndex)).contains(QStringLiteral("2+1 of 8")))
        << "the line counts as the table does";
    EXPECT_TRUE(at(1, JointTableModel::Views, Qt::ToolTipRole).toString().contains(QStringLiteral("1 accepted")));
}

TEST_F(JointTableModelTest, TwoViewsThatDisagreeAreBadNotDone) {
    clickAt(0, truth(0));
    clickAt(2, truth(2) + Eigen::Vector2d(3, 24));
    EXPECT_EQ(at(1, JointTableModel::State), "bad");
    EXPECT_TRUE(at(1, 0, JointTableModel::BadRole).toBool());
    EXPECT_TRUE(at(1, 0, Qt::ToolTipRole).toString().contains(QStringLiteral("px off cam")));
    EXPECT_TRUE(adviceText(kIndex, *reconstructions.find(kIndex)).contains(QStringLiteral("px off cam")));
}

TEST_F(JointTableModelTest, AJointThatIsOnlyProposedSaysSo) {
    document.push({{.kind = core::EditKind::Propose},
                   {{{selection.frame(), document.rater(), kIndex, "cam1"},
                     std::nullopt,
                     core::Mark{{300, 400}, core::Placement::Proposed, core::MarkState::Visible}}},
                   {}});
    EXPECT_EQ(at(1, JointTableModel::State), "proposed");
    EXPECT_EQ(at(1, JointTableModel::Views), "");
}

TEST_F(JointTableModelTest, DisagreeingClicksAreBad) {
    for (int camera = 0; camera < 5; ++camera)
        clickAt(camera, truth(camera));
    clickAt(5, truth(5) + Eigen::Vector2d(60, 0));
    EXPECT_TRUE(at(1, 0, JointTableModel::BadRole).toBool());
    EXPECT_TRUE(at(1, 0, Qt::ForegroundRole).isValid());
}

TEST_F(JointTableModelTest, FollowsListFrameAndUndo) {
    clickAt(0, truth(0));
    joints.setCustom({kIndex});
    EXPECT_EQ(model.rowCount(), 1);
    EXPECT_EQ(model.rowOf(kIndex), 0);
    EXPECT_EQ(at(0, JointTableModel::Views), "1");
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    selection.setFrame(4);
    EXPECT_GE(changed.count(), 1);
    EXPECT_EQ(at(0, JointTableModel::Views), "");
    selection.setFrame(0);
    document.undoStack()->undo();
    EXPECT_EQ(at(0, JointTableModel::Views), "");
    joints.setCustom({});
    EXPECT_EQ(model.rowCount(), 0);
}

TEST(ResultTableModel, ShowsEveryMethod) {
    ResultTableModel model;
    QAbstractItemModelTester tester(&model, kFatal);
    EXPECT_EQ(model.rowCount(), 0);
    auto outcome = std::make_shared<FitOutcome>();
    outcome->initialErrorMm = 8.25;
    MethodOutcome good;
    good.method = "ch";
    good.errorMm = 1.234;
    good.result.history.resize(11);
    good.result.seconds = 0.1234;
    MethodOutcome bad;
    bad.method = "dch-thres:tau=x";
    bad.failure = "tau: no number";
    outcome->methods = {good, bad};
    model.setOutcome(outcome);
    ASSERT_EQ(model.rowCount(), 2);
    const auto text = [&](int row, int column) { return model.index(row, column).data().toString(); };
    EXPECT_EQ(text(0, ResultTableModel::Method), "ch");
    EXPECT_EQ(text(0, ResultTableModel::InitialErrorMm), "8.25");
    EXPECT_EQ(text(0, ResultTableModel::ErrorMm), "1.23");
    EXPECT_EQ(text(0, ResultTableModel::Iterations), "11");
    EXPECT_EQ(text(0, ResultTableModel::Seconds), "0.123");
    EXPECT_EQ(text(1, ResultTableModel::ErrorMm), "failed");
    EXPECT_EQ(text(1, ResultTableModel::Seconds), "");
    EXPECT_EQ(model.index(1, 0).data(Qt::ToolTipRole).toString(), "tau: no number");
    model.setOutcome(nullptr);
    EXPECT_EQ(model.rowCount(), 0);
}

} // namespace
