// SPDX-License-Identifier: MIT
#include "core/benchmark/figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "core/benchmark/metrics.h"
#include "core/fitting/method_name.h"
#include "core/text/number_text.h"
#include "core/benchmark/sweep.h"

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

std::string colourOf(const std::string& method, std::size_t number) {
    for (const MethodColour& entry : kMethodColours) {
        if (method == entry.method) {
            return entry.colour;
        }
    }
    return kOtherColours[number % kOtherColours.size()];
}

bool hasData(const std::vector<PlotLine>& lines) {
    return std::any_of(lines.begin(), lines.end(), [](const PlotLine& line) { return !line.points.empty(); });
}

Figure curvesFigure(const BenchmarkResults& results, const std::vector<std::string>& methods, const std::string& id,
                    const std::string& title) {
    std::vector<PlotLine> lines;
    for (const ErrorCurve& curve : errorCurves(results)) {
        const auto at = std::find(methods.begin(), methods.end(), curve.method);
        if (curve.method != "initial" && at == methods.end()) {
            continue;
        }
        PlotLine line{curve.method, colourOf(curve.method, lines.size()), {}, "lines"};
        for (std::size_t i = 0; i < curve.share.size(); ++i) {
            line.points.push_back({curve.thresholdsMm[i], 100 * curve.share[i]});
        }
        lines.push_back(std::move(line));
    }
    return {id, title, "Share of the frame pairs whose mean joint error is below the threshold. Higher and further left is better.",
            gnuplotPreamble(id, "threshold (mm)", "pairs below it (%)") + "set yrange [0:100]\nset xrange [0:10]\n" + gnuplotPlot(lines)};
}

Figure differencesFigure(const BenchmarkResults& results, const std::vector<std::string>& methods) {
    std::vector<PlotLine> lines;
    for (const std::string& method : methods) {
        PlotLine line{method, colourOf(method, lines.size()), {}};
        for (const int difference : differencesOf(results)) {
            const ErrorStatistics statistics = errorStatistics(results, method, difference);
            if (statistics.pairs > 0) {
                line.points.push_back({static_cast<double>(difference), statistics.meanMm});
            }
        }
        lines.push_back(std::move(line));
    }
    return {"differences", "Error over the distance of the start frame",
            "Mean joint error after the fit; the start pose is that many frames away.",
            gnuplotPreamble("differences", "frames between start and test", "mean error (mm)") + "set yrange [0:*]\n" + gnuplotPlot(lines)};
}

Figure jointsFigure(const BenchmarkResults& results, const std::vector<std::string>& methods) {
    std::string tics;
    for (std::size_t j = 0; j < results.joints.size(); ++j) {
        tics += (j == 0 ? "" : ", ") + gnuplotQuoted(jointLabel(results.joints[j])) + " " + std::to_string(j);
    }
    std::vector<PlotLine> lines;
    for (const std::string& method : methods) {
        PlotLine line{method, colourOf(method, lines.size()), {}};
        const std::vector<double> means = meanJointErrorsMm(results, method);
        for (std::size_t j = 0; j < means.size(); ++j) {
            if (!std::isnan(means[j])) {
                line.points.push_back({static_cast<double>(j), means[j]});
            }
        }
        lines.push_back(std::move(line));
    }
    return {"joints", "Error per joint", "Mean error of every joint over all pairs.",
            gnuplotPreamble("joints", "", "mean error (mm)") + "set yrange [0:*]\nset bmargin 7.5\n" +
                "set xtics noenhanced rotate by -90 font ',9' (" + tics + ")\n" + gnuplotPlot(lines)};
}

