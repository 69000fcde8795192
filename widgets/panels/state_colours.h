// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QPalette>

namespace widgets {

/// Colours of states, readable on both palettes and told apart by lightness too.
inline const QColor kDoneColour(0x3D, 0xA3, 0x7A);
inline const QColor kPartialColour(0xC9, 0x9A, 0x2E);
inline const QColor kBadColour(0xE5, 0x5B, 0x5B);
inline const QColor kOccludedColour(0x7A, 0x8C, 0xB8);
inline const QColor kProposedColour(0x8F, 0xB4, 0xE6);
inline const QColor kDoubtfulColour(0xF0, 0x7F, 0xC8);

/// One unit of space between things, logical pixels.
inline constexpr int kSpacing = 6;

/// A colour between two.
inline QColor mixed(const QColor& a, const QColor& b, double shareOfB) {
    return QColor::fromRgbF(a.redF() + (b.redF() - a.redF()) * shareOfB,
                            a.greenF() + (b.greenF() - a.greenF()) * shareOfB,
                            a.blueF() + (b.blueF() - a.blueF()) * shareOfB);
}

/// Text that matters less, readable still.
inline QColor quietTextColour(const QPalette& palette) {
    return mixed(palette.color(QPalette::WindowText), palette.color(QPalette::Window), 0.35);
}

} // namespace widgets
