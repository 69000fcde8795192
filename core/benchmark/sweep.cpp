// SPDX-License-Identifier: MIT
#include "core/benchmark/sweep.h"

#include <algorithm>

#include "core/fitting/method_name.h"
#include "core/fitting/method_options.h"
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

OpenOption openOption(std::string_view key, const std::string& method, const std::vector<std::string>& values) {
    const MethodOption& option = methodOption(key);
    OpenOption open{std::string(key),
                    std::string(option.meaning),
                    std::string(option.defaultText),
                    std::string(option.source),
                    method,
                    {}};
    for (const std::string& value : values)
        open.variants.push_back(method + ":" + std::string(key) + "=" + value);
    return open;
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
        openOption("schedule", "dch-thres", {"paper"}),
        openOption("epsilon", "dch-thres", {"0.75", "1", "1.5", "2"}),
        openOption("tangent", "dch-thres", {"chord"}),
        openOption("iterations", "dch-thres", {"10", "50"}),
        openOption("damping", "dch-thres", {"0.0001", "0.01", "0.1"}),
        openOption("gate", "dch-quant", {"20", "40", "120", "1e6"}),
        openOption("centre", "dch-quant", {"0.5"}),
        openOption("centre", "dch-dt3", {"0.5"}),
        openOption("weights", "dch-quant2", {"1"}),
        openOption("truncate", "ch", {"100", "400", "3600"}),
        openOption("backend", "dch-dt3", {"tensor"}),
    };
}

std::vector<BestVariant> bestVariants() {
    std::vector<BestVariant> variants;
    for (const char* const key :
         {"palm", "coarse", "wide", "across", "prior", "restarts", "apart", "polish", "both", "within", "robust"}) {
        const MethodOption& option = methodOption(key);
        const bool kept = option.defaultText == "1";
        const std::string value = kept ? "0" : option.key == "robust" ? "5" : "1";
        variants.push_back({std::string(option.meaning), kept, "best:" + std::string(key) + "=" + value});
    }
    return variants;
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
    for (const BestVariant& variant : bestVariants())
        addOnce(methods, variant.variant);
    return methods;
}

} // namespace core
