// SPDX-License-Identifier: MIT
#include "core/distance/orientation_bins.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "core/error.h"

namespace core {

namespace {

int modulo(int value, int count) {
    const int remainder = value % count;
    return remainder < 0 ? remainder + count : remainder;
}

} // namespace

OrientationBins::OrientationBins(int count, bool isSigned, double centreOffset)
    : m_count(count)
    , m_isSigned(isSigned)
    , m_centreOffset(centreOffset)
    , m_widthRad((isSigned ? 2.0 : 1.0) * std::numbers::pi / std::max(count, 1)) {
    if (count < 1 || count > 256)
        throw Error(ErrorCode::Usage, "", "bins", "must be between 1 and 256, not " + std::to_string(count));
    if (!(centreOffset >= 0 && centreOffset < 1))
        throw Error(ErrorCode::Usage, "", "bin centre offset", "must be at least 0 and below 1");
}

int OrientationBins::binOf(double angleRad) const {
    return modulo(static_cast<int>(std::floor(angleRad / m_widthRad - m_centreOffset + 0.5)), m_count);
}

std::array<int, 2> OrientationBins::nearestTwo(double angleRad) const {
    const double position = angleRad / m_widthRad - m_centreOffset;
    const double nearest = std::floor(position + 0.5);
    const int bin = modulo(static_cast<int>(nearest), m_count);
    return {bin, modulo(bin + (position < nearest ? -1 : 1), m_count)};
}

double OrientationBins::distanceRad(int binA, int binB) const {
    const int steps = std::abs(binA - binB);
    return std::min(steps, m_count - steps) * m_widthRad;
}

} // namespace core
