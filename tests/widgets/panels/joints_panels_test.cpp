// SPDX-License-Identifier: MIT
#include <algorithm>

#include <QLabel>
#include <QRegularExpression>
#include <QTableView>

#include "tests/support/pointer.h"
#include "tests/widgets/panels/panel_fixture.h"
#include "widgets/panels/empty_state.h"
#include "widgets/panels/hints.h"
#include "widgets/panels/joints_panel.h"
#include "widgets/panels/status_line.h"

namespace {

const core::JointId kRightPalm{core::Side::Right, "forearm"};

class JointsPanelTest : public test::PanelTest {
protected:
    JointsPanelTest() {
        panel.resize(300, 600);
        panel.show();
    }
    widgets::JointsPanel panel{session.joints, session.document, session.reconstructions, session.selection};
};

TEST_F(JointsPanelTest, RowsAndDotsSelect) {
    QTableView& table = *panel.table();
    ASSERT_EQ(table.model()->rowCount(), 4);
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(table.model()->index(2, 0)).center());
    EXPECT_EQ(session.selection.joint(), kRightPalm);
    const auto dot = panel.diagram()->dotPosition(index);
    ASSERT_TRUE(dot);
    test::click(panel.diagram(), *dot);
    EXPECT_EQ(session.selection.joint(), index);
    EXPECT_EQ(table.currentIndex().row(), 1);
}

TEST_F(JointsPanelTest, TheDotSaysHowFarAJointIs) {
    const auto colourAt = [&] {
        const QImage picture = panel.diagram()->grab().toImage();
        return picture.pixelColor(panel.diagram()->dotPosition(index)->toPoint());
    };
    session.selection.setJoint(kRightPalm);
    const QColor before = colourAt();
    for (int camera = 0; camera < 8; ++camera)
        click(index, camera);
    const QColor after = colourAt();
    EXPECT_GT(std::abs(after.red() - before.red()) + std::abs(after.green() - before.green()) +
                  std::abs(after.blue() - before.blue()),
              60);
}

TEST_F(JointsPanelTest, NotesBelongToTheirFrameAndAreNeverLost) {
    widgets::NoteEdit& note = *panel.note();
    QTest::keyClicks(&note, QStringLiteral("thumb hidden"));
    QTest::keyClick(&note, Qt::Key_Return);
    EXPECT_EQ(session.document.annotations().notes.at(12), "thumb hidden");
    session.selection.setFrame(13);
    EXPECT_TRUE(note.text().isEmpty());
    QTest::keyClicks(&note, QStringLiteral("blurred"));
    session.opened.openSequence(QStringLiteral("b")); // without Enter, and without leaving the field
    settle();
    EXPECT_TRUE(note.text().isEmpty());
    session.opened.openSequence(QStringLiteral("a"));
    settle();
    EXPECT_EQ(session.document.annotations().notes.at(13), "blurred");
    session.document.undoStack()->undo();
    EXPECT_EQ(session.document.annotations().notes.count(13), 0u);
}

TEST_F(JointsPanelTest, NamesCanBeReadInANarrowWindow) {
    session.joints.setChoice(widgets::JointChoice::TwentyOne, *session.opened.dataset());
    widgets::JointsPanel narrow(session.joints, session.document, session.reconstructions, session.selection);
    for (const int width : {200, 240, 290, 420}) {
        narrow.resize(width, 600);
        narrow.show();
        QApplication::processEvents();
        const QTableView& table = *narrow.table();
        EXPECT_GE(table.columnWidth(widgets::JointTableModel::Joint),
                  static_cast<const QAbstractItemView&>(table).sizeHintForColumn(widgets::JointTableModel::Joint))
            << width;
        EXPECT_FALSE(table.isColumnHidden(widgets::JointTableModel::ErrorPx));
        EXPECT_EQ(table.isColumnHidden(widgets::JointTableModel::State), width <= 240) << width;
    }
}

TEST_F(JointsPanelTest, TheStatusLineSaysWhatToDoNext) {
    widgets::StatusLine line(session.document, session.reconstructions, session.selection);
    line.resize(900, 24);
    line.show();
    const auto says = [&](const char* words) {
        const auto labels = line.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->text().contains(QString::fromUtf8(words)); });
    };
    EXPECT_TRUE(says("Click index_mcp in any view"));
    click(index, 0);
    EXPECT_TRUE(says("in a second view"));
    click(index, 2);
    EXPECT_TRUE(says("next"));
    EXPECT_TRUE(says("mm"));
    line.sayBriefly(QStringLiteral("nothing there"));
    EXPECT_TRUE(says("nothing there"));
    QSignalSpy stopped(&line, &widgets::StatusLine::stopRequested);
    line.showWork(QStringLiteral("Fitting"), 0.5);
    EXPECT_TRUE(says("Fitting"));
    QTest::mouseClick(line.findChild<QToolButton*>(QStringLiteral("stop")), Qt::LeftButton);
    EXPECT_EQ(stopped.count(), 1);
}

TEST_F(JointsPanelTest, TheStatusLineSaysHowMuchOfALargeEditIsSaved) {
    widgets::StatusLine line(session.document, session.reconstructions, session.selection);
    core::Edit edit{{.text = "many"}, {}, {}};
    for (int frame = 0; frame < 8000; ++frame)
        edit.marks.push_back({{frame, "other", index, "cam0"}, std::nullopt, core::Mark{{1, 2}}});
    std::vector<int> percents;
    const auto look = [&] {
        for (const QLabel* label : line.findChildren<QLabel*>())
            if (const auto found = QRegularExpression(QStringLiteral("^saving, (\\d+) %$")).match(label->text());
                found.hasMatch())
                percents.push_back(found.captured(1).toInt());
    };
    QObject::connect(&session.document, &widgets::AnnotationDocument::busyProgressed, look);
    session.document.push(std::move(edit));
    look();
    ASSERT_TRUE(test::waitUntil([this] { return !session.document.isBusy(); }, 60000));
    ASSERT_GT(percents.size(), 5u);
    EXPECT_TRUE(std::is_sorted(percents.begin(), percents.end()));
    EXPECT_LT(percents.front(), 20);
    EXPECT_GT(percents.back(), 60);
    EXPECT_LT(percents.back(), 100);
    const std::size_t seen = percents.size();
    look();
    EXPECT_EQ(percents.size(), seen) << "it still says that it saves";
}

TEST(EmptyState, OffersWhatToDo) {
    widgets::EmptyState state;
    state.setRecentDatasets({QStringLiteral("/data/one"), QStringLiteral("/data/two")});
    state.resize(800, 600);
    state.show();
    QSignalSpy open(&state, &widgets::EmptyState::openRequested), demo(&state, &widgets::EmptyState::demoRequested),
        recent(&state, &widgets::EmptyState::recentRequested);
    for (QAbstractButton* button : state.findChildren<QAbstractButton*>())
        button->click();
    EXPECT_EQ(open.count(), 1);
    EXPECT_EQ(demo.count(), 1);
    ASSERT_EQ(recent.count(), 2);
    EXPECT_EQ(recent[0][0].toString(), QStringLiteral("/data/one"));
}

TEST(Hints, CanBeClosed) {
    QWidget window;
    window.resize(900, 600);
    window.show();
    widgets::Hints hints(&window);
    hints.show();
    QSignalSpy closed(&hints, &widgets::Hints::closed);
    hints.findChild<QAbstractButton*>()->click();
    EXPECT_EQ(closed.count(), 1);
    EXPECT_FALSE(hints.isVisible());
}

} // namespace
