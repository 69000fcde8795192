// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace core {

/// How often values lie in ranges of one width: bin i holds [from + i width, from + (i + 1) width), and the two at the
/// ends also what lies beyond them.
struct Histogram {
    double from = 0;
    double width = 1;
    std::vector<int> counts; ///< none without values
};

/// At most about `most` bins of a round width (1, 2 or 5 times a power of ten) with an edge at 0, over the 98 % of the
/// values in the middle. NaN values are left out.
Histogram roundHistogram(const std::vector<double>& values, std::size_t most = 40);

/// Quantiles of some values, interpolated linearly between them.
struct BoxStatistics {
    std::size_t count = 0; ///< all else is 0 if there are none
    double low = 0;        ///< 5 % lie below
    double lowerQuartile = 0;
    double median = 0;
    double upperQuartile = 0;
    double high = 0; ///< 5 % lie above
};

/// NaN values are left out.
BoxStatistics boxStatistics(std::vector<double> values);

} // namespace core
