// SPDX-License-Identifier: MIT
#include "widgets/views/curve_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

namespace widgets {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kReadoutSpacing = 6;
constexpr int kMarkSpacing = 3;
constexpr int kLeastLetters = 3; ///< of a name that is cut

/// y of the curve at x, between its points; NaN outside.
double valueAt(const Curve& curve, double x) {
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
        const QPointF& a = curve.points[i];
        const QPointF& b = curve.points[i + 1];
        if (x >= a.x() && x <= b.x())
            return b.x() > a.x() ? a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x()) : a.y();
    }
    return kNone;
}

/// A name in that room: whole, its first word, or cut; empty where not even that fits.
QString fittingName(const QString& name, const QFontMetricsF& metrics, double room) {
    for (const QString& text : {name, name.section(QLatin1Char(' '), 0, 0)})
        if (metrics.horizontalAdvance(text) <= room)
            return text;
    const QString cut = metrics.elidedText(name, Qt::ElideRight, room);
    return cut.size() > kLeastLetters ? cut : QString();
}

} // namespace

CurvePlot::CurvePlot(QWidget* parent)
    : PlotCanvas(parent)
    , m_cursorX(kNone)
    , m_hoverX(kNone) {}

void CurvePlot::setSettings(const CurvePlotSettings& settings) {
    m_settings = settings;
    contentChanged();
}

void CurvePlot::setLogarithmic(bool on) {
    m_settings.yLogarithmic = on;
    contentChanged();
}

void CurvePlot::setCurves(const std::vector<Curve>& curves) {
    m_curves = curves;
    contentChanged();
}

void CurvePlot::setMarks(const std::vector<PlotMark>& marks) {
    if (marks == m_marks)
        return;
    m_marks = marks;
    contentChanged();
}

void CurvePlot::setCursor(double x) {
    m_cursorX = x;
    contentChanged();
}

PlotLabels CurvePlot::labels() const {
    return {m_settings.title, m_settings.xLabel, m_settings.yLabel, m_settings.emptyText};
}

PlotFrame CurvePlot::axes() const {
    double xMin = HUGE_VAL, xMax = -HUGE_VAL, yMin = HUGE_VAL, yMax = -HUGE_VAL;
    for (const Curve& curve : m_curves) {
        for (const QPointF& p : curve.points) {
            if (std::isfinite(p.x()) && std::isfinite(p.y()) && !(m_settings.yLogarithmic && p.y() <= 0)) {
                xMin = std::min(xMin, p.x());
                xMax = std::max(xMax, p.x());
                yMin = std::min(yMin, p.y());
                yMax = std::max(yMax, p.y());
            }
        }
    }
    PlotFrame result;
    const bool xGiven = m_settings.xMax > m_settings.xMin, yGiven = m_settings.yMax > m_settings.yMin;
    result.x = xGiven ? PlotAxis{m_settings.xMin, m_settings.xMax, false} : roundAxis(xMin, xMax, false);
    if (!xGiven && xMax > xMin)
        result.x = {xMin, xMax, false}; // curves fill the width
    result.x.whole = m_settings.xWhole;
    result.y = yGiven ? PlotAxis{m_settings.yMin, m_settings.yMax, m_settings.yLogarithmic}
                      : roundAxis(yMin, yMax, m_settings.yLogarithmic);
    return result;
}

