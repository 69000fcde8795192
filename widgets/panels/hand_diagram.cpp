// SPDX-License-Identifier: MIT
#include "widgets/panels/hand_diagram.h"

#include <cmath>

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "widgets/panels/hand_drawing.h"
#include "widgets/panels/state_colours.h"
#include "widgets/text/advice.h"
#include "widgets/text/edit_text.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {
constexpr double kGrabRadius = 11;
} // namespace

HandDiagram::HandDiagram(const JointList& joints, const Reconstructions& reconstructions, Selection& selection,
                         QWidget* parent)
    : QWidget(parent)
    , m_joints(joints)
    , m_reconstructions(reconstructions)
    , m_selection(selection) {
    const auto repaint = qOverload<>(&QWidget::update);
    connect(&joints, &JointList::changed, this, repaint);
    connect(&reconstructions, &Reconstructions::changed, this, repaint);
    connect(&selection, &Selection::jointChanged, this, repaint);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    setAccessibleName(tr("Joints of both hands"));
}

void HandDiagram::setBadRmsPx(double px) {
    m_badRmsPx = px;
    update();
}

QSize HandDiagram::sizeHint() const {
    return {260, 176};
}

QSize HandDiagram::minimumSizeHint() const {
    return {200, 140};
}

QRectF HandDiagram::area(core::Side hand) const {
    const double captionHeight = fontMetrics().height() + 2;
    return handArea(hand, QRectF(0, 0, width(), height() - captionHeight));
}

std::optional<QPointF> HandDiagram::dotPosition(const core::JointId& joint) const {
    const auto unit = diagramPosition(joint.joint);
    return unit ? std::optional(placeInHand(joint.hand, area(joint.hand), *unit)) : std::nullopt;
}

void HandDiagram::paintHand(QPainter& painter, core::Side hand) const {
    const QRectF square = area(hand);
    paintHandOutline(painter, hand, square, palette());
    painter.setPen(quietTextColour(palette()));
    painter.drawText(
        QRectF(square.left(), height() - kSpacing - fontMetrics().height(), square.width(), fontMetrics().height()),
        Qt::AlignCenter, sideText(hand));
}

void HandDiagram::paintDot(QPainter& painter, const core::JointId& joint, QPointF centre) const {
    const core::JointReconstruction* found = m_reconstructions.find(joint);
    const bool selected = joint == m_selection.joint();
    const auto shape = [&](double radius) {
        const QRectF box(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius);
        if (joint.hand == core::Side::Left)
            painter.drawEllipse(box);
        else
            painter.drawRect(box);
    };
    if (selected) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush);
        shape(8);
    }
    const bool bad = found && core::isBad(*found, m_badRmsPx);
    const QColor colour = fingerColour(joint.joint);
    QPen ring(bad ? kBadColour : mixed(colour, Qt::black, 0.25), bad ? 2.0 : 1.2);
    if (found && found->status == core::JointStatus::None) { // not placed, but proposed
        ring.setColor(colour);
        ring.setDashPattern({1.9, 1.35});
    }
    painter.setPen(ring);
    QColor fill = palette().color(QPalette::Window);
    if (found && found->status == core::JointStatus::Done)
        fill = colour;
    else if (found && found->status == core::JointStatus::Partial)
        fill = mixed(palette().color(QPalette::Window), colour, 0.5);
    painter.setBrush(fill);
    shape(joint.hand == core::Side::Left ? 4.5 : 4.0);
}

void HandDiagram::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const core::Side hand : {core::Side::Left, core::Side::Right})
        paintHand(painter, hand);
    for (const core::JointId& joint : m_joints.joints())
        if (const auto centre = dotPosition(joint))
            paintDot(painter, joint, *centre);
}

std::optional<core::JointId> HandDiagram::jointAt(QPointF position) const {
    std::optional<core::JointId> nearest;
    double best = kGrabRadius;
    for (const core::JointId& joint : m_joints.joints()) {
        const auto centre = dotPosition(joint);
        if (!centre)
            continue;
        const double distance = std::hypot(centre->x() - position.x(), centre->y() - position.y());
        if (distance < best) {
            best = distance;
            nearest = joint;
        }
    }
    return nearest;
}

void HandDiagram::mousePressEvent(QMouseEvent* event) {
    if (const auto joint = jointAt(event->localPos()))
        m_selection.setJoint(*joint);
}

bool HandDiagram::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto joint = jointAt(help->pos());
        const core::JointReconstruction* found = joint ? m_reconstructions.find(*joint) : nullptr;
        const QString marks = found ? QLatin1Char('\n') + placedInWords(*found) : QString();
        QToolTip::showText(help->globalPos(), joint ? jointText(*joint) + marks : QString(), this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace widgets
