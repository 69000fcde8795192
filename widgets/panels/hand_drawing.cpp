// SPDX-License-Identifier: MIT
#include "widgets/panels/hand_drawing.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <QPainter>
#include <QPainterPath>
#include <QPainterPathStroker>

#include "widgets/panels/state_colours.h"

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
    constexpr std::array<std::pair<std::string_view, double>, 4> kParts = {
        {{"mcp", 0.0}, {"pip", 0.42}, {"dip", 0.72}, {"tip", 1.0}}};
    for (const auto& [known, share] : kParts)
        if (part == known)
            return between(finger->mcp, finger->tip, share);
    return std::nullopt;
}

QPointF placeInHand(core::Side hand, const QRectF& area, QPointF unit) {
    const double x = hand == core::Side::Left ? unit.x() : 1 - unit.x();
    return {area.left() + x * area.width(), area.top() + unit.y() * area.height()};
}

QRectF handArea(core::Side hand, const QRectF& whole) {
    const QSizeF cell((whole.width() - 3 * kSpacing) / 2, whole.height() - 2 * kSpacing);
    const double side = std::min(cell.width(), cell.height());
    const double centreX =
        whole.left() + kSpacing + cell.width() / 2 + (hand == core::Side::Left ? 0 : cell.width() + kSpacing);
    return {centreX - side / 2, whole.top() + kSpacing + (cell.height() - side) / 2, side, side};
}

void paintHandOutline(QPainter& painter, core::Side hand, const QRectF& area, const QPalette& palette) {
    static const QPainterPath kOutline = handOutline();
    const bool left = hand == core::Side::Left;
    QTransform toArea;
    toArea.translate(left ? area.left() : area.right(), area.top());
    toArea.scale(left ? area.width() : -area.width(), area.height());
    const QColor background = palette.color(QPalette::Window);
    const QColor text = palette.color(QPalette::WindowText);
    painter.setPen(QPen(mixed(background, text, 0.30), 1));
    painter.setBrush(mixed(background, text, 0.10));
    painter.drawPath(toArea.map(kOutline));
}

} // namespace widgets
