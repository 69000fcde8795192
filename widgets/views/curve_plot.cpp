// SPDX-License-Identifier: MIT
#include "widgets/views/curve_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QLocale>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSvgGenerator>

#include "widgets/views/picture_export.h"
#include "widgets/views/plot_axis.h"

namespace widgets {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kSpacing = 6;

QString number(double v) {
    return QLocale().toString(v, 'g', 4);
}

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

/// Light paper colours for files: figures go into papers and slides.
QPalette paperPalette() {
    QPalette paper;
    paper.setColor(QPalette::Base, Qt::white);
    paper.setColor(QPalette::Text, QColor(0x20, 0x22, 0x25));
    paper.setColor(QPalette::PlaceholderText, QColor(0x60, 0x64, 0x6A));
    return paper;
}

double luminance(const QColor& c) {
    const auto linear = [](double v) { return v * v; };
    return 0.21 * linear(c.redF()) + 0.72 * linear(c.greenF()) + 0.07 * linear(c.blueF());
}

/// A colour that can be seen on the ground: white lines on paper become dark, pale yellow ones darker.
QColor readable(const QColor& colour, const QColor& ground) {
    constexpr double kFlare = 0.05, kLeastContrast = 1.45;
    const double a = luminance(colour) + kFlare, b = luminance(ground) + kFlare;
    if (std::max(a, b) / std::min(a, b) > kLeastContrast)
        return colour;
    return b > 0.5 ? colour.darker(colour.saturation() < 30 ? 600 : 125) : colour.lighter(170);
}

} // namespace

/// Where things lie on the paint device, and what the axes cover.
struct CurvePlot::Frame {
    QRectF plot;
    QRectF whole;
    PlotAxis x, y;
    std::vector<double> xTicks, yTicks;

    QPointF place(QPointF p) const {
        return {plot.left() + x.position(p.x()) * plot.width(), plot.bottom() - y.position(p.y()) * plot.height()};
    }
};

CurvePlot::CurvePlot(QWidget* parent)
    : QWidget(parent)
    , m_cursorX(kNone)
    , m_hoverX(kNone) {
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
}

void CurvePlot::setSettings(const CurvePlotSettings& settings) {
    m_settings = settings;
    update();
}

void CurvePlot::setLogarithmic(bool on) {
    m_settings.yLogarithmic = on;
    update();
}

void CurvePlot::setCurves(const std::vector<Curve>& curves) {
    m_curves = curves;
    update();
}

void CurvePlot::setCursor(double x) {
    m_cursorX = x;
    update();
}

QSize CurvePlot::sizeHint() const {
    return {360, 220};
}
QSize CurvePlot::minimumSizeHint() const {
    return {160, 110};
}

CurvePlot::Frame CurvePlot::frame(const QRectF& area) const {
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
    Frame result;
    const bool xGiven = m_settings.xMax > m_settings.xMin, yGiven = m_settings.yMax > m_settings.yMin;
    result.x = xGiven ? PlotAxis{m_settings.xMin, m_settings.xMax, false} : roundAxis(xMin, xMax, false);
    if (!xGiven && xMax > xMin)
        result.x = {xMin, xMax, false}; // curves fill the width
    result.x.whole = m_settings.xWhole;
    result.y = yGiven ? PlotAxis{m_settings.yMin, m_settings.yMax, m_settings.yLogarithmic}
                      : roundAxis(yMin, yMax, m_settings.yLogarithmic);
    const QFontMetricsF metrics(font());
    const double line = metrics.height();
    result.whole = area;
    result.yTicks = ticks(result.y, std::max(2, static_cast<int>(area.height() / (2.2 * line))));
    double labelWidth = 0;
    for (const double v : result.yTicks)
        labelWidth = std::max(labelWidth, metrics.horizontalAdvance(number(v)));
    const double left = labelWidth + 2 * kSpacing + (m_settings.yLabel.isEmpty() ? 0 : line);
    const double top = kSpacing + (m_settings.title.isEmpty() ? line / 2 : line + kSpacing);
    const double bottom = line + 1.5 * kSpacing + (m_settings.xLabel.isEmpty() ? 0 : line);
    result.plot = area.adjusted(left, top, -2.5 * kSpacing, -bottom);
    result.xTicks = ticks(result.x, std::max(2, static_cast<int>(result.plot.width() / (5 * line))));
    return result;
}

