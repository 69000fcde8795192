// SPDX-License-Identifier: MIT
#include "widgets/panels/compare/what_if_sweep.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/fitting/match_rule.h"
#include "core/fitting/method_name.h"
#include "core/fitting/method_options.h"
#include "core/text/number_text.h"

namespace widgets {

namespace {

/// tau, lambda and bins as in the paper's figures.
const std::map<std::string, std::vector<double>>& rows() {
    static const std::map<std::string, std::vector<double>> all{
        {"tau", {5, 11.25, 22.5, 45, 90, 180}},
        {"lambda", {0, 5, 15, 25, 35, 50}},
        {"bins", {4, 8, 16, 32}},
        {"centre", {0, 0.25, 0.5, 0.75}},
        {"robust", {0, 1, 2, 5, 10, 20}},
        {"gate", {5, 10, 20, 40, 60, 120}},
        {"truncate", {25, 100, 400, 1600, 3600}},
        {"epsilon", {0.5, 0.75, 1, 1.25, 1.5, 2}},
        {"iterations", {5, 10, 15, 25, 40, 60}},
        {"damping", {0.0001, 0.001, 0.01, 0.1}},
        {kNoiseKey, {0, 0.5, 1, 1.5, 2, 3}},
    };
    return all;
}

} // namespace

bool isOfPair(const std::string& key) {
    return key == kNoiseKey || key == kCamerasKey;
}

std::string usualSweep(const core::Method& method) {
    for (const core::MethodOption& option : core::methodOptions())
        if (!method.best && option.domain.isNumber() && option.appliesTo(method))
            return std::string(option.key);
    return kNoiseKey;
}

std::vector<double> sweepValues(const std::string& key, std::size_t cameraCount) {
    if (const auto found = rows().find(key); found != rows().end())
        return found->second;
    std::vector<double> values;
    if (key == kCamerasKey)
        for (std::size_t count = 2; count <= cameraCount; ++count)
            values.push_back(static_cast<double>(count));
    for (const core::MethodOption& option : core::methodOptions())
        if (option.key == key && !option.domain.isNumber())
            values = {0, 1};
    return values;
}

std::string withValue(const std::string& method, const std::string& key, double value) {
    core::Method parsed = core::parseMethod(method);
    for (const core::MethodOption& option : core::methodOptions()) {
        if (option.key != key || !option.appliesTo(parsed))
            continue;
        const std::string text =
            option.domain.isNumber() ? core::exactText(value) : std::string(option.domain.words[value > 0 ? 1 : 0]);
        return option.parse(parsed, text).empty() ? core::methodName(parsed) : std::string();
    }
    return {};
}

std::string withoutOption(const std::string& method, const std::string& key) {
    std::string name = core::methodName(core::parseMethod(method));
    const std::size_t at = name.find(":" + key + "=");
    if (!key.empty() && at != std::string::npos)
        name.erase(at, name.find(':', at + 1) - at);
    return name;
}

double optionValue(const core::Method& method, const std::string& key) {
    for (const core::MethodOption& option : core::methodOptions()) {
        if (option.key != key || !option.appliesTo(method))
            continue;
        if (key == "bins")
            return core::matchRule(method).bins.count();
        const auto gatePx = static_cast<double>(core::matchRule(method).gatePx);
        if (key == "gate")
            return std::isfinite(gatePx) ? gatePx : std::nan("");
        const std::string text = option.print(method);
        double value = 0;
        if (option.domain.isNumber())
            return core::parseNumber(text, value) ? value : std::nan("");
        return text == option.domain.words[1] ? 1 : 0;
    }
    return std::nan("");
}

bool isSameMethod(const std::string& a, const std::string& b) {
    return a == b || core::methodName(core::parseMethod(a)) == core::methodName(core::parseMethod(b));
}

std::string liveVariant(const std::string& method) {
    core::Method live = core::parseMethod(method);
    if (!live.best)
        live = core::parseMethod("best");
    live.best->live = true;
    live.best->restarts = false;
    return core::methodName(live);
}

std::vector<bool> spreadCameras(std::size_t count, std::size_t all) {
    std::vector<bool> chosen(all, false);
    for (std::size_t i = 0; i < count && i < all; ++i)
        chosen[i * all / std::min(count, all)] = true;
    return chosen;
}

} // namespace widgets
