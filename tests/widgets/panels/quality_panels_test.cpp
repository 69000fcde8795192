// SPDX-License-Identifier: MIT
#include <QTableView>

#include "tests/widgets/panels/panel_fixture.h"
#include "widgets/panels/quality/quality_panel.h"
#include "widgets/panels/raters_panel.h"

namespace {

class QualityPanelTest : public test::PanelTest {
protected:
    QualityPanelTest() {
        panel.resize(340, 400);
        panel.show();
    }
    QTableView& table() { return *child<QTableView>(panel); }
    widgets::QualityPanel panel{{session.document, session.selection, session.reconstructions, session.joints,
                                 session.coverage, session.checks, session.raters, session.rig}};
};

TEST_F(QualityPanelTest, ListsTheClickThatDisagreesAndJumpsThere) {
    for (const int camera : {0, 1, 2, 3, 4})
        click(index, camera, camera == 3 ? 40 : 0);
    settle();
    ASSERT_EQ(table().model()->rowCount(), 1);
    EXPECT_TRUE(cell(table(), 0, widgets::FindingModel::What).contains(QStringLiteral("cam3")));
    EXPECT_EQ(cell(table(), 0, widgets::FindingModel::Joint), QStringLiteral("L index_mcp"));
    session.selection.setCamera("cam0");
    session.selection.setJoint({core::Side::Right, "index_mcp"});
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                      table().visualRect(table().model()->index(0, 0)).center());
    EXPECT_EQ(session.selection.camera(), "cam3");
    EXPECT_EQ(session.selection.joint(), index);
}

TEST_F(QualityPanelTest, TheWholeSequenceCanBeListed) {
    for (const int camera : {0, 1, 2, 3, 4})
        click(index, camera, camera == 3 ? 40 : 0);
    settle();
    session.selection.setFrame(20);
    EXPECT_EQ(table().model()->rowCount(), 0);
    child<QComboBox>(panel)->setCurrentIndex(1);
    ASSERT_EQ(table().model()->rowCount(), 1);
    EXPECT_FALSE(table().isColumnHidden(widgets::FindingModel::Frame));
    EXPECT_EQ(cell(table(), 0, widgets::FindingModel::Frame), QStringLiteral("12"));
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                      table().visualRect(table().model()->index(0, 0)).center());
    EXPECT_EQ(session.selection.frame(), 12);
}

TEST_F(QualityPanelTest, TheSummaryCountsEveryJointOnce) {
    for (const int camera : {0, 1, 2, 3, 4})
        click(index, camera, camera == 3 ? 40 : 0);
    settle();
    const auto labels = panel.findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->text().contains(QStringLiteral("Joints: 0 done, 0 partial, 1 bad."));
    }));
}

TEST_F(QualityPanelTest, TheThresholdDecidesWhatIsBad) {
    for (const int camera : {0, 1, 2, 3, 4})
        click(index, camera, camera % 2 == 0 ? 0.8 : -0.8);
    settle();
    EXPECT_EQ(table().model()->rowCount(), 0);
    QSignalSpy changed(&panel, &widgets::QualityPanel::badRmsPxChanged);
    child<QDoubleSpinBox>(panel)->setValue(0.3);
    ASSERT_EQ(changed.count(), 1);
    EXPECT_DOUBLE_EQ(session.coverage.badRmsPx(), 0.3);
    ASSERT_EQ(table().model()->rowCount(), 1);
    EXPECT_TRUE(cell(table(), 0, 0).contains(QStringLiteral("px")));
}

class RatersPanelTest : public test::PanelTest {
protected:
    RatersPanelTest() {
        for (const int camera : {0, 1, 2, 3, 4}) {
            click(index, camera, 0.5);
            click(index, camera, -0.5, "bob");
        }
        panel.resize(340, 400);
        panel.show();
        settle();
    }
    widgets::RatersPanel panel{session.raters, session.selection, session.reconstructions, session.opened};
};

TEST_F(RatersPanelTest, ShowsHowFarTwoRatersAgree) {
    QTableView& table = *child<QTableView>(panel);
    ASSERT_EQ(table.model()->rowCount(), 2); // all joints, and the one
    EXPECT_EQ(cell(table, 1, widgets::AgreementModel::Joint), QStringLiteral("L index_mcp"));
    EXPECT_EQ(cell(table, 1, widgets::AgreementModel::Count), QStringLiteral("1"));
    EXPECT_NE(cell(table, 1, widgets::AgreementModel::MeanMm), QStringLiteral("0.00"));
    EXPECT_TRUE(table.model()
                    ->index(0, widgets::AgreementModel::BiasX)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("95 %")));
    EXPECT_EQ(child<QComboBox>(panel)->currentText(), QStringLiteral("ann \u2013 bob"));
    const auto labels = panel.findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(
        labels.begin(), labels.end(),
        [](const QLabel* label) { return label->text().contains(QStringLiteral("All raters together")); }));
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(),
                            [](const QLabel* label) { return label->text().contains(QStringLiteral("1.00 px")); }));
}

TEST_F(RatersPanelTest, TellsHowFarTheRepeatRoundIs) {
    session.raters.beginRepeating(1, 3);
    ASSERT_TRUE(test::waitUntil([&] { return session.raters.isRepeating(); }));
    const auto labels = panel.findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(),
                            [](const QLabel* label) { return label->text().contains(QStringLiteral("1 of 1")); }));
    QSignalSpy asked(&panel, &widgets::RatersPanel::roundRequested);
    const auto buttons = panel.findChildren<QPushButton*>();
    const auto end = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* button) {
        return button->text() == QStringLiteral("End the round");
    });
    ASSERT_NE(end, buttons.end());
    QTest::mouseClick(*end, Qt::LeftButton);
    EXPECT_EQ(asked.count(), 1);
}

} // namespace
