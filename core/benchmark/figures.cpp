// SPDX-License-Identifier: MIT
#include "core/benchmark/figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
#include <limits>

#include "core/benchmark/metrics.h"
#include "core/benchmark/sweep.h"
#include "core/fitting/method_name.h"
#include "core/text/number_text.h"

namespace core {

namespace {

/// Colours of the methods, the same as in the window; yellow is darker, for white paper.
struct MethodColour {
    const char* method;
    const char* colour;
};
constexpr std::array<MethodColour, 7> kMethodColours = {{{"initial", "#9AA0A6"},
                                                         {"ch", "#E69F00"},
                                                         {"dch-thres", "#56B4E9"},
                                                         {"dch-quant", "#CC79A7"},
                                                         {"dch-quant2", "#D55E00"},
                                                         {"dch-dt3", "#009E73"},
                                                         {"best", "#B8A800"}}};
constexpr std::array<const char*, 6> kOtherColours = {"#0072B2", "#7A5195", "#444444", "#8C564B", "#1B7837", "#A50F15"};

bool isExternal(const BenchmarkResults& results, const std::string& method) {
    return std::find(results.external.begin(), results.external.end(), method) != results.external.end();
}

/// The method without its options: what its colour follows.
std::string familyOf(const BenchmarkResults& results, const std::string& method) {
    return isExternal(results, method) ? std::string() : method.substr(0, method.find(':'));
}

const char* familyColour(const std::string& family) {
    for (const MethodColour& entry : kMethodColours)
        if (family == entry.method)
            return entry.colour;
    return nullptr;
}

/// Darker and lighter by turns, so that the variants of one method look like it and unlike each other. `variant` 0 is
/// the colour itself.
std::string shade(const char* colour, std::size_t variant) {
    constexpr std::array<double, 7> kShares = {0, -0.35, 0.4, -0.55, 0.6, -0.2, 0.2};
    const double share = kShares[variant % kShares.size()];
    std::array<unsigned, 3> rgb{};
    std::sscanf(colour, "#%2x%2x%2x", &rgb[0], &rgb[1], &rgb[2]);
    for (unsigned& part : rgb) {
        const double target = share < 0 ? 0 : 255;
        part = static_cast<unsigned>(std::lround(part + std::abs(share) * (target - part)));
    }
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02X%02X%02X", rgb[0], rgb[1], rgb[2]);
    return text.data();
}

/// A method's colour in every figure of these results: its family's, in a shade of its own if it has options; other
/// trackers have colours of the rest.
std::string colourOf(const BenchmarkResults& results, const std::string& method) {
    const auto external = std::find(results.external.begin(), results.external.end(), method);
    if (external != results.external.end())
        return kOtherColours[static_cast<std::size_t>(external - results.external.begin()) % kOtherColours.size()];
    const std::string family = familyOf(results, method);
    const char* colour = familyColour(family);
    if (colour == nullptr)
        return kOtherColours.back();
    const bool hasPlain = std::find(results.methods.begin(), results.methods.end(), family) != results.methods.end();
    std::size_t variant = method == family ? 0 : hasPlain ? 1 : 0;
    for (const std::string& other : results.methods) {
        if (other == method || method == family)
            break;
        variant += other != family && familyOf(results, other) == family ? 1 : 0;
    }
    return shade(colour, variant);
}

bool hasData(const std::vector<PlotLine>& lines) {
    return std::any_of(
        lines.begin(), lines.end(), [](const PlotLine& line) { return !line.points.empty(); });
}

Figure curvesFigure(const BenchmarkResults& results, const std::vector<std::string>& methods, const std::string& id,
                    const std::string& title) {
    std::vector<PlotLine> lines;
    for (const ErrorCurve& curve : errorCurves(results)) {
        const auto at = std::find(methods.begin(), methods.end(), curve.method);
        if (curve.method != "initial" && at == methods.end())
            continue;
        PlotLine line{curve.method, colourOf(results, curve.method), {}, "lines"};
        for (std::size_t i = 0; i < curve.share.size(); ++i)
            line.points.push_back({curve.thresholdsMm[i], 100 * curve.share[i]});
        lines.push_back(std::move(line));
    }
    return {
        id, title,
        "Share of the frame pairs whose mean joint error is below the threshold. Higher and further left is better.",
        gnuplotPreamble(id, "threshold (mm)", "pairs below it (%)") + "set yrange [0:100]\nset xrange [0:10]\n" +
            gnuplotPlot(lines)};
}

Figure differencesFigure(const BenchmarkResults& results, const std::vector<std::string>& methods) {
    const std::vector<int> differences = differencesOf(results);
    constexpr std::size_t kMostMarks = 12;
    std::string tics = "set offsets 0.5, 0.5, 0, 0\n";
    if (!differences.empty() && differences.size() > kMostMarks) {
        tics += gnuplotWholeTics("x", differences.front(), differences.back());
    } else {
        for (const int difference : differences)
            tics += (difference == differences.front() ? "set xtics (" : ", ") + std::to_string(difference);
        tics += differences.empty() ? "" : ")\n";
    }
    std::vector<PlotLine> lines;
    for (const std::string& method : methods) {
        PlotLine line{method, colourOf(results, method), {}};
        for (const int difference : differences) {
            const ErrorStatistics statistics = errorStatistics(results, method, difference);
            if (statistics.pairs > 0)
                line.points.push_back({static_cast<double>(difference), statistics.meanMm});
        }
        lines.push_back(std::move(line));
    }
    return {"differences", "Error over the distance of the start frame",
            "Mean joint error after the fit; the start pose is that many frames away.",
            gnuplotPreamble("differences", "frames between start and test", "mean error (mm)") + "set yrange [0:*]\n" +
                tics + gnuplotPlot(lines)};
}

Figure jointsFigure(const BenchmarkResults& results, const std::vector<std::string>& methods) {
    std::vector<PlotLine> lines;
    for (const std::string& method : methods) {
        PlotLine line{method, colourOf(results, method), {}, "points pt 7 ps 0.8"};
        const std::vector<double> means = meanJointErrorsMm(results, method);
        for (std::size_t j = 0; j < means.size(); ++j)
            if (!std::isnan(means[j]))
                line.points.push_back({static_cast<double>(j), means[j]});
        lines.push_back(std::move(line));
    }
    return {"joints", "Error per joint", "Mean error of every joint over all pairs.",
            gnuplotPreamble("joints", "", "mean error (mm)") + "set yrange [0:*]\nset grid xtics\n" +
                gnuplotNamedTics(readableNames(results.joints)) + gnuplotPlot(lines)};
}

Figure speedFigure(const BenchmarkResults& results, const std::vector<std::string>& methods) {
    std::vector<PlotLine> lines;
    for (const std::string& method : methods) {
        const ErrorStatistics statistics = errorStatistics(results, method);
        if (statistics.pairs > 0 && statistics.meanSeconds > 0) {
            lines.push_back({method,
                             colourOf(results, method),
                             {{statistics.meanSeconds, statistics.meanMm}},
                             "points pt 7 ps 1.2"});
        }
    }
    return {"speed", "Error against time", "One point per method; further left is faster, further down is more exact.",
            gnuplotPreamble("speed", "seconds per pair", "mean error (mm)") + "set yrange [0:*]\nset xrange [0:*]\n" +
                gnuplotPlot(lines)};
}

std::string scheduleName(Schedule schedule) {
    return schedule == Schedule::Paper ? "paper's schedule" : "rigid phase first";
}

std::vector<PlotLine> linesOf(const BenchmarkResults& results, const SweepFigure& sweep) {
    std::vector<PlotLine> lines;
    for (const SweepSeries& series : sweep.series) {
        PlotLine line{series.name, kOtherColours[lines.size() % kOtherColours.size()], {}};
        for (const SweepPoint& point : series.points) {
            const ErrorStatistics statistics = errorStatistics(results, point.method);
            if (statistics.pairs > 0)
                line.points.push_back({point.value, statistics.meanMm});
        }
        if (!line.points.empty())
            lines.push_back(std::move(line));
    }
    return lines;
}

Figure sweepFigure(const SweepFigure& sweep, const std::vector<PlotLine>& lines, Schedule schedule) {
    const std::string id = sweep.id + (schedule == Schedule::Paper ? "-paper" : "");
    const bool isLogarithmic = sweep.xLabel == "bins" || sweep.id == "tau";
    std::string tics = "set xtics (";
    for (std::size_t i = 0; i < lines.front().points.size(); ++i)
        tics += (i == 0 ? "" : ", ") + exactText(lines.front().points[i][0]);
    return {id, sweep.title + " (" + scheduleName(schedule) + ")", "Mean joint error over all pairs.",
            gnuplotPreamble(id, sweep.xLabel, "mean error (mm)") + (isLogarithmic ? "set logscale x 2\n" : "") + tics +
                ")\nset offsets graph 0.05, graph 0.05, graph 0.1, 0\nset yrange [0:*]\n" + gnuplotPlot(lines)};
}

/// Of each of the paper's families, the method with the smallest mean error.
std::vector<std::string> bestOfEach(const BenchmarkResults& results, Schedule schedule) {
    std::vector<std::string> best;
    for (const auto& [distance, bins, isLimited, isOriented] : kDistanceTraits) {
        double least = std::numeric_limits<double>::infinity();
        std::string winner;
        for (const std::string& method : results.methods) {
            if (isExternal(results, method))
                continue;
            const Method parsed = parseMethod(method);
            const ErrorStatistics statistics = errorStatistics(results, method);
            if (!parsed.best && parsed.distance == distance && parsed.schedule == schedule && statistics.pairs > 0 &&
                statistics.meanMm < least) {
                least = statistics.meanMm;
                winner = method;
            }
        }
        if (!winner.empty())
            best.push_back(winner);
    }
    return best;
}

} // namespace

std::string methodColour(const BenchmarkResults& results, const std::string& method) {
    return colourOf(results, method);
}

std::vector<std::string> headlineMethods(const BenchmarkResults& results, std::size_t most) {
    std::vector<std::string> chosen;
    const auto take = [&](const std::function<bool(const std::string&)>& wanted) {
        for (const std::string& method : results.methods)
            if (chosen.size() < most && wanted(method) &&
                std::find(chosen.begin(), chosen.end(), method) == chosen.end())
                chosen.push_back(method);
    };
    take([&](const std::string& method) { return isExternal(results, method); });
    take([](const std::string& method) { return method.find(':') == std::string::npos || method == "best:live=1"; });
    if (chosen.size() == results.external.size())
        take([](const std::string&) { return true; });
    std::vector<std::string> inOrder;
    std::copy_if(
        results.methods.begin(), results.methods.end(), std::back_inserter(inOrder),
        [&](const std::string& method) { return std::find(chosen.begin(), chosen.end(), method) != chosen.end(); });
    return inOrder;
}

std::vector<Figure> overviewFigures(const BenchmarkResults& results, const std::vector<std::string>& methods) {
    std::vector<Figure> figures = {curvesFigure(results, methods, "curves", "Error curves"),
                                   differencesFigure(results, methods), jointsFigure(results, methods)};
    const bool anyTime =
        std::any_of(results.rows.begin(), results.rows.end(), [](const PairResult& row) { return row.seconds > 0; });
    if (anyTime)
        figures.push_back(speedFigure(results, methods));
    return figures;
}

std::vector<Figure> sweepResultFigures(const BenchmarkResults& results) {
    std::vector<Figure> figures;
    for (const Schedule schedule : {Schedule::Paper, Schedule::RigidFirst}) {
        for (const SweepFigure& sweep : sweepFigures(schedule)) {
            const std::vector<PlotLine> lines = linesOf(results, sweep);
            if (hasData(lines))
                figures.push_back(sweepFigure(sweep, lines, schedule));
        }
        const std::vector<std::string> best = bestOfEach(results, schedule);
        if (best.size() > 1) {
            const std::string id = schedule == Schedule::Paper ? "best-of-each-paper" : "best-of-each";
            figures.push_back(
                curvesFigure(results, best, id, "The best setting of each method (" + scheduleName(schedule) + ")"));
        }
    }
    return figures;
}

} // namespace core
