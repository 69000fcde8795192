// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <QColor>
#include <QImage>

#include <Eigen/Core>

namespace test {

/// CIE Lab (D65) of an sRGB colour.
inline Eigen::Vector3d labOf(const QColor& colour) {
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    const Eigen::Vector3d rgb(linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF()));
    Eigen::Matrix3d xyzFromRgb;
    xyzFromRgb << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041;
    const Eigen::Vector3d xyz = (xyzFromRgb * rgb).cwiseQuotient(Eigen::Vector3d(0.95047, 1, 1.08883));
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
    return {116 * f(xyz.y()) - 16, 500 * (f(xyz.x()) - f(xyz.y())), 200 * (f(xyz.y()) - f(xyz.z()))};
}

inline double labDistance(const QColor& a, const QColor& b) {
    return (labOf(a) - labOf(b)).norm();
}

/// Mean colour of the pixels that `wanted(x, y)` takes.
template <class Wanted>
QColor meanColour(const QImage& image, Wanted&& wanted) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (wanted(x, y)) {
                const QColor c = image.pixelColor(x, y);
                sum += Eigen::Vector3d(c.redF(), c.greenF(), c.blueF());
                ++count;
            }
        }
    }
    sum /= std::max(1, count);
    return QColor::fromRgbF(sum[0], sum[1], sum[2]);
}

} // namespace test
