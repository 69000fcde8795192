// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QWidget>

#include "core/annotation/annotation_set.h"

namespace widgets {

/// A mean error per joint, mm.
struct JointError {
    core::JointId joint;
    double errorMm = 0; ///< NaN: unknown, drawn hollow
};

/// A drawing of both hands, every joint in the colour of its error, with a legend in mm.
class JointErrorDiagram : public QWidget {
    Q_OBJECT

public:
    explicit JointErrorDiagram(QWidget* parent = nullptr);

    void setErrors(const std::vector<JointError>& errors);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    QRectF handsArea() const;
    void paintLegend(QPainter& painter) const;
    QPointF placeOf(const core::JointId& joint, bool* known) const;

    std::vector<JointError> m_errors;
    double m_largestMm = 0;
};

} // namespace widgets
