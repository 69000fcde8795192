// SPDX-License-Identifier: MIT
#include "widgets/panels/joint_error_diagram.h"

#include <algorithm>
#include <cmath>

#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "widgets/panels/hand_drawing.h"
#include "widgets/panels/state_colours.h"
#include "widgets/text/edit_text.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

constexpr double kEdgeQuiet = 0.45; ///< of a dot: the darkest colour of the scale is as dark as the hand
constexpr double kDotRadius = 6;
constexpr int kLegendHeight = 10;
constexpr double kLegendWidth = 160;

QString millimetres(double mm) {
    return JointErrorDiagram::tr("%1 mm").arg(QLocale().toString(mm, 'f', 1));
}

} // namespace

JointErrorDiagram::JointErrorDiagram(QWidget* parent)
    : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Mean error per joint"));
}

void JointErrorDiagram::setErrors(const std::vector<JointError>& errors, double largestMm) {
    m_errors = errors;
    m_largestMm = largestMm;
    for (const JointError& error : errors)
        if (std::isfinite(error.errorMm))
            m_largestMm = std::max(m_largestMm, error.errorMm);
    update();
}

void JointErrorDiagram::setClickable(bool clickable) {
    m_isClickable = clickable;
    setMouseTracking(clickable);
}

void JointErrorDiagram::setSelected(const std::optional<core::JointId>& joint) {
    m_selected = joint;
    update();
}

QSize JointErrorDiagram::sizeHint() const {
    return {300, 200};
}

QSize JointErrorDiagram::minimumSizeHint() const {
    return {200, 140};
}

QRectF JointErrorDiagram::handsArea() const {
    return {0, 0, double(width()), double(height() - fontMetrics().height() - kLegendHeight)};
}

std::optional<QPointF> JointErrorDiagram::placeOf(const core::JointId& joint) const {
    const auto unit = diagramPosition(joint.joint);
    return unit ? std::optional(placeInHand(joint.hand, handArea(joint.hand, handsArea()), *unit)) : std::nullopt;
}

const JointError* JointErrorDiagram::errorAt(QPointF place) const {
    const JointError* nearest = nullptr;
    double least = 2 * kDotRadius;
    for (const JointError& error : m_errors) {
        const auto centre = placeOf(error.joint);
        const double distance = centre ? std::hypot(centre->x() - place.x(), centre->y() - place.y()) : least;
        if (distance < least) {
            least = distance;
            nearest = &error;
        }
    }
    return nearest;
}

void JointErrorDiagram::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const core::Side hand : {core::Side::Left, core::Side::Right})
        paintHandOutline(painter, hand, handArea(hand, handsArea()), palette());
    for (const JointError& error : m_errors) {
        const auto centre = placeOf(error.joint);
        if (!centre)
            continue;
        painter.setPen(
            QPen(mixed(palette().color(QPalette::WindowText), palette().color(QPalette::Window), kEdgeQuiet), 1));
        const bool finite = std::isfinite(error.errorMm) && m_largestMm > 0;
        painter.setBrush(finite ? QBrush(errorColour(error.errorMm / m_largestMm)) : QBrush(Qt::NoBrush));
        painter.drawEllipse(*centre, kDotRadius, kDotRadius);
        if (error.joint == m_selected) {
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
            painter.drawEllipse(*centre, kDotRadius + 3, kDotRadius + 3);
        }
    }
    if (m_largestMm > 0)
        paintLegend(painter);
}

void JointErrorDiagram::paintLegend(QPainter& painter) const {
    const QRectF bar((width() - kLegendWidth) / 2.0, height() - kLegendHeight - fontMetrics().height(), kLegendWidth,
                     kLegendHeight);
    QLinearGradient scale(bar.topLeft(), bar.topRight());
    for (int i = 0; i <= 8; ++i)
        scale.setColorAt(i / 8.0, errorColour(i / 8.0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(scale);
    painter.drawRect(bar);
    painter.setPen(quietTextColour(palette()));
    const QRectF text(bar.left(), bar.bottom(), bar.width(), fontMetrics().height());
    painter.drawText(text, Qt::AlignLeft, millimetres(0));
    painter.drawText(text, Qt::AlignRight, millimetres(m_largestMm));
}

bool JointErrorDiagram::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const JointError* pointed = errorAt(help->pos());
    const QString text =
        pointed ? QStringLiteral("%1: %2").arg(jointText(pointed->joint), millimetres(pointed->errorMm)) : QString();
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

void JointErrorDiagram::mousePressEvent(QMouseEvent* event) {
    const JointError* pointed =
        m_isClickable && event->button() == Qt::LeftButton ? errorAt(event->localPos()) : nullptr;
    if (pointed)
        emit jointClicked(pointed->joint);
}

void JointErrorDiagram::mouseMoveEvent(QMouseEvent* event) {
    setCursor(errorAt(event->localPos()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

} // namespace widgets
