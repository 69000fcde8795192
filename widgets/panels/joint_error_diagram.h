// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
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

    /// `largestMm`: the end of the colour scale; 0: the largest error.
    void setErrors(const std::vector<JointError>& errors, double largestMm = 0);
    /// Whether joints can be clicked; one of them may be selected: a ring around it, and its name and error below.
    void setClickable(bool clickable);
    void setSelected(const std::optional<core::JointId>& joint);
    /// The middle of a joint's dot, in the widget; empty if the drawing does not have it.
    std::optional<QPointF> placeOf(const core::JointId& joint) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void jointClicked(const core::JointId& joint);

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    QRectF handsArea() const;
    void paintLegend(QPainter& painter) const;
    const JointError* errorAt(QPointF place) const;

    std::vector<JointError> m_errors;
    double m_largestMm = 0;
    bool m_isClickable = false;
    std::optional<core::JointId> m_selected;
};

} // namespace widgets
