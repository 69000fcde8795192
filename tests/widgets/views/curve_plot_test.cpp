// SPDX-License-Identifier: MIT
#include "widgets/views/curve_plot.h"

#include <cmath>
#include <set>

#include <QApplication>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include "tests/support/pointer.h"

namespace {

using namespace widgets;

int countNear(const QImage& image, const QColor& colour) {
    int found = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            found += std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                         std::abs(c.blue() - colour.blue()) <
                     60;
        }
    }
    return found;
}

class CurvePlotTest : public testing::Test {
protected:
    CurvePlotTest() {
        plot.resize(420, 260);
        plot.show();
        QApplication::processEvents();
    }
    static Curve line(const QColor& colour, double from, double to) {
        Curve curve;
        curve.name = QStringLiteral("a");
        curve.colour = colour;
        curve.points = {{0, from}, {10, to}};
        return curve;
    }
    CurvePlot plot;
};

TEST_F(CurvePlotTest, DrawsEveryCurveInItsColour) {
    EXPECT_EQ(countNear(plot.grab().toImage(), Qt::red), 0);
    plot.setCurves({line(Qt::red, 0, 5), line(Qt::blue, 5, 0)});
    const QImage image = plot.grab().toImage();
    EXPECT_GT(countNear(image, Qt::red), 200);
    EXPECT_GT(countNear(image, Qt::blue), 200);
}

TEST_F(CurvePlotTest, ARisingCurveRises) {
    plot.setCurves({line(Qt::red, 0, 5)});
    const QImage image = plot.grab().toImage();
    const auto heightAt = [&](int x) {
        for (int y = image.height() - 1; y >= 0; --y) {
            const QColor c = image.pixelColor(x, y);
            if (c.red() > 200 && c.green() < 90)
                return image.height() - y;
        }
        return 0;
    };
    EXPECT_GT(heightAt(330), heightAt(150) + 40);
    EXPECT_GT(heightAt(150), 0);
}

/// Columns of the picture that have the colour of a curve.
int columnsWith(const QImage& image, const QColor& colour) {
    int columns = 0;
    for (int x = 0; x < image.width(); ++x)
        columns += countNear(image.copy(x, 0, 1, image.height()), colour) > 0 ? 1 : 0;
    return columns;
}

TEST_F(CurvePlotTest, TheLegendLiesOverNoCurve) {
    CurvePlotSettings settings;
    settings.yMax = 10;
    plot.setSettings(settings);
    std::vector<Curve> curves{line(Qt::red, 1, 1), line(Qt::blue, 5, 5), line(Qt::magenta, 9, 9)};
    const auto below = [&] { return plot.grab().toImage().copy(0, 65, 420, 195); }; // the legend
    plot.setCurves({curves[0]});
    const int wide = columnsWith(below(), Qt::red);
    ASSERT_GT(wide, 300);
    for (std::size_t i = 0; i < curves.size(); ++i)
        curves[i].name = QStringLiteral("a method with a long name %1").arg(i);
    plot.setCurves(curves);
    const QImage image = below();
    for (const QColor& colour : {QColor(Qt::red), QColor(Qt::blue), QColor(Qt::magenta)})
        EXPECT_EQ(columnsWith(image, colour), wide) << colour.name().toStdString() << ": all of the curve";
}

TEST_F(CurvePlotTest, MarksAreLinesWithNamesAboveThePlot) {
    plot.setCurves({line(Qt::red, 0, 5)});
    const QImage plain = plot.grab().toImage();
    plot.setMarks({{0, QStringLiteral("first"), QStringLiteral("what is first")},
                   {6, QStringLiteral("second"), QStringLiteral("what is second")}});
    const QImage marked = plot.grab().toImage();
    EXPECT_NE(plain, marked);
    test::moveTo(&plot, {150, 150});
    EXPECT_EQ(plot.toolTip(), QStringLiteral("what is first"));
    test::moveTo(&plot, {380, 150});
    EXPECT_EQ(plot.toolTip(), QStringLiteral("what is second"));
    plot.setMarks({});
    EXPECT_EQ(plot.grab().toImage().copy(0, 0, 100, 260), plain.copy(0, 0, 100, 260));
}

/// Where the rows above the plot hold something else, as columns of the picture.
std::set<int> columnsOfNames(const QImage& with, const QImage& without) {
    std::set<int> columns;
    for (int y = 0; y < with.height() / 4; ++y)
        for (int x = 0; x < with.width(); ++x)
            if (with.pixel(x, y) != without.pixel(x, y))
                columns.insert(x);
    return columns;
}

TEST_F(CurvePlotTest, ANameThatHasNoRoomIsShortened) {
    plot.setCurves({line(Qt::red, 0, 5)});
    const QString empty = QStringLiteral(" ");
    const auto named = [&](const QString& middle, const QString& last) {
        plot.setMarks({{4, middle, {}}, {6, last, {}}});
        return plot.grab().toImage();
    };
    const QImage none = named(empty, empty);
    const std::set<int> whole = columnsOfNames(named(QStringLiteral("middle"), empty), none);
    EXPECT_GT(whole.size(), 20u) << "there is room for one word";
    EXPECT_EQ(columnsOfNames(named(QStringLiteral("middle level of the mesh"), empty), none), whole)
        << "its first word";
    EXPECT_GT(columnsOfNames(named(QStringLiteral("extraordinarylongname"), empty), none).size(), 20u) << "cut";
    const std::set<int> last = columnsOfNames(named(empty, QStringLiteral("the last name of them all, in full")), none);
    ASSERT_FALSE(last.empty());
    plot.setMarks({});
    const QImage plain = plot.grab().toImage();
    int right = 0; // of the frame: where the curve ends
    for (int x = 0; x < plain.width(); ++x)
        for (int y = 0; y < plain.height(); ++y)
            right = qRed(plain.pixel(x, y)) > 200 && qGreen(plain.pixel(x, y)) < 80 ? x : right;
    EXPECT_LE(*last.rbegin(), right + 4) << "not in the margin";
}