void CurvePlot::paintAxes(QPainter& painter, const Frame& f, const QPalette& colours) const {
    const QColor text = colours.color(QPalette::Text);
    QColor grid = text;
    grid.setAlphaF(0.13);
    const double line = QFontMetricsF(font()).height();
    for (const double v : f.yTicks) {
        const double y = f.place({f.x.min, v}).y();
        painter.setPen(QPen(grid, 1));
        painter.drawLine(QPointF(f.plot.left(), y), QPointF(f.plot.right(), y));
        painter.setPen(text);
        painter.drawText(QRectF(f.whole.left(), y - line, f.plot.left() - kSpacing - f.whole.left(), 2 * line),
                         Qt::AlignRight | Qt::AlignVCenter, number(v));
    }
    for (const double v : f.xTicks) {
        const double x = f.place({v, f.y.min}).x();
        painter.setPen(QPen(grid, 1));
        painter.drawLine(QPointF(x, f.plot.top()), QPointF(x, f.plot.bottom()));
        painter.setPen(text);
        painter.drawText(QRectF(x - 4 * line, f.plot.bottom() + kSpacing / 2.0, 8 * line, line), Qt::AlignCenter,
                         number(v));
    }
    painter.setPen(colours.color(QPalette::PlaceholderText));
    painter.drawText(QRectF(f.plot.left(), f.whole.bottom() - line - kSpacing / 2.0, f.plot.width(), line),
                     Qt::AlignCenter, m_settings.xLabel);
    painter.save();
    painter.translate(f.whole.left() + kSpacing / 2.0, f.plot.center().y());
    painter.rotate(-90);
    painter.drawText(QRectF(-f.plot.height() / 2, 0, f.plot.height(), line), Qt::AlignCenter, m_settings.yLabel);
    painter.restore();
    painter.setPen(text);
    painter.drawText(QRectF(f.plot.left(), f.whole.top() + kSpacing, f.plot.width(), line),
                     Qt::AlignLeft | Qt::AlignVCenter, m_settings.title);
}

