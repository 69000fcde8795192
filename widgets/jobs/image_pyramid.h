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
    /// A draft: `image` is the one of this size shrunk by 2, 4, 8 (sides rounded up). The larger levels are not there.
    ImagePyramid(const QImage& image, QSize size);

    bool isNull() const { return m_levels.empty(); }
    QSize size() const { return m_size; }
    /// The largest that is there: the image itself, or that of a draft.
    const QImage& image() const { return m_levels.front(); }
    int levelCount() const { return m_firstLevel + static_cast<int>(m_levels.size()); }
    /// The largest level that is there; 0 unless it is a draft.
    int firstLevel() const { return m_firstLevel; }
    bool isDraft() const { return m_firstLevel > 0; }
    /// The level to draw at `scale` device pixels per image pixel: the smallest that is not magnified, if it is there.
    int levelFor(double scale) const;
    /// From firstLevel() to levelCount() - 1.
    const QImage& level(int index) const { return m_levels[static_cast<std::size_t>(index - m_firstLevel)]; }

private:
    std::vector<QImage> m_levels; ///< Format_RGB32; each half the size of the one before, rounded up
    QSize m_size;                 ///< of level 0
    int m_firstLevel = 0;         ///< of m_levels
};

/// The image with every channel mapped through the adjustment.
QImage adjusted(const QImage& image, const ImageAdjustment& adjustment);

} // namespace widgets
