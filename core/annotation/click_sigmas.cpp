// SPDX-License-Identifier: MIT
#include "core/annotation/click_sigmas.h"

#include <cmath>

namespace core {

const RaterSigma& ClickSigmas::of(const std::string& rater) const {
    static const RaterSigma kAssumed;
    const auto found = raters.find(rater);
    return found == raters.end() ? kAssumed : found->second;
}

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
    return options;
}

} // namespace core