void CurvePlot::paintCurves(QPainter& painter, const Frame& f, const QPalette& colours) const {
    painter.save();
    painter.setClipRect(f.plot.adjusted(-3, -3, 3, 3));
    for (const Curve& curve : m_curves) {
        const QColor colour = readable(curve.colour, colours.color(QPalette::Base));
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

/// In the corner of the plot that the curves leave free.
void CurvePlot::paintLegend(QPainter& painter, const Frame& f, const QPalette& colours) const {
    const QFontMetricsF metrics(font());
    constexpr double kSample = 18;
    double width = 0;
    int points[2][2] = {{0, 0}, {0, 0}}; // [right half][bottom half]
    for (const Curve& curve : m_curves) {
        width = std::max(width, metrics.horizontalAdvance(curve.name));
        for (const QPointF& p : curve.points)
            ++points[f.x.position(p.x()) > 0.5][f.y.position(p.y()) < 0.5];
    }
    const QSizeF size(width + kSample + 3 * kSpacing,
                      metrics.height() * static_cast<double>(m_curves.size()) + kSpacing);
    bool right = true, bottom = false;
    for (const auto& [r, b] : {std::pair(true, true), std::pair(false, false), std::pair(false, true)}) {
        if (points[r][b] < points[right][bottom]) {
            right = r;
            bottom = b;
        }
    }
    QRectF box(f.plot.topLeft() + QPointF(kSpacing, kSpacing), size);
    if (right)
        box.moveRight(f.plot.right() - kSpacing);
    if (bottom)
        box.moveBottom(f.plot.bottom() - kSpacing);
    QColor ground = colours.color(QPalette::Base);
    ground.setAlphaF(0.8);
    painter.fillRect(box, ground);
    double y = box.top() + kSpacing / 2.0;
    for (const Curve& curve : m_curves) {
        const QColor colour = readable(curve.colour, colours.color(QPalette::Base));
        painter.setPen(QPen(colour, 2, curve.dashed ? Qt::DashLine : Qt::SolidLine));
        const double middle = y + metrics.height() / 2;
        painter.drawLine(QPointF(box.left() + kSpacing, middle), QPointF(box.left() + kSpacing + kSample, middle));
        painter.setPen(colours.color(QPalette::Text));
        painter.drawText(QRectF(box.left() + 2 * kSpacing + kSample, y, width + 2, metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, curve.name);
        y += metrics.height();
    }
}

/// The curves' values under the pointer.
void CurvePlot::paintReadout(QPainter& painter, const Frame& f) const {
    if (std::isnan(m_hoverX))
        return;
    const QFontMetricsF metrics(font());
    QStringList texts;
    std::vector<QColor> colours;
    for (const Curve& curve : m_curves) {
        const double y = valueAt(curve, m_hoverX);
        if (std::isfinite(y)) {
            texts << number(y);
            colours.push_back(readable(curve.colour, palette().color(QPalette::Base)));
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
    double width = metrics.horizontalAdvance(number(m_hoverX));
    for (const QString& text : texts)
        width = std::max(width, metrics.horizontalAdvance(text));
    const bool leftSide = x + width + 3 * kSpacing > f.plot.right();
    QRectF box(leftSide ? x - width - 3 * kSpacing : x + kSpacing, y, width + 2 * kSpacing,
               metrics.height() * (texts.size() + 1) + kSpacing);
    painter.fillRect(box, palette().color(QPalette::Window));
    box.adjust(kSpacing, kSpacing / 2.0, -kSpacing, 0);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(box, Qt::AlignRight | Qt::AlignTop, number(m_hoverX));
    for (int i = 0; i < texts.size(); ++i) {
        box.setTop(box.top() + metrics.height());
        painter.setPen(colours[static_cast<std::size_t>(i)]);
        painter.drawText(box, Qt::AlignRight | Qt::AlignTop, texts[i]);
    }
}

void CurvePlot::paint(QPainter& painter, const QRectF& area, const QPalette& colours) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    painter.fillRect(area, colours.color(QPalette::Base));
    if (m_curves.empty()) {
        painter.setPen(colours.color(QPalette::PlaceholderText));
        painter.drawText(area.adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, m_settings.emptyText);
        return;
    }
    const Frame f = frame(area);
    paintAxes(painter, f, colours);
    paintCurves(painter, f, colours);
    paintLegend(painter, f, colours);
}

void CurvePlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paint(painter, rect(), palette());
    if (!m_curves.empty())
        paintReadout(painter, frame(rect()));
}

QImage CurvePlot::grabPicture(double scale) const {
    QImage picture((QSizeF(size()) * scale).toSize(), QImage::Format_RGB32);
    picture.setDevicePixelRatio(scale);
    QPainter painter(&picture);
    paint(painter, rect(), paperPalette());
    painter.end();
    picture.setDevicePixelRatio(1);
    return picture;
}

bool CurvePlot::saveSvg(const QString& path) const {
    QSvgGenerator svg;
    svg.setFileName(path);
    svg.setSize(size());
    svg.setViewBox(rect());
    svg.setTitle(m_settings.title);
    QPainter painter;
    if (!painter.begin(&svg))
        return false;
    paint(painter, rect(), paperPalette());
    return painter.end();
}

void CurvePlot::addPictureActions(QMenu& menu) {
    widgets::addPictureActions(menu, this,
                               {[this](double s) { return grabPicture(s); },
                                [this](const QString& p) { return saveSvg(p); },
                                m_settings.title.isEmpty() ? tr("curves") : m_settings.title,
                                {}});
}

/// x of a place in the widget; a whole number where x counts something.
double CurvePlot::valueOfPlace(const Frame& f, QPointF place) const {
    const double x = f.x.value((place.x() - f.plot.left()) / f.plot.width());
    return m_settings.xWhole ? std::clamp(std::round(x), std::ceil(f.x.min), std::floor(f.x.max)) : x;
}

void CurvePlot::mouseMoveEvent(QMouseEvent* event) {
    const Frame f = frame(rect());
    const double position = (event->localPos().x() - f.plot.left()) / f.plot.width();
    m_hoverX = !m_curves.empty() && position >= 0 && position <= 1 ? valueOfPlace(f, event->localPos()) : kNone;
    update();
}

void CurvePlot::mousePressEvent(QMouseEvent* event) {
    const Frame f = frame(rect());
    if (event->button() == Qt::LeftButton && !m_curves.empty() && f.plot.contains(event->localPos()))
        emit xClicked(valueOfPlace(f, event->localPos()));
}

void CurvePlot::leaveEvent(QEvent*) {
    m_hoverX = kNone;
    update();
}

void CurvePlot::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu;
    QAction* logarithmic = menu.addAction(tr("Logarithmic axis"));
    logarithmic->setCheckable(true);
    logarithmic->setChecked(isLogarithmic());
    connect(logarithmic, &QAction::toggled, this, &CurvePlot::setLogarithmic);
    menu.addSeparator();
    addPictureActions(menu);
    menu.exec(event->globalPos());
}

} // namespace widgets