Figure speedFigure(const BenchmarkResults& results, const std::vector<std::string>& methods) {
    std::vector<PlotLine> lines;
    for (const std::string& method : methods) {
        const ErrorStatistics statistics = errorStatistics(results, method);
        if (statistics.pairs > 0 && statistics.meanSeconds > 0) {
            lines.push_back({method, colourOf(method, lines.size()), {{statistics.meanSeconds, statistics.meanMm}},
                             "points pt 7 ps 1.2"});
        }
    }
    return {"speed", "Error against time", "One point per method; further left is faster, further down is more exact.",
            gnuplotPreamble("speed", "seconds per pair", "mean error (mm)") +
                "set yrange [0:*]\nset xrange [0:*]\n" + gnuplotPlot(lines)};
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
            if (statistics.pairs > 0) {
                line.points.push_back({point.value, statistics.meanMm});
            }
        }
        if (!line.points.empty()) {
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

Figure sweepFigure(const SweepFigure& sweep, const std::vector<PlotLine>& lines, Schedule schedule) {
    const std::string id = sweep.id + (schedule == Schedule::Paper ? "-paper" : "");
    const bool isLogarithmic = sweep.xLabel == "bins" || sweep.id == "tau";
    std::string tics = "set xtics (";
    for (std::size_t i = 0; i < lines.front().points.size(); ++i) {
        tics += (i == 0 ? "" : ", ") + exactText(lines.front().points[i][0]);
    }
    return {id, sweep.title + " (" + scheduleName(schedule) + ")", "Mean joint error over all pairs.",
            gnuplotPreamble(id, sweep.xLabel, "mean error (mm)") + (isLogarithmic ? "set logscale x 2\n" : "") + tics +
                ")\nset offsets graph 0.05, graph 0.05, graph 0.1, 0\nset yrange [0:*]\n" + gnuplotPlot(lines)};
}

/// Of each of the paper's families, the method with the smallest mean error.
std::vector<std::string> bestOfEach(const BenchmarkResults& results, Schedule schedule) {
    std::vector<std::string> best;
    for (const DistanceKind distance : {DistanceKind::Ch, DistanceKind::DchThres, DistanceKind::DchQuant,
                                        DistanceKind::DchQuant2, DistanceKind::DchDt3}) {
        double least = std::numeric_limits<double>::infinity();
        std::string winner;
        for (const std::string& method : results.methods) {
            const auto& external = results.external;
            if (std::find(external.begin(), external.end(), method) != external.end()) {
                continue;
            }
            const Method parsed = parseMethod(method);
            const ErrorStatistics statistics = errorStatistics(results, method);
            if (!parsed.best && parsed.distance == distance && parsed.schedule == schedule && statistics.pairs > 0 && statistics.meanMm < least) {
                least = statistics.meanMm;
                winner = method;
            }
        }
        if (!winner.empty()) {
            best.push_back(winner);
        }
    }
    return best;
}

} // namespace

std::vector<std::string> headlineMethods(const BenchmarkResults& results, std::size_t most) {
    std::vector<std::string> chosen;
    const auto take = [&](const std::function<bool(const std::string&)>& wanted) {
        for (const std::string& method : results.methods) {
            if (chosen.size() < most && wanted(method) && std::find(chosen.begin(), chosen.end(), method) == chosen.end()) {
                chosen.push_back(method);
            }
        }
    };
    const auto& external = results.external;
    take([&](const std::string& method) { return std::find(external.begin(), external.end(), method) != external.end(); });
    take([](const std::string& method) { return method.find(':') == std::string::npos || method == "best:live=1"; });
    if (chosen.size() == external.size()) {
        take([](const std::string&) { return true; });
    }
    return chosen;
}

std::vector<Figure> overviewFigures(const BenchmarkResults& results, const std::vector<std::string>& methods) {
    std::vector<Figure> figures = {curvesFigure(results, methods, "curves", "Error curves"),
                                   differencesFigure(results, methods), jointsFigure(results, methods)};
    const bool anyTime = std::any_of(results.rows.begin(), results.rows.end(),
                                     [](const PairResult& row) { return row.seconds > 0; });
    if (anyTime) {
        figures.push_back(speedFigure(results, methods));
    }
    return figures;
}

std::vector<Figure> sweepResultFigures(const BenchmarkResults& results) {
    std::vector<Figure> figures;
    for (const Schedule schedule : {Schedule::Paper, Schedule::RigidFirst}) {
        for (const SweepFigure& sweep : sweepFigures(schedule)) {
            const std::vector<PlotLine> lines = linesOf(results, sweep);
            if (hasData(lines)) {
                figures.push_back(sweepFigure(sweep, lines, schedule));
            }
        }
        const std::vector<std::string> best = bestOfEach(results, schedule);
        if (best.size() > 1) {
            const std::string id = schedule == Schedule::Paper ? "best-of-each-paper" : "best-of-each";
            figures.push_back(curvesFigure(results, best, id, "The best setting of each method (" + scheduleName(schedule) + ")"));
        }
    }
    return figures;
}

} // namespace core
