// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/fitting/method.h"

namespace core {

/// One point of a swept setting: where it is plotted, and the method that has it.
struct SweepPoint {
    double value;
    std::string method;
};

/// One line of a figure.
struct SweepSeries {
    std::string name;
    std::vector<SweepPoint> points;
};

/// One figure of the paper: the mean error over a setting.
struct SweepFigure {
    std::string id; ///< such as "tau"
    std::string title;
    std::string xLabel;
    std::vector<SweepSeries> series;
};

/// The settings of the paper's figures under a schedule: tau (signed and unsigned), lambda, bins of DT3, bins of Quant
/// and Quant2. Methods are named as methodName does.
std::vector<SweepFigure> sweepFigures(Schedule schedule);

/// An option that the paper leaves open.
struct OpenOption {
    std::string name; ///< of the option, such as "epsilon"
    std::string what; ///< what it decides
    std::string defaultValue;
    std::string source;                ///< where the default comes from
    std::string method;                ///< the method at the default
    std::vector<std::string> variants; ///< the same with other values
};
std::vector<OpenOption> openOptions();

/// One option of `best`, and the method in which it is switched the other way.
struct BestVariant {
    std::string what;
    bool kept = true;    ///< on in `best`; else it was tried and left out
    std::string variant; ///< `best` without it, or with it if it is off by default
};
std::vector<BestVariant> bestVariants();

/// Everything that `--sweep figures` runs, without repetition: plain methods and best, figures under both schedules,
/// open options under the default one, and the variants of `best` one by one.
std::vector<std::string> sweepMethods();

/// A method's name with options added, in the canonical form: withOptions("dch-thres", {"tau=45"}).
std::string withOptions(const std::string& method, const std::vector<std::string>& options);
/// The same method under that schedule.
std::string underSchedule(const std::string& method, Schedule schedule);

} // namespace core
