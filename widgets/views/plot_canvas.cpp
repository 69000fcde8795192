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
constexpr double kLegendDot = 6, kLegendBar = 9;
constexpr double kLegendShare = 0.3; ///< of the height, at most, for a legend above the plot

double sampleLength(PlotLegendEntry::Sample sample) {
    return sample == PlotLegendEntry::Sample::Line  ? kLegendSample
           : sample == PlotLegendEntry::Sample::Dot ? kLegendDot
                                                    : kLegendBar;
}

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

/// A sample at the left end of the place, and its name.
void paintEntry(QPainter& painter, const QRectF& place, const PlotLegendEntry& entry, const QPalette& colours) {
    const QColor colour = plotColour(entry.colour, colours.color(QPalette::Base));
    const QPointF middle(place.left() + sampleLength(entry.sample) / 2, place.center().y());
    painter.setBrush(colour);
    painter.setPen(Qt::NoPen);
    switch (entry.sample) {
    case PlotLegendEntry::Sample::Line:
        painter.setPen(QPen(colour, 2, entry.dashed ? Qt::DashLine : Qt::SolidLine));
        painter.drawLine(middle - QPointF(kLegendSample / 2, 0), middle + QPointF(kLegendSample / 2, 0));
        break;
    case PlotLegendEntry::Sample::Dot:
        painter.drawEllipse(middle, kLegendDot / 2, kLegendDot / 2);
        break;
    case PlotLegendEntry::Sample::Bar:
        painter.drawRect(QRectF(middle - QPointF(kLegendBar / 2, kLegendBar / 2), QSizeF(kLegendBar, kLegendBar)));
        break;
    }
    painter.setPen(colours.color(QPalette::Text));
    painter.drawText(place.adjusted(sampleLength(entry.sample) + kPlotSpacing, 0, 2, 0),
                     Qt::AlignLeft | Qt::AlignVCenter, entry.name);
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
        top += legendPlaces(legend(), area).back().bottom();
    top += linesAbove() * line;
    const double bottom = line + 1.5 * kPlotSpacing + (texts.xLabel.isEmpty() ? 0 : line);
    result.plot = area.adjusted(left, top, -2.5 * kPlotSpacing, -bottom);
    if (result.xTicks.empty())
        result.xTicks = ticks(result.x, std::max(2, static_cast<int>(result.plot.width() / (3.5 * line))));
    return result;
}

void PlotCanvas::paintAxes(QPainter& painter, const PlotFrame& f, const QPalette& colours) const {
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
}

/// The title stands over the whole width, the name of y beside the plot: beyond its lower end rather than cut, where
/// the plot is lower than the name is long.
void PlotCanvas::paintTitles(QPainter& painter, const PlotFrame& f, const QPalette& colours) const {
    const PlotLabels texts = labels();
    const QFontMetricsF metrics(font());
    const double line = metrics.height();
    painter.setPen(colours.color(QPalette::PlaceholderText));
    painter.drawText(QRectF(f.plot.left(), f.whole.bottom() - line - kPlotSpacing / 2.0, f.plot.width(), line),
                     Qt::AlignCenter, metrics.elidedText(texts.xLabel, Qt::ElideRight, f.plot.width()));
    const double room = f.whole.bottom() - f.plot.top() - kPlotSpacing / 2.0;
    const QString yLabel = metrics.elidedText(texts.yLabel, Qt::ElideMiddle, room);
    const double length = std::max(f.plot.height(), metrics.horizontalAdvance(yLabel) + 2);
    painter.save();
    painter.translate(f.whole.left() + kPlotSpacing / 2.0, f.plot.top() + length);
    painter.rotate(-90);
    painter.drawText(QRectF(0, 0, length, line), Qt::AlignCenter, yLabel);
    painter.restore();
    painter.setPen(colours.color(QPalette::Text));
    const QRectF title(f.whole.left() + 2 * kPlotSpacing, f.whole.top() + kPlotSpacing,
                       f.whole.width() - 3 * kPlotSpacing, line);
    painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(texts.title, Qt::ElideRight, title.width()));
}

/// Relative to the place where the legend begins.
std::vector<QRectF> PlotCanvas::legendPlaces(const std::vector<PlotLegendEntry>& entries, const QRectF& area) const {
    const QFontMetricsF metrics(font());
    std::vector<QRectF> places;
    double x = 0, y = 0;
    for (const PlotLegendEntry& entry : entries) {
        const double width = sampleLength(entry.sample) + kPlotSpacing + metrics.horizontalAdvance(entry.name);
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
    const std::vector<QRectF> places = legendPlaces(legend(), area);
    return !places.empty() && places.back().bottom() <= kLegendShare * area.height();
}

void PlotCanvas::paintLegendAbove(QPainter& painter, const PlotFrame& f, const QPalette& colours) const {
    const std::vector<PlotLegendEntry> entries = legend();
    const std::vector<QRectF> places = legendPlaces(entries, f.whole);
    const double line = QFontMetricsF(font()).height();
    const double top = f.whole.top() + kPlotSpacing + (labels().title.isEmpty() ? 0 : line);
    for (std::size_t i = 0; i < entries.size(); ++i)
        paintEntry(painter, places[i].translated(f.whole.left() + 2 * kPlotSpacing, top), entries[i], colours);
}

/// In the corner where the fewest places lie that are taken.
QRectF PlotCanvas::legendBox(const PlotFrame& f, const QSizeF& size) const {
    int taken[2][2] = {{0, 0}, {0, 0}}; // [right half][bottom half]
    for (const QPointF& place : takenPlaces(f))
        ++taken[place.x() > f.plot.center().x()][place.y() > f.plot.center().y()];
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
    return box;
}

void PlotCanvas::paintLegendInside(QPainter& painter, const PlotFrame& f, const QPalette& colours) const {
    const std::vector<PlotLegendEntry> entries = legend();
    if (entries.empty())
        return;
    const QFontMetricsF metrics(font());
    double width = 0;
    for (const PlotLegendEntry& entry : entries)
        width = std::max(width, metrics.horizontalAdvance(entry.name));
    const QRectF box = legendBox(f, {width + kLegendSample + 3 * kPlotSpacing,
                                     metrics.height() * static_cast<double>(entries.size()) + kPlotSpacing});
    QColor ground = colours.color(QPalette::Base);
    ground.setAlphaF(0.8);
    painter.fillRect(box, ground);
    QRectF place(box.left() + kPlotSpacing, box.top() + kPlotSpacing / 2.0, box.width() - kPlotSpacing,
                 metrics.height());
    for (const PlotLegendEntry& entry : entries) {
        paintEntry(painter, place, entry, colours);
        place.translate(0, metrics.height());
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
    paintTitles(painter, f, colours);
    if (hasLegendAbove(area))
        paintLegendAbove(painter, f, colours);
    paintContent(painter, f, colours);
    if (!hasLegendAbove(area))
        paintLegendInside(painter, f, colours);
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
    picture.fill(Qt::white); // the last row and column may be a part of a pixel more than the plot
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
