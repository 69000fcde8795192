// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace core {

/// Equal parts of the circle of directions (signed, period 2 pi) or of undirected lines (unsigned, period pi).
/// Bin b is centred at (b + centreOffset) * width and owns [centre - width / 2, centre + width / 2): the one convention
/// for contour and model. With centreOffset = 0, bin 0 is centred at the x axis; with 0.5 it begins there.
class OrientationBins {
public:
    /// Throws Error(Usage) unless count is in [1, 256] and centreOffset in [0, 1).
    OrientationBins(int count, bool isSigned, double centreOffset = 0);

    int count() const { return m_count; }
    bool isSigned() const { return m_isSigned; }
    /// 2 pi / count if signed, else pi / count.
    double widthRad() const { return m_widthRad; }
    double centreRad(int bin) const { return (bin + m_centreOffset) * m_widthRad; }

    /// The bin of a direction, in [0, count); any angle.
    int binOf(double angleRad) const;
    /// The two bins whose centres are nearest, the nearest first (Quant2); twice the same bin if there is only one.
    std::array<int, 2> nearestTwo(double angleRad) const;
    /// Circular distance between the centres of two bins, rad.
    double distanceRad(int binA, int binB) const;

private:
    int m_count;
    bool m_isSigned;
    double m_centreOffset;
    double m_widthRad;
};

} // namespace core
