// SPDX-License-Identifier: MIT
#include "core/annotation/click_sigmas.h"

#include <algorithm>
#include <cmath>

namespace core {

const RaterSigma& ClickSigmas::of(const std::string& rater) const {
    static const RaterSigma kAssumed;
    const auto found = raters.find(rater);
    return found == raters.end() ? kAssumed : found->second;
}

namespace {

/// However steady a hand is, a click is not called wrong for less: among thousands, some lie beyond any small gate.
constexpr double kLeastGatePx = 3;

} // namespace

TriangulationOptions ClickSigmas::optionsFor(const std::string& rater, TriangulationOptions options) const {
    const RaterSigma& sigma = of(rater);
    options.isSigmaAssumed = sigma.isAssumed;
    if (sigma.isAssumed)
        return options;
    options.sigmaPx = sigma.clickPx;
    options.sigmaPxByCamera = sigma.clickPxByCamera;
    double squares = 0;
    for (std::size_t c = 0; c < options.sigmaPxByCamera.size() && c < systematicPx.size(); ++c)
        options.sigmaPxByCamera[c] = std::hypot(options.sigmaPxByCamera[c], systematicPx[c]);
    for (const double px : systematicPx)
        squares += px * px;
    if (!systematicPx.empty())
        options.systematicPx = std::sqrt(squares / static_cast<double>(systematicPx.size()));
    options.outlierFactor = std::max(options.outlierFactor, kLeastGatePx / sigma.clickPx);
    return options;
}

namespace {

bool areAlike(const TriangulationOptions& a, const TriangulationOptions& b) {
    if (a.isSigmaAssumed != b.isSigmaAssumed || a.sigmaPxByCamera.size() != b.sigmaPxByCamera.size())
        return false;
    constexpr double kHardlyNoticed = 0.02;
    for (std::size_t c = 0; c < a.sigmaPxByCamera.size(); ++c)
        if (std::abs(std::log(a.sigmaPxByCamera[c] / b.sigmaPxByCamera[c])) > kHardlyNoticed)
            return false;
    return true;
}

} // namespace

bool areAlike(const ClickSigmas& a, const ClickSigmas& b) {
    for (const ClickSigmas* sigmas : {&a, &b})
        for (const auto& [rater, sigma] : sigmas->raters)
            if (!areAlike(a.optionsFor(rater), b.optionsFor(rater)))
                return false;
    return true;
}

} // namespace core
