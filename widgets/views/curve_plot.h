// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QColor>
#include <QPointF>
#include <QString>

#include "widgets/views/plot_canvas.h"

namespace widgets {

struct Curve {
    QString name;
    QColor colour;
    bool dashed = false;
    bool markers = false; ///< a dot on every point
    std::vector<QPointF> points;
};

/// What a plot shows; its axes fit the data unless their maximum is above their minimum.
struct CurvePlotSettings {
    QString title;
    QString xLabel; ///< with its unit
    QString yLabel;
    double xMin = 0, xMax = 0;
    double yMin = 0, yMax = 0;
    bool yLogarithmic = false;
    QString emptyText;   ///< shown while there are no curves
    bool xWhole = false; ///< x counts something: ticks, reading and clicks are at whole numbers
};

/// A place on the x axis with a name, such as the beginning of a phase.
struct PlotMark {
    double x = 0;
    QString name;
    QString meaning; ///< for the tool tip
    bool operator==(const PlotMark&) const = default;
};

/// Line plot: error curves, convergence. Reads out the curves under the pointer; saves itself as PNG and SVG.
class CurvePlot : public PlotCanvas {
    Q_OBJECT
public:
    explicit CurvePlot(QWidget* parent = nullptr);

    void setSettings(const CurvePlotSettings& settings);
    const CurvePlotSettings& settings() const { return m_settings; }
    void setCurves(const std::vector<Curve>& curves);
    bool isLogarithmic() const { return m_settings.yLogarithmic; }
    void setLogarithmic(bool on);
    /// Thin vertical lines with their names above the plot; what begins there lasts to the next. In order of x.
    void setMarks(const std::vector<PlotMark>& marks);
    const std::vector<PlotMark>& marks() const { return m_marks; }
    /// A vertical line, such as the iteration that is shown; NaN for none.
    void setCursor(double x);

signals:
    /// The plot was clicked at this x.
    void xClicked(double x);

protected:
    bool isEmpty() const override { return m_curves.empty(); }
    PlotLabels labels() const override;
    PlotFrame axes() const override;
    std::vector<PlotLegendEntry> legend() const override;
    std::vector<QPointF> takenPlaces(const PlotFrame& frame) const override;
    int linesAbove() const override { return m_marks.empty() ? 0 : 1; }
    void paintContent(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const override;
    void paintPointed(QPainter& painter, const PlotFrame& frame) const override;
    void addMenuActions(QMenu& menu) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void paintCurves(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const;
    void paintMarks(QPainter& painter, const PlotFrame& frame, const QPalette& colours) const;
    double valueOfPlace(const PlotFrame& frame, QPointF place) const;

    CurvePlotSettings m_settings;
    std::vector<Curve> m_curves;
    std::vector<PlotMark> m_marks;
    double m_cursorX;
    double m_hoverX;
};

} // namespace widgets
