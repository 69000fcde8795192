// SPDX-License-Identifier: MIT
#include "widgets/views/camera/mark_item.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"
#include "widgets/views/camera/camera_view.h"
#include "widgets/views/joint_colours.h"

namespace {

using namespace widgets;

const QColor kSkin(150, 110, 90);

/// Marks on a plain image, looked at through a view; the mark's centre falls on the corner of four screen pixels.
class MarkItemTest : public testing::Test {
protected:
    MarkItemTest() {
        view.setCamera(test::cameraRing(1)[0]);
        view.resize(300, 320);
        view.show();
        QImage image(1080, 1920, QImage::Format_RGB32);
        image.fill(kSkin);
        view.setImage(image);
        look(1);
    }

    void look(double scale) { view.lookAt({500, 700}, scale); }

    QImage draw(const ViewMark& mark) {
        view.setMarks({mark});
        centre = view.imageToViewport(mark.px);
        return view.viewport()->grab().toImage();
    }
    QColor at(const QImage& image, double dx, double dy) const {
        return image.pixelColor((centre + QPointF(dx - 0.5, dy - 0.5)).toPoint());
    }

    static ViewMark mark(core::Side hand = core::Side::Left, const char* joint = "index_mcp") {
        ViewMark m;
        m.joint = {hand, joint};
        m.px = {500, 700};
        return m;
    }
    /// Screen pixels within reach of the mark that are not the image's.
    int changed(const QImage& image) const {
        int count = 0;
        for (int y = -30; y < 30; ++y)
            for (int x = -30; x < 30; ++x)
                count += at(image, x + 0.5, y + 0.5) != kSkin;
        return count;
    }
    /// Share of the directions in which the ring has its finger's colour.
    double ringShare(const QImage& image, const QColor& colour) const {
        int coloured = 0;
        constexpr int kDirections = 180;
        for (int i = 0; i < kDirections; ++i) {
            const double a = 2 * M_PI * i / kDirections;
            const QColor c = at(image, 4.5 * std::cos(a), 4.5 * std::sin(a));
            coloured += std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                            std::abs(c.blue() - colour.blue()) <
                        150;
        }
        return static_cast<double>(coloured) / kDirections;
    }

    /// In how many of the directions the ring is light: dark is where a dash ends.
    double lightShare(const QImage& image, const QColor& colour) const {
        int light = 0;
        constexpr int kDirections = 180;
        for (int i = 0; i < kDirections; ++i) {
            const double a = 2 * M_PI * i / kDirections;
            light += at(image, 4.5 * std::cos(a), 4.5 * std::sin(a)).lightness() > colour.lightness() / 2;
        }
        return static_cast<double>(light) / kDirections;
    }

    /// How much the ring stands out from the image, on average.
    double ringStrength(const QImage& image) const {
        double sum = 0;
        constexpr int kDirections = 180;
        for (int i = 0; i < kDirections; ++i) {
            const double a = 2 * M_PI * i / kDirections;
            const QColor c = at(image, 4.5 * std::cos(a), 4.5 * std::sin(a));
            sum += std::abs(c.red() - kSkin.red()) + std::abs(c.green() - kSkin.green()) +
                   std::abs(c.blue() - kSkin.blue());
        }
        return sum / kDirections;
    }

