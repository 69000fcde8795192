// SPDX-License-Identifier: MIT
#include "widgets/views/plot_canvas.h"

#include <algorithm>
#include <cmath>

#include <QBuffer>
#include <QContextMenuEvent>
#include <QFile>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QSvgGenerator>

#include "widgets/views/page_picture.h"
#include "widgets/views/picture_export.h"

namespace widgets {

namespace {

constexpr int kPlotSpacing = 6;
constexpr double kLegendSample = 18; ///< length of the line before a name
constexpr double kLegendShare = 0.3; ///< of the height, at most, for a legend above the plot

/// Light paper colours for files: figures go into papers and slides.
QPalette paperPalette() {
    QPalette paper;
    paper.setColor(QPalette::Base, Qt::white);
    paper.setColor(QPalette::Window, Qt::white);
    paper.setColor(QPalette::Text, QColor(0x20, 0x22, 0x25));
    paper.setColor(QPalette::PlaceholderText, QColor(0x60, 0x64, 0x6A));
    return paper;
}

double luminance(const QColor& c) {
    const auto linear = [](double v) { return v * v; };
    return 0.21 * linear(c.redF()) + 0.72 * linear(c.greenF()) + 0.07 * linear(c.blueF());
}

} // namespace

QString plotNumber(double value) {
    return QLocale().toString(value, 'g', 4);
}

QColor plotColour(const QColor& colour, const QColor& ground) {
    constexpr double kFlare = 0.05, kLeastContrast = 1.45;
    const double a = luminance(colour) + kFlare, b = luminance(ground) + kFlare;
    if (std::max(a, b) / std::min(a, b) > kLeastContrast)
        return colour;
    return b > 0.5 ? colour.darker(colour.saturation() < 30 ? 600 : 125) : colour.lighter(170);
}

PlotCanvas::PlotCanvas(QWidget* parent)
    : QWidget(parent) {
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
}

QSize PlotCanvas::sizeHint() const {
    return {360, 220};
}

QSize PlotCanvas::minimumSizeHint() const {
    return {160, 110};
}

void PlotCanvas::contentChanged() {
    m_drawn = {};
    update();
}

PlotFrame PlotCanvas::frame(const QRectF& area) const {
    PlotFrame result = axes();
    const PlotLabels texts = labels();
    const QFontMetricsF metrics(font());
    const double line = metrics.height();
    result.whole = area;
    result.yTicks = ticks(result.y, std::max(2, static_cast<int>(area.height() / (2.2 * line))));
    double labelWidth = 0;
    for (const double v : result.yTicks)
        labelWidth = std::max(labelWidth, metrics.horizontalAdvance(plotNumber(v)));
    const double left = labelWidth + 2 * kPlotSpacing + (texts.yLabel.isEmpty() ? 0 : line);
    double top = kPlotSpacing + (texts.title.isEmpty() ? line / 2 : line + kPlotSpacing);
    if (hasLegendAbove(area))
        top += legendPlaces(legendAbove(), area).back().bottom();
    top += linesAbove() * line;
    const double bottom = line + 1.5 * kPlotSpacing + (texts.xLabel.isEmpty() ? 0 : line);
    result.plot = area.adjusted(left, top, -2.5 * kPlotSpacing, -bottom);
    if (result.xTicks.empty())
        result.xTicks = ticks(result.x, std::max(2, static_cast<int>(result.plot.width() / (3.5 * line))));
    return result;
}

void PlotCanvas::paintAxes(QPainter& painter, const PlotFrame& f, const QPalette& colours) const {
    const PlotLabels texts = labels();
    const QColor text = colours.color(QPalette::Text);
    QColor grid = text;
    grid.setAlphaF(0.13);
    const double line = QFontMetricsF(font()).height();
    for (const double v : f.yTicks) {
        const double y = f.place({f.x.min, v}).y();
        painter.setPen(QPen(grid, 1));
        painter.drawLine(QPointF(f.plot.left(), y), QPointF(f.plot.right(), y));
        painter.setPen(text);
        painter.drawText(QRectF(f.whole.left(), y - line, f.plot.left() - kPlotSpacing - f.whole.left(), 2 * line),
                         Qt::AlignRight | Qt::AlignVCenter, plotNumber(v));
    }
    for (std::size_t i = 0; i < f.xTicks.size(); ++i) {
        const double x = f.place({f.xTicks[i], f.y.min}).x();
        const QString name = f.xNames.isEmpty() ? plotNumber(f.xTicks[i]) : f.xNames.value(static_cast<int>(i));
        painter.setPen(QPen(grid, 1));
        painter.drawLine(QPointF(x, f.plot.top()), QPointF(x, f.plot.bottom()));
        painter.setPen(text);
        painter.drawText(QRectF(x - 4 * line, f.plot.bottom() + kPlotSpacing / 2.0, 8 * line, line), Qt::AlignCenter,
                         name);
    }
    painter.setPen(colours.color(QPalette::PlaceholderText));
    painter.drawText(QRectF(f.plot.left(), f.whole.bottom() - line - kPlotSpacing / 2.0, f.plot.width(), line),
                     Qt::AlignCenter, texts.xLabel);
    painter.save();
    painter.translate(f.whole.left() + kPlotSpacing / 2.0, f.plot.center().y());
    painter.rotate(-90);
    painter.drawText(QRectF(-f.plot.height() / 2, 0, f.plot.height(), line), Qt::AlignCenter, texts.yLabel);
    painter.restore();
    painter.setPen(text);
    painter.drawText(QRectF(f.plot.left(), f.whole.top() + kPlotSpacing, f.plot.width(), line),
                     Qt::AlignLeft | Qt::AlignVCenter, texts.title);
}

/// Relative to the place where the legend begins.
std::vector<QRectF> PlotCanvas::legendPlaces(const std::vector<PlotLegendEntry>& entries, const QRectF& area) const {
    const QFontMetricsF metrics(font());
    std::vector<QRectF> places;
    double x = 0, y = 0;
    for (const PlotLegendEntry& entry : entries) {
        const double width = kLegendSample + kPlotSpacing + metrics.horizontalAdvance(entry.name);
        if (x > 0 && x + width > area.width() - 4 * kPlotSpacing) {
            x = 0;
            y += metrics.height();
        }
        places.emplace_back(x, y, width, metrics.height());
        x += width + 2.5 * kPlotSpacing;
    }
    return places;
}

bool PlotCanvas::hasLegendAbove(const QRectF& area) const {
    const std::vector<QRectF> places = legendPlaces(legendAbove(), area);
    return !places.empty() && places.back().bottom() <= kLegendShare * area.height();
}

void PlotCanvas::paintLegendAbove(QPainter& painter, const PlotFrame& f, const QPalette& colours) const {
    if (!hasLegendAbove(f.whole))
        return;
    const std::vector<PlotLegendEntry> entries = legendAbove();
    const std::vector<QRectF> places = legendPlaces(entries, f.whole);
    const double line = QFontMetricsF(font()).height();
    const double top = f.whole.top() + kPlotSpacing + (labels().title.isEmpty() ? 0 : line);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const QRectF place = places[i].translated(f.whole.left() + 2 * kPlotSpacing, top);
        const QColor colour = plotColour(entries[i].colour, colours.color(QPalette::Base));
        painter.setPen(QPen(colour, 2, entries[i].dashed ? Qt::DashLine : Qt::SolidLine));
        painter.drawLine(QPointF(place.left(), place.center().y()),
                         QPointF(place.left() + kLegendSample, place.center().y()));
        painter.setPen(colours.color(QPalette::Text));
        painter.drawText(place.adjusted(kLegendSample + kPlotSpacing, 0, 2, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         entries[i].name);
    }
}

void PlotCanvas::paintLegend(QPainter& painter, const PlotFrame& f, const QPalette& colours,
                             const std::vector<PlotLegendEntry>& entries,
                             const std::vector<QPointF>& takenPlaces) const {
    const QFontMetricsF metrics(font());
    double width = 0;
    for (const PlotLegendEntry& entry : entries)
        width = std::max(width, metrics.horizontalAdvance(entry.name));
    int taken[2][2] = {{0, 0}, {0, 0}}; // [right half][bottom half]
    for (const QPointF& place : takenPlaces)
        ++taken[place.x() > f.plot.center().x()][place.y() > f.plot.center().y()];
    const QSizeF size(width + kLegendSample + 3 * kPlotSpacing,
                      metrics.height() * static_cast<double>(entries.size()) + kPlotSpacing);
    bool right = true, bottom = false;
    for (const auto& [r, b] : {std::pair(true, true), std::pair(false, false), std::pair(false, true)}) {
        if (taken[r][b] < taken[right][bottom]) {
            right = r;
            bottom = b;
        }
    }
    QRectF box(f.plot.topLeft() + QPointF(kPlotSpacing, kPlotSpacing), size);
    if (right)
        box.moveRight(f.plot.right() - kPlotSpacing);
    if (bottom)
        box.moveBottom(f.plot.bottom() - kPlotSpacing);
    QColor ground = colours.color(QPalette::Base);
    ground.setAlphaF(0.8);
    painter.fillRect(box, ground);
    double y = box.top() + kPlotSpacing / 2.0;
    for (const PlotLegendEntry& entry : entries) {
        const QColor colour = plotColour(entry.colour, colours.color(QPalette::Base));
        painter.setPen(QPen(colour, 2, entry.dashed ? Qt::DashLine : Qt::SolidLine));
        const double middle = y + metrics.height() / 2;
        painter.drawLine(QPointF(box.left() + kPlotSpacing, middle),
                         QPointF(box.left() + kPlotSpacing + kLegendSample, middle));
        painter.setPen(colours.color(QPalette::Text));
        painter.drawText(QRectF(box.left() + 2 * kPlotSpacing + kLegendSample, y, width + 2, metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, entry.name);
        y += metrics.height();
    }
}

void PlotCanvas::paintTip(QPainter& painter, const PlotFrame& f, QPointF place, const QString& text) const {
    const QFontMetricsF metrics(font());
    QRectF box(place.x() + kPlotSpacing, place.y() - metrics.height() - kPlotSpacing,
               metrics.horizontalAdvance(text) + 2 * kPlotSpacing, metrics.height() + 2);
    if (box.right() > f.whole.right())
        box.moveRight(std::max(f.whole.left() + box.width(), place.x() - kPlotSpacing));
    box.moveTop(std::max(box.top(), f.whole.top()));
    painter.fillRect(box, palette().color(QPalette::Window));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(box, Qt::AlignCenter, text);
}

void PlotCanvas::paint(QPainter& painter, const QRectF& area, const QPalette& colours) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    painter.fillRect(area, colours.color(QPalette::Base));
    if (isEmpty()) {
        painter.setPen(colours.color(QPalette::PlaceholderText));
        painter.drawText(area.adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, labels().emptyText);
        return;
    }
    const PlotFrame f = frame(area);
    paintAxes(painter, f, colours);
    paintLegendAbove(painter, f, colours);
    paintContent(painter, f, colours);
}

void PlotCanvas::paintOnPaper(QPainter& painter, const QRectF& area) const {
    paint(painter, area, paperPalette());
}

void PlotCanvas::paintEvent(QPaintEvent*) {
    const QSize device = size() * devicePixelRatioF();
    if (m_drawn.size() != device) {
        m_drawn = QPixmap(device);
        m_drawn.setDevicePixelRatio(devicePixelRatioF());
        QPainter painter(&m_drawn);
        paint(painter, rect(), palette());
    }
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_drawn);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    if (!isEmpty())
        paintPointed(painter, frame(rect()));
}

