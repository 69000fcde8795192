// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace widgets {

/// Maps values of one axis to 0..1, linearly or by their logarithm.
struct PlotAxis {
    double min = 0;
    double max = 1;
    bool logarithmic = false;
    bool whole = false; ///< values are whole numbers, such as frames or iterations: no tick lies between them

    /// 0 at min, 1 at max; values that a logarithm does not have lie at min.
    double position(double value) const;
    double value(double position) const;
};

/// The axis that holds [min, max], widened to round values; an empty or inverted range becomes [0, 1]. A linear axis of
/// values that are not negative starts at 0 if they come near it.
PlotAxis roundAxis(double min, double max, bool logarithmic);

/// Round values on the axis, at most `most` (at least 2), or one more where it would be a single one; powers of ten,
/// with 2 and 5 between if there is room, on a logarithmic one.
std::vector<double> ticks(const PlotAxis& axis, int most);

} // namespace widgets
