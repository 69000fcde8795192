// SPDX-License-Identifier: MIT
#include "widgets/panels/hand_diagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPathStroker>
#include <QToolTip>

#include "widgets/document/edit_text.h"
#include "widgets/panels/state_colours.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

/// Base and tip of each finger of the left hand seen from its back, unit square, y down.
struct Finger {
    std::string_view name;
    QPointF mcp, tip;
};
const std::array kFingers = {
    Finger{"little", {0.22, 0.56}, {0.08, 0.27}},
    Finger{"ring", {0.37, 0.50}, {0.29, 0.12}},
    Finger{"middle", {0.52, 0.48}, {0.53, 0.06}},
    Finger{"index", {0.67, 0.51}, {0.76, 0.14}},
};
const QPointF kWrist(0.48, 0.92);
constexpr double kFingerWidth = 0.13;
constexpr double kGrabRadius = 11;

QPointF between(QPointF a, QPointF b, double share) {
    return a + (b - a) * share;
}

std::optional<QPointF> thumbPosition(std::string_view part) {
    if (part == "cmc")
        return QPointF(0.66, 0.80);
    if (part == "mcp")
        return QPointF(0.82, 0.67);
    if (part == "ip")
        return QPointF(0.92, 0.55);
    return part == "tip" ? std::optional(QPointF(0.97, 0.44)) : std::nullopt;
}

/// Outline of the left hand in the unit square.
QPainterPath handOutline() {
    QPainterPath bones;
    for (const Finger& finger : kFingers) {
        bones.moveTo(finger.mcp);
        bones.lineTo(finger.tip);
    }
    bones.moveTo(*thumbPosition("cmc"));
    bones.lineTo(*thumbPosition("mcp"));
    bones.lineTo(*thumbPosition("tip"));
    QPainterPathStroker stroker;
    stroker.setWidth(kFingerWidth);
    stroker.setCapStyle(Qt::RoundCap);
    stroker.setJoinStyle(Qt::RoundJoin);
    stroker.setCurveThreshold(0.002);
    QPainterPath palm;
    palm.moveTo(0.17, 0.57);
    palm.cubicTo({0.18, 0.75}, {0.25, 0.86}, {0.31, 1.0});
    palm.lineTo(0.65, 1.0);
    palm.cubicTo({0.70, 0.92}, {0.75, 0.88}, {0.80, 0.74});
    palm.lineTo(0.73, 0.51);
    palm.closeSubpath();
    return stroker.createStroke(bones).united(palm).simplified();
}

} // namespace

std::optional<QPointF> diagramPosition(const std::string& joint) {
    if (joint == "wrist")
        return kWrist;
    if (joint == "forearm")
        return QPointF(0.48, 0.985);
    const auto underscore = joint.find('_');
    if (underscore == std::string::npos)
        return std::nullopt;
    const std::string_view name = std::string_view(joint).substr(0, underscore);
    const std::string_view part = std::string_view(joint).substr(underscore + 1);
    if (name == "thumb")
        return thumbPosition(part);
    const auto finger = std::find_if(kFingers.begin(), kFingers.end(), [&](const Finger& f) { return f.name == name; });
    if (finger == kFingers.end())
        return std::nullopt;
    if (part == "cmc")
        return between(kWrist, finger->mcp, 0.38);
    constexpr std::array<std::pair<std::string_view, double>, 4> kParts = {{{"mcp", 0.0}, {"pip", 0.42}, {"dip", 0.72}, {"tip", 1.0}}};
    for (const auto& [known, share] : kParts) {
        if (part == known)
            return between(finger->mcp, finger->tip, share);
    }
    return std::nullopt;
}

HandDiagram::HandDiagram(const JointList& joints, const Reconstructions& reconstructions, Selection& selection, QWidget* parent)
    : QWidget(parent), m_joints(joints), m_reconstructions(reconstructions), m_selection(selection) {
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

QRectF HandDiagram::handArea(core::Side hand) const {
    const double captionHeight = fontMetrics().height() + 2;
    const QSizeF cell((width() - 3 * kSpacing) / 2.0, height() - 2 * kSpacing - captionHeight);
    const double side = std::min(cell.width(), cell.height());
    const double centreX = kSpacing + cell.width() / 2 + (hand == core::Side::Left ? 0 : cell.width() + kSpacing);
    return {centreX - side / 2, kSpacing + (cell.height() - side) / 2, side, side};
}

QPointF HandDiagram::place(core::Side hand, QPointF unit) const {
    const QRectF area = handArea(hand);
    const double x = hand == core::Side::Left ? unit.x() : 1 - unit.x();
    return {area.left() + x * area.width(), area.top() + unit.y() * area.height()};
}

std::optional<QPointF> HandDiagram::dotPosition(const core::JointId& joint) const {
    const auto unit = diagramPosition(joint.joint);
    return unit ? std::optional(place(joint.hand, *unit)) : std::nullopt;
}

void HandDiagram::paintHand(QPainter& painter, core::Side hand) const {
    static const QPainterPath kOutline = handOutline();
    const QRectF area = handArea(hand);
    const bool left = hand == core::Side::Left;
    QTransform toWidget;
    toWidget.translate(left ? area.left() : area.right(), area.top());
    toWidget.scale(left ? area.width() : -area.width(), area.height());
    const QColor background = palette().color(QPalette::Window);
    const QColor text = palette().color(QPalette::WindowText);
    painter.setPen(QPen(mixed(background, text, 0.30), 1));
    painter.setBrush(mixed(background, text, 0.10));
    painter.drawPath(toWidget.map(kOutline));
    painter.setPen(quietTextColour(palette()));
    painter.drawText(QRectF(area.left(), height() - kSpacing - fontMetrics().height(), area.width(), fontMetrics().height()),
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
    const bool bad = found && (found->hasPoint() ? found->result.point->rmsPx > m_badRmsPx : found->manualViews >= 2);
    const QColor colour = fingerColour(joint.joint);
    painter.setPen(QPen(bad ? kBadColour : mixed(colour, Qt::black, 0.25), bad ? 2.0 : 1.2));
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
    for (const core::JointId& joint : m_joints.joints()) {
        if (const auto centre = dotPosition(joint))
            paintDot(painter, joint, *centre);
    }
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
        QToolTip::showText(help->globalPos(), joint ? jointText(*joint) : QString(), this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace widgets
