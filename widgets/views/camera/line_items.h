// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <QGraphicsItem>

#include "widgets/views/camera/view_mark.h"

namespace widgets {

/// Lines over the image whose width is counted in screen pixels, whatever the zoom.
class LineItem : public QGraphicsItem {
public:
    explicit LineItem(QGraphicsItem* parent)
        : QGraphicsItem(parent) {}
    QRectF boundingRect() const override { return m_bounds; }

protected:
    /// To be called with what is about to be drawn, in image pixels.
    void setBounds(const QRectF& boundsPx);

private:
    QRectF m_bounds;
};

/// Bones, 1.5 px wide.
class SkeletonItem : public LineItem {
public:
    using LineItem::LineItem;
    void setLines(const std::vector<SkeletonLine>& lines);
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    std::vector<SkeletonLine> m_lines;
};

/// Epipolar curves, 1 px wide, that fade with the distance from the focus.
class GuidesItem : public LineItem {
public:
    using LineItem::LineItem;
    void setGuides(const std::vector<EpipolarGuide>& guides);
    void setFocus(const std::optional<QPointF>& px);
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    std::vector<EpipolarGuide> m_guides;
    std::optional<QPointF> m_focusPx;
};

/// Arrows of residuals, 1.5 px wide with heads of 6 screen pixels; a dot where there is hardly a residual.
class ArrowsItem : public LineItem {
public:
    using LineItem::LineItem;
    void setArrows(const std::vector<ResidualArrow>& arrows);
    const std::vector<ResidualArrow>& arrows() const { return m_arrows; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    std::vector<ResidualArrow> m_arrows;
};

/// The projected 95 % region.
class EllipseItem : public LineItem {
public:
    using LineItem::LineItem;
    void setEllipse(const std::optional<UncertaintyEllipse>& ellipse);
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    std::optional<UncertaintyEllipse> m_ellipse;
};

/// Thin lines from clicks to the reprojections of their 3D joints, drawn `factor` times as long as they are; where
/// clicks give no joint, red lines to the curves that they contradict.
class ReprojectionItem : public LineItem {
public:
    using LineItem::LineItem;
    void setMarks(const std::vector<ViewMark>& marks);
    void setFactor(double factor);
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    struct Line {
        QPointF fromPx, toPx;
        QColor colour;
        bool isGap = false; ///< to a curve: never lengthened
    };
    QPointF end(const Line& line) const {
        return line.fromPx + (line.toPx - line.fromPx) * (line.isGap ? 1 : m_factor);
    }
    void updateBounds();

    std::vector<Line> m_lines;
    double m_factor = 1;
};

} // namespace widgets
