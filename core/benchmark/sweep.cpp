// SPDX-License-Identifier: MIT
#include "core/benchmark/sweep.h"

#include <algorithm>

#include "core/fitting/method_name.h"
#include "core/text/number_text.h"

namespace core {

namespace {

SweepSeries series(const std::string& name, const std::string& method, const std::string& option,
                   const std::vector<double>& values, Schedule schedule) {
    SweepSeries result{name, {}};
    for (const double value : values) {
        const std::string point = withOptions(method, {option + "=" + exactText(value)});
        result.points.push_back({value, underSchedule(point, schedule)});
    }
    return result;
}

void addOnce(std::vector<std::string>& methods, const std::string& method) {
    if (std::find(methods.begin(), methods.end(), method) == methods.end())
        methods.push_back(method);
}

} // namespace

std::string withOptions(const std::string& method, const std::vector<std::string>& options) {
    std::string text = method;
    for (const std::string& option : options)
        text += ":" + option;
    return methodName(parseMethod(text));
}

std::string underSchedule(const std::string& method, Schedule schedule) {
    Method parsed = parseMethod(method);
    if (!parsed.best)
        parsed.schedule = schedule;
    return methodName(parsed);
}

std::vector<SweepFigure> sweepFigures(Schedule schedule) {
    const std::vector<double> taus = {11.25, 22.5, 45, 90};
    const std::vector<double> lambdas = {0, 5, 15, 25, 35, 50};
    const std::vector<double> bins = {4, 8, 16, 32};
    return {
        {"tau",
         "DCH-Thres: threshold and sign",
         "tau (deg)",
         {series("signed", "dch-thres", "tau", taus, schedule),
          series("unsigned", "dch-thres:signed=0", "tau", taus, schedule)}},
        {"lambda",
         "DCH-DT3: weight of orientation",
         "lambda (px/rad)",
         {series("signed", "dch-dt3", "lambda", lambdas, schedule),
          series("unsigned", "dch-dt3:signed=0", "lambda", {25}, schedule)}},
        {"dt3-bins", "DCH-DT3: orientation bins", "bins", {series("signed", "dch-dt3", "bins", bins, schedule)}},
        {"quant-bins",
         "DCH-Quant and DCH-Quant2: orientation bins",
         "bins",
         {series("DCH-Quant", "dch-quant", "bins", bins, schedule),
          series("DCH-Quant2", "dch-quant2", "bins", bins, schedule)}},
    };
}

std::vector<OpenOption> openOptions() {
    return {
        {"schedule",
         "a first phase moves only the six rigid degrees of freedom of each hand",
         "rigid",
         "ours; paper: no such phase",
         "dch-thres",
         {"dch-thres:schedule=paper"}},
        {"epsilon",
         "epsilon of approxPolyDP for phi(q), px",
         "1.25",
         "ours; the paper names approxPolyDP, no epsilon",
         "dch-thres",
         {"dch-thres:epsilon=0.75", "dch-thres:epsilon=1", "dch-thres:epsilon=1.5", "dch-thres:epsilon=2"}},
        {"tangent",
         "phi(q) from polygon segments or from a chord of +-7 px",
         "polygon",
         "paper: a line representation",
         "dch-thres",
         {"dch-thres:tangent=chord"}},
        {"iterations",
         "most iterations of a fit",
         "25",
         "ours; the paper gives none",
         "dch-thres",
         {"dch-thres:iterations=10", "dch-thres:iterations=50"}},
        {"damping",
         "damping relative to the diagonal of the normal matrix",
         "0.001",
         "ours; the paper gives none",
         "dch-thres",
         {"dch-thres:damping=0.0001", "dch-thres:damping=0.01", "dch-thres:damping=0.1"}},
        {"gate",
         "longest distance of a match, px",
         "60 for Quant and Quant2, none for the others",
         "ours; the paper names no gate",
         "dch-quant",
         {"dch-quant:gate=20", "dch-quant:gate=40", "dch-quant:gate=120", "dch-quant:gate=1e6"}},
        {"centre",
         "where orientation bins are centred: on the x axis, or half a bin beside it",
         "0",
         "ours; the paper says nothing",
         "dch-quant",
         {"dch-quant:centre=0.5"}},
        {"centre (DT3)", "the same for DT3", "0", "ours; the paper says nothing", "dch-dt3", {"dch-dt3:centre=0.5"}},
        {"weights",
         "weigh the two matches of Quant2 by how near their bins are",
         "0",
         "ours; paper: equal weights",
         "dch-quant2",
         {"dch-quant2:weights=1"}},
        {"truncate",
         "K of Stenger's truncated penalty, px^2",
         "none",
         "Stenger et al. 2006",
         "ch",
         {"ch:truncate=100", "ch:truncate=400", "ch:truncate=3600"}},
        {"backend",
         "DT3 by a tensor or by direct search: equal matches",
         "direct",
         "ours; paper: a tensor",
         "dch-dt3",
         {"dch-dt3:backend=tensor"}},
    };
}

std::vector<BestIdea> bestIdeas() {
    return {
        {"the palm finds its place before the fingers move", true, "best:palm=0"},
        {"coarse levels of the mesh first", true, "best:coarse=0"},
        {"tau anneals from 45 deg to 22.5", true, "best:wide=0"},
        {"the distance along the outline counts a tenth", true, "best:across=0"},
        {"a weak pull of the angles to those of the start", true, "best:prior=0"},
        {"other starts where silhouettes are left unexplained", true, "best:restarts=0"},
        {"last iterations on the full mesh", true, "best:polish=0"},
        {"contour points pull the model, too", false, "best:both=1"},
        {"only contour points within tau are searched", false, "best:within=1"},
        {"Cauchy weights, 5 mm", false, "best:robust=5"},
    };
}

std::vector<std::string> sweepMethods() {
    std::vector<std::string> methods;
    for (const Schedule schedule : {Schedule::RigidFirst, Schedule::Paper})
        for (const char* const method : {"ch", "dch-thres", "dch-quant", "dch-quant2", "dch-dt3"})
            addOnce(methods, underSchedule(method, schedule));
    addOnce(methods, "best");
    addOnce(methods, "best:live=1");
    for (const Schedule schedule : {Schedule::RigidFirst, Schedule::Paper}) {
        for (const SweepFigure& figure : sweepFigures(schedule)) {
            for (const SweepSeries& line : figure.series)
                for (const SweepPoint& point : line.points)
                    addOnce(methods, point.method);
        }
    }
    for (const OpenOption& option : openOptions())
        for (const std::string& variant : option.variants)
            addOnce(methods, withOptions(variant, {}));
    for (const BestIdea& idea : bestIdeas())
        addOnce(methods, idea.variant);
    return methods;
}

} // namespace core
