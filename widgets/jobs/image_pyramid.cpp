// SPDX-License-Identifier: MIT
#include "widgets/jobs/image_pyramid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace widgets {

namespace {

constexpr int kSmallestSide = 32;

/// Mean of four pixels, all channels at once.
QRgb mean(QRgb a, QRgb b, QRgb c, QRgb d) {
    const auto half = [](QRgb p) { return p & 0x00FF00FFu; };
    const auto other = [](QRgb p) { return (p >> 8) & 0x00FF00FFu; };
    const QRgb redBlue = ((half(a) + half(b) + half(c) + half(d) + 0x00020002u) >> 2) & 0x00FF00FFu;
    const QRgb alphaGreen = ((other(a) + other(b) + other(c) + other(d) + 0x00020002u) >> 2) & 0x00FF00FFu;
    return redBlue | (alphaGreen << 8);
}

QImage halved(const QImage& image) {
    QImage half((image.width() + 1) / 2, (image.height() + 1) / 2, QImage::Format_RGB32);
    for (int y = 0; y < half.height(); ++y) {
        const auto* top = reinterpret_cast<const QRgb*>(image.constScanLine(2 * y));
        const auto* bottom =
            reinterpret_cast<const QRgb*>(image.constScanLine(std::min(2 * y + 1, image.height() - 1)));
        auto* out = reinterpret_cast<QRgb*>(half.scanLine(y));
        const int pairs = image.width() / 2;
        for (int x = 0; x < pairs; ++x)
            out[x] = mean(top[2 * x], top[2 * x + 1], bottom[2 * x], bottom[2 * x + 1]);
        if (pairs < half.width())
            out[pairs] = mean(top[2 * pairs], top[2 * pairs], bottom[2 * pairs], bottom[2 * pairs]);
    }
    return half;
}

} // namespace

ImagePyramid::ImagePyramid(const QImage& image)
    : ImagePyramid(image, image.size()) {}

ImagePyramid::ImagePyramid(const QImage& image, QSize size)
    : m_size(image.isNull() ? QSize() : size) {
    if (image.isNull())
        return;
    while ((size.width() + (1 << m_firstLevel) - 1) >> m_firstLevel > image.width())
        ++m_firstLevel;
    m_levels.push_back(image.convertToFormat(QImage::Format_RGB32));
    while (std::min(m_levels.back().width(), m_levels.back().height()) > kSmallestSide)
        m_levels.push_back(halved(m_levels.back()));
}

int ImagePyramid::levelFor(double scale) const {
    if (!(scale > 0))
        return m_firstLevel;
    constexpr double kRounding = 1e-9; // a scale of 0.25 is level 2 exactly
    const int level = static_cast<int>(std::floor(std::log2(1 / scale) + kRounding));
    return std::clamp(level, m_firstLevel, std::max(m_firstLevel, levelCount() - 1));
}

QImage adjusted(const QImage& image, const ImageAdjustment& adjustment) {
    if (image.isNull() || adjustment == ImageAdjustment{})
        return image;
    std::array<QRgb, 256> map{};
    for (int i = 0; i < 256; ++i) {
        const double v = (i / 255.0 - 0.5) * adjustment.contrast + 0.5 + adjustment.brightness;
        const double lifted = std::pow(std::clamp(v, 0.0, 1.0), 1 / std::max(0.05, adjustment.gamma));
        map[static_cast<std::size_t>(i)] = static_cast<QRgb>(std::lround(lifted * 255));
    }
    QImage result = image.convertToFormat(QImage::Format_RGB32);
    for (int y = 0; y < result.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(result.scanLine(y));
        for (int x = 0; x < result.width(); ++x) {
            const QRgb p = row[x];
            row[x] = 0xFF000000u | (map[(p >> 16) & 255u] << 16) | (map[(p >> 8) & 255u] << 8) | map[p & 255u];
        }
    }
    return result;
}

} // namespace widgets
