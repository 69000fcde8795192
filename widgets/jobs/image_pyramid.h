// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QImage>
#include <QPainter>
#include <QRectF>

namespace widgets {

/// Brightness, contrast and gamma of one view: v' = ((v - 0.5) * contrast + 0.5 + brightness) ^ (1 / gamma), v in [0,
/// 1].
struct ImageAdjustment {
    double brightness = 0; ///< -1 .. 1
    double contrast = 1;   ///< 0 .. 4
    double gamma = 1;      ///< 0.1 .. 5; above 1 lifts the shadows
    bool operator==(const ImageAdjustment&) const = default;
};

/// An image and its halvings, so that it can be drawn small without aliasing and without work. Cheap to copy; may be
/// built on any thread (prepare it there: 2 ms for 1080x1920).
class ImagePyramid {
public:
    ImagePyramid() = default;
    explicit ImagePyramid(const QImage& image);

    bool isNull() const { return m_levels.empty(); }
    QSize size() const { return isNull() ? QSize() : m_levels.front().size(); }
    const QImage& image() const { return m_levels.front(); }
    int levelCount() const { return static_cast<int>(m_levels.size()); }
    /// The level to draw at `scale` device pixels per image pixel: the smallest that is not magnified.
    int levelFor(double scale) const;
    const QImage& level(int index) const { return m_levels[static_cast<std::size_t>(index)]; }

private:
    std::vector<QImage> m_levels; ///< Format_RGB32; each half the size of the one before, rounded up
};

/// The image with every channel mapped through the adjustment.
QImage adjusted(const QImage& image, const ImageAdjustment& adjustment);

} // namespace widgets
