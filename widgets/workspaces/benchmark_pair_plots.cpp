// SPDX-License-Identifier: MIT
#include "widgets/workspaces/benchmark_pair_plots.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <QHBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/text/local_text.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

using core::PairField;

/// From one to fifteen frames apart, pale to full.
QColor differenceColour(std::size_t place, std::size_t count) {
    constexpr double kPalest = 0.4;
    return errorColour(
        count < 2 ? 1 : kPalest + (1 - kPalest) * static_cast<double>(place) / static_cast<double>(count - 1));
}

std::vector<int> differencesOf(const std::vector<core::FramePair>& pairs) {
    std::set<int> differences;
    for (const core::FramePair& pair : pairs)
        differences.insert(pair.difference());
    return {differences.begin(), differences.end()};
}

std::vector<int> differencesShown(const PairTableModel& model) {
    std::vector<core::FramePair> shown;
    for (const std::size_t pair : model.shown())
        shown.push_back(model.table()->pairs[pair]);
    return differencesOf(shown);
}

std::size_t placeIn(const std::vector<int>& differences, int difference) {
    return static_cast<std::size_t>(std::lower_bound(differences.begin(), differences.end(), difference) -
                                    differences.begin());
}

QString methodName(const PairTableModel& model, std::size_t method) {
    return toQString(model.table()->methods[method]);
}

} // namespace

BenchmarkPairPlots::BenchmarkPairPlots(QWidget* parent)
    : QWidget(parent)
    , m_scatter(new ScatterPlot(this))
    , m_histogram(new HistogramPlot(this))
    , m_boxes(new BoxPlot(this)) {
    m_scatter->setObjectName(QStringLiteral("pairScatter"));
    m_histogram->setObjectName(QStringLiteral("pairHistogram"));
    m_boxes->setObjectName(QStringLiteral("pairBoxes"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpacing / 2);
    for (QWidget* plot : std::initializer_list<QWidget*>{m_scatter, m_histogram, m_boxes})
        row->addWidget(plot, 1);
    connect(m_scatter, &ScatterPlot::pointClicked, this, &BenchmarkPairPlots::pairClicked);
    connect(
        m_histogram, &HistogramPlot::rangeClicked, this,
        [this](double low, double high) {
            QStringList conditions;
            if (std::isfinite(low))
                conditions << QStringLiteral("A-B>=%1").arg(low);
            if (std::isfinite(high))
                conditions << QStringLiteral("A-B<%1").arg(high);
            emit conditionClicked(conditions.join(QLatin1Char(' ')));
        });
    connect(m_boxes, &BoxPlot::categoryClicked, this, [this](int category) {
        emit conditionClicked(QStringLiteral("difference=%1").arg(m_differences[static_cast<std::size_t>(category)]));
    });
}

void BenchmarkPairPlots::showPairs(const PairTableModel& model) {
    m_differences = model.table() ? differencesShown(model) : std::vector<int>{};
    showScatter(model);
    showHistogram(model);
    showBoxes(model);
}

void BenchmarkPairPlots::showScatter(const PairTableModel& model) {
    std::vector<ScatterPoint> points;
    std::vector<PlotLegendEntry> groups;
    PlotLabels labels{{}, {}, {}, tr("No pair that is shown has results of both methods.")};
    if (const auto& table = model.table(); table && !table->methods.empty()) {
        const auto [a, b] = model.compared();
        labels.title = tr("Every pair: click one to inspect it");
        labels.xLabel = tr("A: %1, mm").arg(methodName(model, a));
        labels.yLabel = tr("B: %1, mm").arg(methodName(model, b));
        for (const std::size_t pair : model.shown())
            points.push_back({{core::pairValue(*table, {PairField::ErrorMm, a, 0}, pair),
                               core::pairValue(*table, {PairField::ErrorMm, b, 0}, pair)},
                              pair,
                              placeIn(m_differences, table->pairs[pair].difference())});
        const std::vector<int> all = differencesOf(table->pairs); // a filter changes no colour
        for (std::size_t i = 0; i < m_differences.size(); ++i)
            groups.push_back({i == 0 ? tr("frames apart: %1").arg(m_differences[i]) : QString::number(m_differences[i]),
                              differenceColour(placeIn(all, m_differences[i]), all.size())});
        m_scatter->setNames([table](std::size_t pair) {
            const core::FramePair& named = table->pairs[pair];
            return tr("%1, %2 to %3").arg(toQString(named.sequence)).arg(named.start).arg(named.test);
        });
    }
    m_scatter->setLabels(labels);
    m_scatter->setPoints(std::move(points), std::move(groups));
}

void BenchmarkPairPlots::showHistogram(const PairTableModel& model) {
    core::Histogram histogram;
    PlotLegendEntry below, above;
    PlotLabels labels{{}, {}, {}, tr("No pair that is shown has results of both methods.")};
    if (const auto& table = model.table(); table && !table->methods.empty()) {
        const auto [a, b] = model.compared();
        std::vector<double> values;
        int better = 0, worse = 0;
        for (const std::size_t pair : model.shown()) {
            values.push_back(core::pairValue(*table, {PairField::ErrorDifferenceMm, a, b}, pair));
            better += values.back() < 0 ? 1 : 0;
            worse += values.back() > 0 ? 1 : 0;
        }
        histogram = core::roundHistogram(values);
        labels.title = tr("Where A and B differ");
        labels.xLabel = tr("A \u2212 B, mm");
        labels.yLabel = tr("Pairs");
        below = {tr("A is better: %1").arg(better), methodColour(table->methods[a])};
        above = {tr("B is better: %1").arg(worse), methodColour(table->methods[b])};
    }
    m_histogram->setLabels(labels);
    m_histogram->setHistogram(std::move(histogram), below, above);
}

void BenchmarkPairPlots::showBoxes(const PairTableModel& model) {
    QStringList categories;
    std::vector<BoxPlot::Series> series;
    PlotLabels labels{{}, {}, {}, tr("No pair is shown.")};
    if (const auto& table = model.table(); table && !table->methods.empty()) {
        labels.title = tr("By frames apart: quartiles, and 5 to 95 %");
        labels.xLabel = tr("Frames apart");
        labels.yLabel = tr("Error, mm");
        for (const int difference : m_differences)
            categories << QString::number(difference);
        const auto [a, b] = model.compared();
        for (const std::size_t method : {a, b}) {
            std::vector<std::vector<double>> errors(m_differences.size());
            for (const std::size_t pair : model.shown())
                errors[placeIn(m_differences, table->pairs[pair].difference())].push_back(
                    table->columns[method].errorMm[pair]);
            BoxPlot::Series one{{methodName(model, method), methodColour(table->methods[method])}, {}};
            for (std::vector<double>& values : errors)
                one.boxes.push_back(core::boxStatistics(std::move(values)));
            series.push_back(std::move(one));
            if (a == b)
                break;
        }
    }
    m_boxes->setLabels(labels);
    m_boxes->setBoxes(categories, std::move(series));
}

} // namespace widgets
