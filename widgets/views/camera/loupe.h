// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include "widgets/jobs/image_pyramid.h"

namespace widgets {

/// A magnified piece of the image beside the pointer, with a cross-hair on the exact sub-pixel place.
class Loupe : public QWidget {
    Q_OBJECT
public:
    explicit Loupe(QWidget* parent);

    /// Shows what lies around `px` (image pixels, centres at integers), beside `pointer` (in the parent's coordinates).
    /// `adjustment` is the view's; `viewScale` its screen pixels per image pixel, which the loupe exceeds.
    void show(const ImagePyramid& image, const ImageAdjustment& adjustment, QPointF px, QPointF pointer,
              double viewScale);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ImagePyramid m_image;
    ImageAdjustment m_adjustment;
    QPointF m_px;
    double m_scale = 8;
};

} // namespace widgets
