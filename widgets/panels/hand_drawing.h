// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <QPalette>
#include <QPointF>
#include <QRectF>

#include "core/hand/skeleton.h"

class QPainter;

/// The drawing of two hands, seen from their backs, that stands for joints wherever there is no picture.
namespace widgets {

/// Where a joint lies in a drawing of the left hand in the unit square (thumb on the right, y down); empty for names
/// that it does not know. The right hand is its mirror image.
std::optional<QPointF> diagramPosition(const std::string& joint);
/// The square of one hand within a drawing of both.
QRectF handArea(core::Side hand, const QRectF& whole);
/// A point of the unit square in a hand's area; mirrored for the right hand.
QPointF placeInHand(core::Side hand, const QRectF& area, QPointF unit);
void paintHandOutline(QPainter& painter, core::Side hand, const QRectF& area, const QPalette& palette);

} // namespace widgets
