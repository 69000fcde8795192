// SPDX-License-Identifier: MIT
#include "widgets/panels/timeline.h"

#include <set>

#include <QLabel>
#include <QSignalSpy>

#include <gtest/gtest.h>

#include "tests/support/pointer.h"
#include "widgets/panels/state_colours.h"
#include "widgets/panels/timeline_legend.h"

namespace {

class TimelineTest : public testing::Test {
protected:
    TimelineTest() {
        timeline.setFrameCount(100);
        timeline.resize(812, 40);
        timeline.show();
    }
    /// The lane of a hand at a frame: the colour a pixel above its lower edge.
    QColor laneAt(int frame, core::Side hand) {
        const QImage picture = timeline.grab().toImage();
        const int x = 6 + frame * 8 + 3;
        const int top = (timeline.height() - 19) / 2;
        return picture.pixelColor(x, top + (hand == core::Side::Left ? 5 : 16));
    }
    widgets::Timeline timeline;
};

TEST_F(TimelineTest, ShowsEachHandInItsLane) {
    timeline.setFrame(99);
    widgets::FrameCoverage frames;
    frames[20][core::Side::Left].done = 14;
    frames[30][core::Side::Left].partial = 14;
    frames[40][core::Side::Right].partial = 14;
    frames[40][core::Side::Right].bad = 1;
    timeline.setCoverage(frames, 14, 14);
    EXPECT_EQ(laneAt(20, core::Side::Left), widgets::kDoneColour);
    EXPECT_EQ(laneAt(30, core::Side::Left), widgets::kPartialColour);
    EXPECT_EQ(laneAt(40, core::Side::Right), widgets::kBadColour);
    EXPECT_NE(laneAt(40, core::Side::Left), widgets::kBadColour);
    EXPECT_EQ(laneAt(60, core::Side::Left), laneAt(70, core::Side::Right)) << "nothing there";
}

TEST_F(TimelineTest, StripesHandsThatWaitForALook) {
    timeline.setFrame(99);
    timeline.setProposedHands(
        {{20, {{core::Side::Left, 0.05}}}, {30, {{core::Side::Left, 0.1}, {core::Side::Right, 0.9}}}});
    const QImage picture = timeline.grab().toImage();
    const int top = (timeline.height() - 19) / 2;
    const auto at = [&](int frame, int y) { return picture.pixelColor(6 + frame * 8 + 3, top + y); };
    EXPECT_EQ(at(20, 5), widgets::kProposedColour);
    EXPECT_NE(at(20, 4), widgets::kProposedColour) << "stripes, not a bar";
    EXPECT_NE(at(20, 16), widgets::kProposedColour) << "the other hand does not wait";
    EXPECT_EQ(at(30, 5), widgets::kProposedColour);
    EXPECT_EQ(at(30, 16), widgets::kDoubtfulColour);
    EXPECT_TRUE(timeline.toolTipOf(30).contains(QStringLiteral("doubt 90 %")));
}

TEST_F(TimelineTest, MarksTestFramesBelow) {
    const QImage before = timeline.grab().toImage();
    timeline.setTestFrames({50});
    const QImage after = timeline.grab().toImage();
    EXPECT_NE(before, after);
    const int x = 6 + 50 * 8 + 4, y = (timeline.height() + 19) / 2 + 1;
    EXPECT_EQ(after.pixelColor(x, y), timeline.palette().color(QPalette::Highlight));
}

TEST_F(TimelineTest, APressGoesToItsFrame) {
    QSignalSpy asked(&timeline, &widgets::Timeline::frameRequested);
    test::press(&timeline, {6 + 42.5 * 8, 20});
    test::moveTo(&timeline, {5000, 20}, Qt::LeftButton);
    test::release(&timeline, {5000, 20});
    ASSERT_EQ(asked.count(), 2);
    EXPECT_EQ(asked[0][0].toInt(), 42);
    EXPECT_EQ(asked[1][0].toInt(), 99);
}

TEST_F(TimelineTest, TheLegendExplainsTheColoursThatArePainted) {
    std::set<QRgb> explained;
    for (const widgets::TimelineMeaning& meaning : widgets::timelineMeanings(timeline.palette())) {
        EXPECT_FALSE(meaning.text.isEmpty());
        EXPECT_TRUE(explained.insert(meaning.colour.rgb()).second) << "two meanings of one colour";
    }
    widgets::FrameCoverage frames;
    frames[20][core::Side::Left].done = 14;
    frames[30][core::Side::Left].partial = 14;
    frames[40][core::Side::Left].bad = 1;
    frames[50][core::Side::Left].occluded = frames[50][core::Side::Left].done = 14;
    timeline.setCoverage(frames, 14, 14);
    for (const QColor& painted : {widgets::kDoneColour, widgets::kPartialColour, widgets::kBadColour,
                                  widgets::kOccludedColour, widgets::kProposedColour, widgets::kDoubtfulColour})
        EXPECT_TRUE(explained.count(painted.rgb()));
    const QString tip = timeline.toolTipOf(20);
    EXPECT_TRUE(tip.contains(QStringLiteral("Frame 20")));
    EXPECT_TRUE(tip.contains(widgets::kBadColour.name())) << "the tool tip holds the legend";
    widgets::TimelineLegend legend;
    EXPECT_GE(legend.findChildren<QLabel*>().size(), 2 * static_cast<int>(explained.size()));
}

} // namespace