void CurvePlot::paintContent(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const {
    paintMarks(painter, frame, colours);
    paintCurves(painter, frame, colours);
}

std::vector<QPointF> CurvePlot::takenPlaces(const PlotFrame& frame) const {
    std::vector<QPointF> places;
    for (const Curve& curve : m_curves)
        for (const QPointF& p : curve.points)
            places.push_back(frame.place(p));
    return places;
}

std::vector<PlotLegendEntry> CurvePlot::legend() const {
    std::vector<PlotLegendEntry> entries;
    for (const Curve& curve : m_curves)
        entries.push_back({curve.name, curve.colour, curve.dashed});
    return entries;
}

/// A name stands to the right of its line and ends before the next one's, in a short form where it has to; the tool
/// tip has all of them. Only the last one may reach into the margin.
void CurvePlot::paintMarks(QPainter& painter, const PlotFrame& f, const QPalette& colours) const {
    const QFontMetricsF metrics(font());
    QColor line = colours.color(QPalette::Text);
    line.setAlphaF(0.45);
    for (std::size_t i = 0; i < m_marks.size(); ++i) {
        const double x = f.place({m_marks[i].x, f.y.min}).x();
        if (x < f.plot.left() - 1 || x > f.plot.right() + 1)
            continue;
        painter.setPen(QPen(line, 1, Qt::DotLine));
        painter.drawLine(QPointF(x, f.plot.top() - metrics.height()), QPointF(x, f.plot.bottom()));
        const bool isLast = i + 1 == m_marks.size();
        const double from = x + kMarkSpacing;
        double end = isLast ? f.plot.right() : f.place({m_marks[i + 1].x, f.y.min}).x();
        QString name = fittingName(m_marks[i].name, metrics, end - from);
        if (isLast && name.isEmpty()) {
            end = f.whole.right();
            name = fittingName(m_marks[i].name, metrics, end - from);
        }
        painter.setPen(colours.color(QPalette::PlaceholderText));
        painter.drawText(QRectF(from, f.plot.top() - metrics.height() - 1, end - from, metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, name);
    }
}

void CurvePlot::paintCurves(QPainter& painter, const PlotFrame& f, const QPalette& colours) const {
    painter.save();
    painter.setClipRect(f.plot.adjusted(-3, -3, 3, 3));
    for (const Curve& curve : m_curves) {
        const QColor colour = plotColour(curve.colour, colours.color(QPalette::Base));
        QPainterPath path;
        bool connected = false; // a gap where a value is missing
        for (const QPointF& p : curve.points) {
            if (!std::isfinite(p.y())) {
                connected = false;
                continue;
            }
            connected ? path.lineTo(f.place(p)) : path.moveTo(f.place(p));
            connected = true;
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour, 1.6, curve.dashed ? Qt::DashLine : Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(path);
        if (curve.markers) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(colour);
            for (const QPointF& p : curve.points)
                painter.drawEllipse(f.place(p), 2.4, 2.4);
        }
    }
    if (!std::isnan(m_cursorX)) {
        const double x = f.place({m_cursorX, f.y.min}).x();
        painter.setPen(QPen(colours.color(QPalette::Highlight), 1));
        painter.drawLine(QPointF(x, f.plot.top()), QPointF(x, f.plot.bottom()));
    }
    painter.restore();
}

/// The curves' values under the pointer.
void CurvePlot::paintPointed(QPainter& painter, const PlotFrame& f) const {
    if (std::isnan(m_hoverX))
        return;
    const QFontMetricsF metrics(font());
    QStringList texts;
    std::vector<QColor> colours;
    for (const Curve& curve : m_curves) {
        const double y = valueAt(curve, m_hoverX);
        if (std::isfinite(y)) {
            texts << plotNumber(y);
            colours.push_back(plotColour(curve.colour, palette().color(QPalette::Base)));
            painter.setPen(Qt::NoPen);
            painter.setBrush(colours.back());
            painter.drawEllipse(f.place({m_hoverX, y}), 3, 3);
        }
    }
    const double x = f.place({m_hoverX, f.y.min}).x();
    QColor line = palette().color(QPalette::Text);
    line.setAlphaF(0.4);
    painter.setPen(QPen(line, 1));
    painter.drawLine(QPointF(x, f.plot.top()), QPointF(x, f.plot.bottom()));
    double y = f.plot.top();
    double width = metrics.horizontalAdvance(plotNumber(m_hoverX));
    for (const QString& text : texts)
        width = std::max(width, metrics.horizontalAdvance(text));
    const bool leftSide = x + width + 3 * kReadoutSpacing > f.plot.right();
    QRectF box(leftSide ? x - width - 3 * kReadoutSpacing : x + kReadoutSpacing, y, width + 2 * kReadoutSpacing,
               metrics.height() * (texts.size() + 1) + kReadoutSpacing);
    painter.fillRect(box, palette().color(QPalette::Window));
    box.adjust(kReadoutSpacing, kReadoutSpacing / 2.0, -kReadoutSpacing, 0);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(box, Qt::AlignRight | Qt::AlignTop, plotNumber(m_hoverX));
    for (int i = 0; i < texts.size(); ++i) {
        box.setTop(box.top() + metrics.height());
        painter.setPen(colours[static_cast<std::size_t>(i)]);
        painter.drawText(box, Qt::AlignRight | Qt::AlignTop, texts[i]);
    }
}

/// x of a place in the widget; a whole number where x counts something.
double CurvePlot::valueOfPlace(const PlotFrame& f, QPointF place) const {
    const double x = f.x.value((place.x() - f.plot.left()) / f.plot.width());
    return m_settings.xWhole ? std::clamp(std::round(x), std::ceil(f.x.min), std::floor(f.x.max)) : x;
}

void CurvePlot::mouseMoveEvent(QMouseEvent* event) {
    const PlotFrame f = frame(rect());
    const double position = (event->localPos().x() - f.plot.left()) / f.plot.width();
    m_hoverX = !m_curves.empty() && position >= 0 && position <= 1 ? valueOfPlace(f, event->localPos()) : kNone;
    QString meaning;
    for (const PlotMark& mark : m_marks)
        if (mark.x <= m_hoverX)
            meaning = mark.meaning;
    setToolTip(meaning);
    update();
}

void CurvePlot::mousePressEvent(QMouseEvent* event) {
    const PlotFrame f = frame(rect());
    if (event->button() == Qt::LeftButton && !m_curves.empty() && f.plot.contains(event->localPos()))
        emit xClicked(valueOfPlace(f, event->localPos()));
}

void CurvePlot::leaveEvent(QEvent*) {
    m_hoverX = kNone;
    update();
}

void CurvePlot::addMenuActions(QMenu& menu) {
    QAction* logarithmic = menu.addAction(tr("Logarithmic axis"));
    logarithmic->setCheckable(true);
    logarithmic->setChecked(isLogarithmic());
    connect(logarithmic, &QAction::toggled, this, &CurvePlot::setLogarithmic);
}

} // namespace widgets
