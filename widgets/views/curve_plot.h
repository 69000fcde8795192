// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QString>
#include <QWidget>

class QMenu;

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

/// Line plot: error curves, convergence. Reads out the curves under the pointer; saves itself as PNG and SVG.
class CurvePlot : public QWidget {
    Q_OBJECT
public:
    explicit CurvePlot(QWidget* parent = nullptr);

    void setSettings(const CurvePlotSettings& settings);
    void setCurves(const std::vector<Curve>& curves);
    bool isLogarithmic() const { return m_settings.yLogarithmic; }
    void setLogarithmic(bool on);
    /// A vertical line, such as the iteration that is shown; NaN for none.
    void setCursor(double x);

    QImage grabPicture(double scale = 1) const;
    bool saveSvg(const QString& path) const;
    void addPictureActions(QMenu& menu);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// The plot was clicked at this x.
    void xClicked(double x);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    struct Frame;
    Frame frame(const QRectF& area) const;
    void paint(QPainter& painter, const QRectF& area, const QPalette& colours) const;
    void paintAxes(QPainter& painter, const Frame& frame, const QPalette& colours) const;
    void paintCurves(QPainter& painter, const Frame& frame, const QPalette& colours) const;
    void paintLegend(QPainter& painter, const Frame& frame, const QPalette& colours) const;
    void paintReadout(QPainter& painter, const Frame& frame) const;

    CurvePlotSettings m_settings;
    std::vector<Curve> m_curves;
    double valueOfPlace(const Frame& frame, QPointF place) const;

    double m_cursorX;
    double m_hoverX;
};

} // namespace widgets