TEST_F(CurvePlotTest, AClickTellsItsX) {
    CurvePlotSettings settings;
    settings.xMin = 0;
    settings.xMax = 20;
    plot.setSettings(settings);
    plot.setCurves({line(Qt::red, 0, 5)});
    QSignalSpy clicked(&plot, &CurvePlot::xClicked);
    test::click(&plot, {200, 100});
    test::click(&plot, {300, 100});
    test::click(&plot, {1, 100});
    ASSERT_EQ(clicked.count(), 2) << "a click beside the axes is not on the curve";
    const double first = clicked[0][0].toDouble(), second = clicked[1][0].toDouble();
    EXPECT_GT(first, 0);
    EXPECT_LT(second, 20);
    // 100 px apart on an axis of 20 that is a little narrower than the widget.
    EXPECT_NEAR(second - first, 20.0 * 100 / 370, 0.6);
}

TEST_F(CurvePlotTest, SavesItselfAsVectorsOnPaper) {
    plot.setCurves({line(Qt::red, 0, 5)});
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("plot.svg"));
    ASSERT_TRUE(plot.saveSvg(path));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray svg = file.readAll();
    EXPECT_TRUE(svg.contains("<path"));
    EXPECT_TRUE(svg.contains("#ff0000"));
    EXPECT_FALSE(svg.contains("<image"));
    EXPECT_EQ(plot.grabPicture(2).size(), QSize(840, 520));
    EXPECT_EQ(plot.grabPicture(1).pixelColor(2, 2), QColor(Qt::white));
    EXPECT_FALSE(plot.saveSvg(folder.filePath(QStringLiteral("no/such/folder.svg"))));
}

TEST_F(CurvePlotTest, WhiteLinesStayVisibleOnPaper) {
    plot.setCurves({line(Qt::white, 0, 5)});
    EXPECT_GT(countNear(plot.grabPicture(1), QColor(42, 42, 42)), 100);
}

TEST_F(CurvePlotTest, CurvesWithNanInfinityAndNegativeValuesAreDrawn) {
    Curve odd = line(Qt::red, 0, 5);
    odd.points = {{0, 1}, {1, std::nan("")}, {2, HUGE_VAL}, {3, -1}, {4, 2}};
    CurvePlotSettings settings;
    settings.yLogarithmic = true;
    plot.setSettings(settings);
    plot.setCurves({odd, Curve{}});
    EXPECT_FALSE(plot.grab().isNull());
    test::moveTo(&plot, {200, 100});
    EXPECT_FALSE(plot.grab().isNull());
}

TEST_F(CurvePlotTest, AClickOnAnAxisOfIterationsIsAWholeOne) {
    CurvePlotSettings settings;
    settings.xWhole = true;
    plot.setSettings(settings);
    plot.setCurves({line(Qt::red, 0, 5)}); // from 0 to 10
    QSignalSpy clicked(&plot, &CurvePlot::xClicked);
    for (int x = 20; x < 420; x += 5)
        test::click(&plot, {double(x), 100});
    ASSERT_GT(clicked.count(), 15);
    std::set<double> found;
    for (const auto& click : clicked)
        found.insert(click[0].toDouble());
    for (const double x : found) {
        EXPECT_EQ(x, std::round(x));
        EXPECT_GE(x, 0);
        EXPECT_LE(x, 10);
    }
    EXPECT_EQ(found.size(), 11u) << "every iteration can be reached";
}

/// 8, 0.8, 0.08: equal steps on a logarithmic axis, and the last two are one on a linear axis.
TEST_F(CurvePlotTest, SmallErrorsAreToldApartOnALogarithmicAxis) {
    const auto heights = [&] {
        std::vector<int> found;
        const QImage image = plot.grabPicture();
        for (const QColor& colour : {QColor(Qt::red), QColor(Qt::blue), QColor(0, 160, 0)}) {
            int sum = 0, count = 0;
            for (int y = 0; y < image.height(); ++y) {
                const QColor c = image.pixelColor(240, y);
                if (std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                        std::abs(c.blue() - colour.blue()) <
                    120) {
                    sum += y;
                    ++count;
                }
            }
            found.push_back(count > 0 ? sum / count : -1);
        }
        return found;
    };
    plot.setCurves({line(Qt::red, 8, 8), line(Qt::blue, 0.8, 0.8), line(QColor(0, 160, 0), 0.08, 0.08)});
    EXPECT_LT(std::abs(heights()[1] - heights()[2]), 25);
    plot.setLogarithmic(true);
    const std::vector<int> y = heights();
    EXPECT_GT(y[2] - y[1], 40);
    EXPECT_NEAR(y[2] - y[1], y[1] - y[0], 3);
}

} // namespace
