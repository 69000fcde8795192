// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>

namespace widgets {

/// The colour that stands for a camera (its epipolar guides, its frustum): hues far apart for neighbouring numbers.
inline QColor cameraColour(int index) {
    constexpr double kGoldenRatio = 0.618033988749895;
    const double turn = index * kGoldenRatio + 0.55;
    return QColor::fromHsvF(turn - static_cast<int>(turn), 0.55, 0.95);
}

} // namespace widgets