void PlotCanvas::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    contentChanged(); // palette, font
}

QImage PlotCanvas::grabPicture(double scale) const {
    QImage picture((QSizeF(size()) * scale).toSize(), QImage::Format_RGB32);
    picture.setDevicePixelRatio(scale);
    QPainter painter(&picture);
    paintOnPaper(painter, rect());
    painter.end();
    picture.setDevicePixelRatio(1);
    return picture;
}

QByteArray PlotCanvas::svg() const {
    QBuffer buffer;
    QSvgGenerator svg;
    svg.setOutputDevice(&buffer);
    svg.setResolution(logicalDpiX());
    svg.setSize(size());
    svg.setViewBox(rect());
    svg.setTitle(labels().title);
    QPainter painter(&svg);
    paintOnPaper(painter, rect());
    painter.end();
    return buffer.data();
}

bool PlotCanvas::saveSvg(const QString& path) const {
    const QByteArray text = svg();
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
}

bool PlotCanvas::savePdf(const QString& path) const {
    const QSizeF page(size());
    const QRectF whole(QPointF(0, 0), page);
    return savePagePdf(
        {labels().title, page, Qt::white, {{whole, [this, whole](QPainter& p, double) { paintOnPaper(p, whole); }}}},
        path);
}

void PlotCanvas::addPictureActions(QMenu& menu) {
    const QString title = labels().title;
    widgets::addPictureActions(menu, this,
                               {[this](double s) { return grabPicture(s); },
                                [this](const QString& p) { return saveSvg(p); },
                                title.isEmpty() ? tr("curves") : title,
                                {},
                                [this](const QString& p) { return savePdf(p); }});
}

void PlotCanvas::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu;
    addMenuActions(menu);
    if (!menu.isEmpty())
        menu.addSeparator();
    addPictureActions(menu);
    menu.exec(event->globalPos());
}

} // namespace widgets
