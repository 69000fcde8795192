// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QColor>
#include <QImage>
#include <QPixmap>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <QWidget>

#include "widgets/views/plot_axis.h"

class QMenu;

namespace widgets {

/// Where things lie on a paint device, and what the axes cover.
struct PlotFrame {
    QRectF plot;
    QRectF whole;
    PlotAxis x, y;
    std::vector<double> xTicks, yTicks;
    QStringList xNames; ///< of the ticks of x; none: their numbers

    QPointF place(QPointF value) const {
        return {plot.left() + x.position(value.x()) * plot.width(),
                plot.bottom() - y.position(value.y()) * plot.height()};
    }
    QPointF value(QPointF place) const {
        return {x.value((place.x() - plot.left()) / plot.width()),
                y.value((plot.bottom() - place.y()) / plot.height())};
    }
};

/// What stands around a plot.
struct PlotLabels {
    QString title;
    QString xLabel; ///< with its unit
    QString yLabel;
    QString emptyText; ///< while there is nothing to draw
};

/// One entry of a legend: a sample, drawn as the plot draws what the entry stands for, and its name.
struct PlotLegendEntry {
    enum class Sample { Line, Dot, Bar };
    QString name;
    QColor colour;
    bool dashed = false; ///< of a line
    Sample sample = Sample::Line;
};

/// What all plots have in common: axes with round ticks, a legend above the plot, and pictures of themselves as PNG,
/// SVG and PDF in colours for paper. On the screen it is drawn once and kept until it changes.
class PlotCanvas : public QWidget {
    Q_OBJECT
public:
    explicit PlotCanvas(QWidget* parent = nullptr);

    QImage grabPicture(double scale = 1) const;
    /// As a drawing, for pages.
    QByteArray svg() const;
    bool saveSvg(const QString& path) const;
    bool savePdf(const QString& path) const;
    /// Draws everything into an area, in colours for paper: for pages that hold several plots.
    void paintOnPaper(QPainter& painter, const QRectF& area) const;
    void addPictureActions(QMenu& menu);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    virtual bool isEmpty() const = 0;
    virtual PlotLabels labels() const = 0;
    /// What the axes cover; ticks and places are added.
    virtual PlotFrame axes() const = 0;
    /// Stands above the plot, side by side, where the entries leave room enough for the plot; else in the corner where
    /// the fewest of the content's places lie.
    virtual std::vector<PlotLegendEntry> legend() const { return {}; }
    /// Lines of text that the content draws between that legend and the plot.
    virtual int linesAbove() const { return 0; }
    /// Where the content is drawn, on the paint device.
    virtual std::vector<QPointF> takenPlaces(const PlotFrame&) const { return {}; }
    virtual void paintContent(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const = 0;
    /// What is under the pointer, drawn over the rest, on the screen alone.
    virtual void paintPointed(QPainter&, const PlotFrame&) const {}
    /// Entries of the context menu before those of pictures.
    virtual void addMenuActions(QMenu&) {}

    PlotFrame frame(const QRectF& area) const;
    /// Something else is to be drawn.
    void contentChanged();
    /// A line of text in a box beside a place of the widget.
    void paintTip(QPainter& painter, const PlotFrame& frame, QPointF place, const QString& text) const;

    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void paint(QPainter& painter, const QRectF& area, const QPalette& colours) const;
    void paintAxes(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const;
    void paintTitles(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const;
    bool hasLegendAbove(const QRectF& area) const;
    void paintLegendAbove(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const;
    void paintLegendInside(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const;
    QRectF legendBox(const PlotFrame& frame, const QSizeF& size) const;
    std::vector<QRectF> legendPlaces(const std::vector<PlotLegendEntry>& entries, const QRectF& area) const;

    QPixmap m_drawn; ///< on the screen; null if it must be drawn again
};

/// As plots write numbers.
QString plotNumber(double value);
/// A colour that can be seen on the ground: white lines on paper become dark, pale yellow ones darker.
QColor plotColour(const QColor& colour, const QColor& ground);

} // namespace widgets
