// SPDX-License-Identifier: MIT
#include "widgets/views/camera/line_items.h"

#include <cmath>

#include <QPainter>

#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

const QColor kGapRed(0xFF, 0x3B, 0x30);
const QPointF kHalf(0.5, 0.5);   // from image pixels to the scene
constexpr double kMarginPx = 60; // in image px: covers pens and dots at every zoom that shows the whole image

QPen cosmetic(const QColor& colour, double width) {
    QPen pen(colour, width);
    pen.setCosmetic(true);
    pen.setCapStyle(Qt::RoundCap);
    return pen;
}

QColor withAlpha(QColor colour, double alpha) {
    colour.setAlphaF(colour.alphaF() * alpha);
    return colour;
}

void include(QRectF& bounds, QPointF px) {
    bounds = bounds.isNull() ? QRectF(px, QSizeF(1e-6, 1e-6)) : bounds.united(QRectF(px, QSizeF(1e-6, 1e-6)));
}

} // namespace

void LineItem::setBounds(const QRectF& boundsPx) {
    prepareGeometryChange();
    m_bounds = boundsPx.isNull() ? QRectF()
                                 : boundsPx.translated(kHalf).adjusted(-kMarginPx, -kMarginPx, kMarginPx, kMarginPx);
    update();
}

void SkeletonItem::setLines(const std::vector<SkeletonLine>& lines) {
    m_lines = lines;
    QRectF bounds;
    for (const SkeletonLine& line : lines) {
        include(bounds, line.fromPx);
        include(bounds, line.toPx);
    }
    setBounds(bounds);
}

void SkeletonItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    for (const SkeletonLine& line : m_lines) {
        painter->setPen(cosmetic(withAlpha(line.colour, 0.85), 1.5));
        painter->drawLine(line.fromPx + kHalf, line.toPx + kHalf);
    }
}

void GuidesItem::setGuides(const std::vector<EpipolarGuide>& guides) {
    m_guides = guides;
    QRectF bounds;
    for (const EpipolarGuide& guide : guides)
        for (const QPointF& px : guide.pointsPx)
            include(bounds, px);
    setBounds(bounds);
}

void GuidesItem::setFocus(const std::optional<QPointF>& px) {
    m_focusPx = px;
    update();
}

void GuidesItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    const double scale = std::hypot(painter->worldTransform().m11(), painter->worldTransform().m12());
    constexpr double kNear = 0.95, kFar = 0.22, kReachScreenPx = 160;
    for (const EpipolarGuide& guide : m_guides) {
        for (std::size_t i = 0; i + 1 < guide.pointsPx.size(); ++i) {
            const QPointF a = guide.pointsPx[i], b = guide.pointsPx[i + 1];
            double alpha = 0.7;
            if (m_focusPx) {
                const QPointF away = (a + b) / 2 - *m_focusPx;
                const double distance = std::hypot(away.x(), away.y()) * scale;
                alpha = kFar + (kNear - kFar) * std::exp(-distance / kReachScreenPx);
            }
            painter->setPen(cosmetic(withAlpha(guide.colour, alpha), 1));
            painter->drawLine(a + kHalf, b + kHalf);
        }
    }
}

void ArrowsItem::setArrows(const std::vector<ResidualArrow>& arrows) {
    m_arrows = arrows;
    QRectF bounds;
    for (const ResidualArrow& arrow : arrows) {
        include(bounds, arrow.fromPx);
        include(bounds, arrow.toPx);
    }
    setBounds(bounds);
}

void ArrowsItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    const double scale = std::hypot(painter->worldTransform().m11(), painter->worldTransform().m12());
    constexpr double kHeadScreenPx = 6, kHeadAngleRad = 0.45;
    for (const ResidualArrow& arrow : m_arrows) {
        const QPointF from = arrow.fromPx + kHalf, to = arrow.toPx + kHalf, along = to - from;
        const double length = std::hypot(along.x(), along.y());
        const double head = std::min(kHeadScreenPx / scale, length / 2), angle = std::atan2(along.y(), along.x());
        const auto barb = [&](double turn) {
            return to - head * QPointF(std::cos(angle + turn), std::sin(angle + turn));
        };
        for (const auto& [colour, width] : {std::pair(QColor(0, 0, 0, 160), 3.5), std::pair(arrow.colour, 1.5)}) {
            painter->setPen(cosmetic(colour, width));
            painter->drawLine(from, to);
            painter->drawLine(to, barb(kHeadAngleRad));
            painter->drawLine(to, barb(-kHeadAngleRad));
            painter->setPen(cosmetic(colour, width + 2));
            painter->drawPoint(from);
        }
    }
}

void EllipseItem::setEllipse(const std::optional<UncertaintyEllipse>& ellipse) {
    m_ellipse = ellipse;
    QRectF bounds;
    if (ellipse) {
        const double reach = std::max(ellipse->semiAxisAPx, ellipse->semiAxisBPx);
        bounds = QRectF(ellipse->centrePx - QPointF(reach, reach), QSizeF(2 * reach + 1e-6, 2 * reach + 1e-6));
    }
    setBounds(bounds);
}

void EllipseItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (!m_ellipse)
        return;
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(m_ellipse->centrePx + kHalf);
    painter->rotate(m_ellipse->angleRad * 180 / M_PI);
    painter->setBrush(withAlpha(m_ellipse->colour, 0.14));
    for (const auto& [colour, width] : {std::pair(QColor(0, 0, 0, 120), 2.4), std::pair(m_ellipse->colour, 1.2)}) {
        painter->setPen(cosmetic(colour, width));
        painter->drawEllipse(QPointF(0, 0), m_ellipse->semiAxisAPx, m_ellipse->semiAxisBPx);
        painter->setBrush(Qt::NoBrush);
    }
}

void ReprojectionItem::setMarks(const std::vector<ViewMark>& marks) {
    m_lines.clear();
    for (const ViewMark& mark : marks) {
        if (mark.reprojectionPx && mark.origin != MarkOrigin::Proposed)
            m_lines.push_back({mark.px, *mark.reprojectionPx, fingerColour(mark.joint.joint), false});
        if (mark.curvePx)
            m_lines.push_back({mark.px, *mark.curvePx, kGapRed, true});
    }
    updateBounds();
}

void ReprojectionItem::setFactor(double factor) {
    m_factor = factor;
    updateBounds();
}

void ReprojectionItem::updateBounds() {
    QRectF bounds;
    for (const Line& line : m_lines) {
        include(bounds, line.fromPx);
        include(bounds, end(line));
    }
    setBounds(bounds);
}

void ReprojectionItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    for (const Line& line : m_lines) {
        const QPointF from = line.fromPx + kHalf, to = end(line) + kHalf;
        painter->setPen(cosmetic(QColor(0, 0, 0, 150), line.isGap ? 3.5 : 2.6));
        painter->drawLine(from, to);
        painter->setPen(cosmetic(line.colour, line.isGap ? 2 : 1.1));
        painter->drawLine(from, to);
        painter->setPen(cosmetic(line.colour, 3));
        painter->drawPoint(to);
    }
}

} // namespace widgets
