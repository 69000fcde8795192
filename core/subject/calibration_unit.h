// SPDX-License-Identifier: MIT
#pragma once

namespace core {

/// Millimetres of a calibration's unit as hands tell it: 1, 10 or 1000, else what makes the hand as large as the
/// model. `ratio` is measured over model length (annotatedOverModelLength); 1 if it is not known (0).
double unitMmOf(double ratio);

/// Whether it is a unit that people use; else it follows from the model's size, and scale says nothing.
bool isUsualUnit(double mm);

} // namespace core
