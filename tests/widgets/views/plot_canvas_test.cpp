// SPDX-License-Identifier: MIT
// What all plots have around them.
#include "widgets/views/plot_canvas.h"

#include <cmath>

#include <QApplication>

#include <gtest/gtest.h>

#include "widgets/views/box_plot.h"
#include "widgets/views/histogram_plot.h"
#include "widgets/views/scatter_plot.h"

namespace {

using namespace widgets;

constexpr int kPlotWidth = 320, kPlotHeight = 260;
const QColor kDataColour(200, 40, 60);
constexpr int kTolerance = 80; // dots are a little transparent

/// Rows of a picture in which something has that colour.
struct ColouredRows {
    int first = -1, last = -1;
};

ColouredRows rowsOf(const QImage& picture, const QColor& colour, int fromRow) {
    ColouredRows rows;
    for (int y = fromRow; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QColor c = picture.pixelColor(x, y);
            if (std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                    std::abs(c.blue() - colour.blue()) >
                kTolerance)
                continue;
            rows.first = rows.first < 0 ? y : rows.first;
            rows.last = y;
        }
    }
    return rows;
}

/// The legend lies in the second line, and nothing of its colour between it and the data, which fill the lower half.
template <class Plot>
void expectLegendAbove(Plot& plot) {
    plot.resize(kPlotWidth, kPlotHeight);
    plot.setLabels({QStringLiteral("Title"), QStringLiteral("x"), QStringLiteral("y"), {}});
    const QImage picture = plot.grabPicture();
    const int line = QFontMetrics(plot.font()).height();
    const ColouredRows all = rowsOf(picture, kDataColour, 0);
    EXPECT_GE(all.first, line) << "below the title";
    EXPECT_LT(all.first, 3 * line);
    EXPECT_GT(rowsOf(picture, kDataColour, 4 * line).first, kPlotHeight / 3) << "the corners of the plot are free";
}

TEST(PlotCanvas, TheLegendStandsAboveAScatter) {
    ScatterPlot plot;
    plot.setPoints({{{1, 1}, 0, 0}, {{10, 1}, 1, 0}, {{10, 2}, 2, 0}}, {{QStringLiteral("group"), kDataColour}});
    expectLegendAbove(plot);
}

TEST(PlotCanvas, TheLegendStandsAboveAHistogramWhoseBarsEndBelowTheFrame) {
    HistogramPlot plot;
    core::Histogram histogram;
    histogram.from = 0;
    histogram.width = 1;
    histogram.counts = {2, 40, 3, 1};
    plot.setHistogram(histogram, {QStringLiteral("A"), Qt::blue}, {QStringLiteral("B"), kDataColour});
    plot.resize(kPlotWidth, kPlotHeight);
    const QImage picture = plot.grabPicture();
    const int line = QFontMetrics(plot.font()).height();
    const ColouredRows legend = rowsOf(picture.copy(0, 0, kPlotWidth, 2 * line), kDataColour, 0);
    EXPECT_GE(legend.first, 0);
    EXPECT_GT(rowsOf(picture, kDataColour, legend.last + 1).first, legend.last + line)
        << "the highest bar has headroom";
}

TEST(PlotCanvas, TheLegendStandsAboveBoxes) {
    BoxPlot plot;
    core::BoxStatistics low, high;
    low.count = high.count = 5;
    low.low = 0.2, low.lowerQuartile = 1, low.median = 2, low.upperQuartile = 3, low.high = 4;
    high = low;
    high.high = 10; // of a colour of its own, so that the axis goes further up
    plot.setBoxes({QStringLiteral("1")},
                  {{{QStringLiteral("a"), kDataColour}, {low}}, {{QStringLiteral("b"), Qt::blue}, {high}}});
    expectLegendAbove(plot);
}

/// The name of y is as long on the paper in a low plot as in a high one.
TEST(PlotCanvas, ALowPlotDoesNotCutTheNameOfItsAxis) {
    const auto inkOfName = [](int height) {
        ScatterPlot plot;
        plot.setPoints({{{0, 0}, 0, 0}, {{1, 1}, 1, 0}}, {});
        plot.resize(kPlotWidth, height);
        const QString name = QStringLiteral("Fehler, mm");
        const auto picture = [&](const QString& yLabel) {
            plot.setLabels({{}, QStringLiteral("x"), yLabel, {}});
            return plot.grabPicture();
        };
        const QImage with = picture(name);
        const int line = QFontMetrics(plot.font()).height();
        int first = height, last = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < line + 2; ++x)
                if (qGray(with.pixel(x, y)) < 200) {
                    first = std::min(first, y);
                    last = y;
                }
        return last - first;
    };
    const int whole = inkOfName(300);
    EXPECT_GT(whole, 40);
    EXPECT_NEAR(inkOfName(110), whole, 2);
}

} // namespace
