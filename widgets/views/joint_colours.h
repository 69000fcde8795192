// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include <QColor>

namespace widgets {

/// Colour of a joint by its finger (colour-blind safe); grey for wrist, forearm and names outside the fingers.
QColor fingerColour(std::string_view joint);
/// Colour of a method's result; `start`, `truth` and `recorded` are names too. The options behind the first ':' do not
/// matter.
QColor methodColour(std::string_view method);
/// cividis at `t` in [0, 1] (clamped): the scale for errors.
QColor errorColour(double t);
/// A cyclic palette for orientations: `angleRad` of any value.
QColor orientationColour(double angleRad);

} // namespace widgets