    CameraView view;
    QPointF centre;
};

TEST_F(MarkItemTest, TheCentreStaysOpenInEveryState) {
    for (int state = 0; state < 16; ++state) {
        ViewMark m = mark(state & 8 ? core::Side::Right : core::Side::Left);
        m.origin = state & 1 ? MarkOrigin::Auto : MarkOrigin::Manual;
        m.occluded = state & 2;
        m.outlier = state & 4;
        m.selected = state & 1;
        const QImage image = draw(m);
        EXPECT_EQ(at(image, 0.5, 0.5), kSkin) << state;
        EXPECT_EQ(at(image, -0.5, -0.5), kSkin) << state;
    }
}

TEST_F(MarkItemTest, LeftIsRoundAndRightIsSquare) {
    const QColor colour = fingerColour("index_mcp");
    const QImage left = draw(mark(core::Side::Left));
    EXPECT_GT(ringShare(left, colour), 0.88);
    EXPECT_EQ(at(left, 5.5, 5.5), kSkin);
    const QImage right = draw(mark(core::Side::Right));
    EXPECT_NE(at(right, 5.5, 5.5), kSkin);
    EXPECT_NE(at(right, -5.5, 5.5), kSkin);
}

TEST_F(MarkItemTest, ColourTellsTheFinger) {
    for (const char* joint : {"thumb_ip", "middle_pip", "ring_dip", "little_mcp", "wrist"})
        EXPECT_GT(ringShare(draw(mark(core::Side::Left, joint)), fingerColour(joint)), 0.85) << joint;
}

TEST_F(MarkItemTest, MeasuresElevenPixelsWithItsOutlineAtEveryZoom) {
    look(1);
    const int atOne = changed(draw(mark()));
    for (const double scale : {0.2, 6.0, 40.0}) {
        look(scale);
        EXPECT_EQ(changed(draw(mark())), atOne) << scale;
    }
    look(1);
    const QImage image = draw(mark());
    EXPECT_NE(at(image, 5.5, 0.5), kSkin);
    EXPECT_EQ(at(image, 7.5, 0.5), kSkin);
}

TEST_F(MarkItemTest, EveryKindKeepsItsSizeAtEveryZoom) {
    for (const MarkOrigin origin : {MarkOrigin::Manual, MarkOrigin::Auto, MarkOrigin::Proposed}) {
        for (const bool selected : {false, true}) {
            ViewMark m = mark(core::Side::Right);
            m.origin = origin;
            m.selected = selected;
            look(1);
            const int atOne = changed(draw(m));
            for (const double scale : {0.06, 0.25, 3.0, 64.0}) {
                look(scale);
                EXPECT_NEAR(changed(draw(m)), atOne, selected ? 0.1 * atOne : 0) << scale;
            }
        }
    }
}

TEST_F(MarkItemTest, AHandsLetterKeepsItsSizeAndPlace) {
    for (const double scale : {0.2, 1.0, 20.0}) {
        look(scale);
        view.setHandLabels({{core::Side::Left, {500, 700}, {0, 24}, QStringLiteral("L")}});
        centre = view.imageToViewport({500, 700});
        const QImage image = view.viewport()->grab().toImage();
        EXPECT_NE(at(image, 7.5, 24.5), kSkin) << scale;
        EXPECT_EQ(at(image, 0.5, 12.5), kSkin) << "off the hand";
        EXPECT_EQ(at(image, 8.5, 32.5), kSkin) << "round for the left hand";
        view.setHandLabels({{core::Side::Right, {500, 700}, {0, 24}, QStringLiteral("R")}});
        EXPECT_NE(at(view.viewport()->grab().toImage(), 8.5, 32.5), kSkin) << "square for the right one";
        view.setOverlaysHidden(true);
        EXPECT_EQ(at(view.viewport()->grab().toImage(), 8.5, 32.5), kSkin);
        view.setOverlaysHidden(false);
    }
}

TEST_F(MarkItemTest, ClickedAcceptedAndProposedDiffer) {
    const QColor colour = fingerColour("index_mcp");
    ViewMark m = mark();
    const QImage clicked = draw(m);
    EXPECT_GT(ringShare(clicked, colour), 0.88);
    m.origin = MarkOrigin::Auto;
    const QImage accepted = draw(m);
    EXPECT_EQ(at(clicked, 8.5, -5.5), kSkin);
    EXPECT_NE(at(accepted, 8, -5.5), kSkin) << "the accepted mark's dot";
    EXPECT_GT(lightShare(accepted, colour), 0.8) << "its ring is closed";
    EXPECT_LT(ringStrength(accepted), 0.92 * ringStrength(clicked)) << "and thinner";
    m.origin = MarkOrigin::Proposed;
    const QImage proposed = draw(m);
    EXPECT_LT(ringShare(proposed, colour), 0.7) << "dashed";
    EXPECT_LT(lightShare(proposed, colour), 0.75) << "with gaps";
    EXPECT_LT(ringStrength(proposed), 0.85 * ringStrength(clicked)) << "and faint";
    EXPECT_EQ(at(proposed, 8, -5.5), kSkin);
}

TEST_F(MarkItemTest, ALineShowsHowFarAClickIsOffACurve) {
    ViewMark m = mark();
    m.curvePx = m.px + QPointF(40, 0);
    const QColor line = at(draw(m), 28, 0.5);
    EXPECT_GT(line.red(), line.green() + 100);
}

TEST_F(MarkItemTest, OccludedHasABarBelow) {
    ViewMark m = mark();
    const QImage plain = draw(m);
    EXPECT_EQ(at(plain, 0.5, 8.5), kSkin);
    m.occluded = true;
    const QImage occluded = draw(m);
    EXPECT_NE(at(occluded, 0.5, 8.5), kSkin);
    EXPECT_NE(at(occluded, -4.5, 8.5), kSkin);
}

TEST_F(MarkItemTest, OutlierIsCrossedInRed) {
    ViewMark m = mark();
    m.outlier = true;
    const QImage image = draw(m);
    for (const QPointF d : {QPointF(6.5, 6.5), QPointF(-6.5, 6.5), QPointF(6.5, -6.5), QPointF(-6.5, -6.5)}) {
        const QColor c = at(image, d.x(), d.y());
        EXPECT_GT(c.red(), c.green() + 60) << d.x() << " " << d.y();
    }
}

TEST_F(MarkItemTest, SelectedHasAHaloAndACrossHairWithAGap) {
    ViewMark m = mark();
    EXPECT_EQ(at(draw(m), 14.5, 0), kSkin);
    m.selected = true;
    const QImage image = draw(m);
    for (const QPointF d : {QPointF(14, 0), QPointF(-14, 0), QPointF(0, 14), QPointF(0, -14)}) {
        const QColor c = at(image, d.x(), d.y());
        EXPECT_NE(c, kSkin);
    }
    EXPECT_GT(at(image, 8.5, 0.5).lightness(), kSkin.lightness());
    for (double x = -1.5; x < 2; ++x)
        EXPECT_EQ(at(image, x, 0.5), kSkin) << "the gap is open at " << x;
}

TEST_F(MarkItemTest, LabelsAppearWhenAskedForAndForTheSelectedMark) {
    ViewMark m = mark();
    m.label = QStringLiteral("left index_mcp");
    const int without = changed(draw(m));
    view.setLabelsShown(true);
    EXPECT_GT(changed(draw(m)), without + 100);
}

} // namespace
