// SPDX-License-Identifier: MIT
#include "widgets/panels/joint_error_diagram.h"

#include <algorithm>
#include <cmath>

#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>

#include "widgets/panels/hand_drawing.h"
#include "widgets/panels/state_colours.h"
#include "widgets/text/edit_text.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

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

void JointErrorDiagram::setErrors(const std::vector<JointError>& errors) {
    m_errors = errors;
    m_largestMm = 0;
    for (const JointError& error : errors)
        if (std::isfinite(error.errorMm))
            m_largestMm = std::max(m_largestMm, error.errorMm);
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

QPointF JointErrorDiagram::placeOf(const core::JointId& joint, bool* known) const {
    const auto unit = diagramPosition(joint.joint);
    *known = unit.has_value();
    return unit ? placeInHand(joint.hand, handArea(joint.hand, handsArea()), *unit) : QPointF();
}

void JointErrorDiagram::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const core::Side hand : {core::Side::Left, core::Side::Right})
        paintHandOutline(painter, hand, handArea(hand, handsArea()), palette());
    for (const JointError& error : m_errors) {
        bool known = false;
        const QPointF centre = placeOf(error.joint, &known);
        if (!known)
            continue;
        painter.setPen(QPen(palette().color(QPalette::Window), 1));
        const bool finite = std::isfinite(error.errorMm) && m_largestMm > 0;
        painter.setBrush(finite ? QBrush(errorColour(error.errorMm / m_largestMm)) : QBrush(Qt::NoBrush));
        painter.drawEllipse(centre, kDotRadius, kDotRadius);
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
    QString text;
    for (const JointError& error : m_errors) {
        bool known = false;
        const QPointF offset = placeOf(error.joint, &known) - help->pos();
        if (known && std::hypot(offset.x(), offset.y()) < 2 * kDotRadius)
            text = QStringLiteral("%1: %2").arg(jointText(error.joint), millimetres(error.errorMm));
    }
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

} // namespace widgets
