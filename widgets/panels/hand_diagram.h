// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <QPointF>
#include <QWidget>

#include "widgets/document/joint_list.h"
#include "widgets/document/reconstructions.h"
#include "widgets/document/selection.h"

namespace widgets {

/// A drawing of both hands, a dot per joint: filled by state, ringed red when its error is high, outlined when
/// selected. A click selects. Left hand round, right hand square.
class HandDiagram : public QWidget {
    Q_OBJECT

public:
    HandDiagram(const JointList& joints, const Reconstructions& reconstructions, Selection& selection,
                QWidget* parent = nullptr);

    void setBadRmsPx(double px);
    /// Where the joint's dot is, in the widget; empty if it has none.
    std::optional<QPointF> dotPosition(const core::JointId& joint) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    QRectF area(core::Side hand) const;
    void paintHand(QPainter& painter, core::Side hand) const;
    void paintDot(QPainter& painter, const core::JointId& joint, QPointF centre) const;
    std::optional<core::JointId> jointAt(QPointF position) const;

    const JointList& m_joints;
    const Reconstructions& m_reconstructions;
    Selection& m_selection;
    double m_badRmsPx = 2.0;
};

} // namespace widgets
