// SPDX-License-Identifier: MIT
#include "widgets/workspaces/inspect_picture.h"

#include <algorithm>
#include <set>
#include <vector>

#include <QFontMetricsF>
#include <QPainter>

#include "widgets/panels/state_colours.h"

namespace widgets {

namespace {

constexpr double kGap = 8; ///< between parts, logical pixels
constexpr double kPlotHeight = 230;
const QColor kInk(0x20, 0x22, 0x25);
const QColor kQuietInk(0x60, 0x64, 0x6A);

/// Puts the parts of a figure below each other.
class FigureMaker {
public:
    explicit FigureMaker(const InspectPage& page)
        : m_page(page)
        , m_font(page.font())
        , m_line(QFontMetricsF(m_font).height()) {
        m_picture.title = pairText(page);
        m_picture.size.setWidth(page.grid()->width() + 2 * kGap);
    }

    PagePicture make() {
        addText({kGap, m_y, m_picture.size.width() - 2 * kGap, m_line}, pairText(m_page), {}, m_page.iterationText());
        m_y += m_line + kGap;
        addTrial();
        addViews();
        addPlots();
        addLegend();
        m_picture.size.setHeight(m_y);
        return m_picture;
    }

private:
    void addText(const QRectF& place, const QString& left, const QColor& chip, const QString& right) {
        m_picture.parts.push_back({place,
                                   [=, font = m_font, size = place.size()](QPainter& painter, double) {
                                       QRectF area(QPointF(0, 0), size);
                                       painter.setFont(font);
                                       painter.setPen(kInk);
                                       if (chip.isValid()) {
                                           const double side = size.height() - 6;
                                           painter.fillRect(QRectF(0, 3, side, side), chip);
                                           area.setLeft(side + kSpacing);
                                       }
                                       const QFontMetricsF metrics(font);
                                       const double room = area.width() - metrics.horizontalAdvance(right) - kSpacing;
                                       painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter,
                                                        metrics.elidedText(left, Qt::ElideMiddle, room));
                                       painter.setPen(kQuietInk);
                                       painter.drawText(area, Qt::AlignRight | Qt::AlignVCenter, right);
                                   }});
    }

    /// What is tried, in as many lines as it takes: the numbers below are of nothing else.
    void addTrial() {
        const QString text = m_page.trialText();
        if (text.isEmpty())
            return;
        const double width = m_picture.size.width() - 2 * kGap;
        const double height =
            QFontMetricsF(m_font).boundingRect(QRectF(0, 0, width, 1000), Qt::TextWordWrap, text).height();
        m_picture.parts.push_back(
            {{kGap, m_y, width, height},
             [text, font = m_font, area = QRectF(0, 0, width, height)](QPainter& painter, double) {
                 painter.setFont(font);
                 painter.setPen(kInk);
                 painter.drawText(area, Qt::TextWordWrap, text);
             }});
        m_y += height + kGap;
    }

    /// Of the layers that are drawn; below all that stays where it is while iterations go by.
    void addLegend() {
        const LegendStrip* legend = &m_page.layerBar()->legend();
        const int width = static_cast<int>(m_picture.size.width() - 2 * kGap);
        const int height = legend->heightOnPaper(width);
        if (height == 0)
            return;
        m_picture.parts.push_back({QRectF(kGap, m_y, width, height), [legend, width](QPainter& painter, double) {
                                       legend->paintOnPaper(painter, width);
                                   }});
        m_y += height + kGap;
    }

    QString numbersOf(int index) const {
        const ViewTitle& title = m_page.grid()->view(index)->title();
        return QStringList{title.detail, m_page.views()->errorText(m_page.views()->columnOf(index)), title.error}
            .join(QStringLiteral("  "))
            .trimmed();
    }

    /// Whether the names of views have room beside their numbers.
    bool fitsOneLine(const std::vector<int>& views) const {
        const QFontMetricsF metrics(m_font);
        return std::all_of(views.begin(), views.end(), [&](int index) {
            const CameraView* view = m_page.grid()->view(index);
            return m_line + 3 * kSpacing + metrics.horizontalAdvance(view->title().name) +
                       metrics.horizontalAdvance(numbersOf(index)) <=
                   view->viewport()->width();
        });
    }

    /// Each view where it stands in the grid, its title in the room above it: name and numbers side by side or, where
    /// they are too long, below each other; then rows move apart.
    void addViews() {
        const CameraGrid* grid = m_page.grid();
        std::vector<int> views;
        std::set<int> rows; // their upper edges
        for (int index = 0; index < grid->count(); ++index) {
            if (!grid->view(index)->isVisible())
                continue;
            views.push_back(index);
            rows.insert(grid->view(index)->y());
        }
        const bool isOneLine = fitsOneLine(views);
        double bottom = m_y;
        for (const int index : views) {
            const CameraView* view = grid->view(index);
            const auto row = std::distance(rows.begin(), rows.find(view->y()));
            const double apart = isOneLine ? 0 : m_line * static_cast<double>(row + 1);
            const QPointF corner = view->viewport()->mapTo(grid, QPoint(0, 0)) + QPointF(kGap, m_y + apart);
            const QSizeF size = view->viewport()->size(), line(size.width() - kSpacing, m_line);
            const QPointF above(0, m_line);
            addText({corner - (isOneLine ? above : 2 * above), line}, view->title().name, view->title().colour,
                    isOneLine ? numbersOf(index) : QString());
            if (!isOneLine)
                addText({corner - above, line}, {}, {}, numbersOf(index));
            m_picture.parts.push_back({QRectF(corner, size), [view](QPainter& painter, double scale) {
                                           view->paintPicture(painter, scale);
                                       }});
            bottom = std::max(bottom, corner.y() + size.height());
        }
        m_y = bottom + kGap;
    }

    void addPlots() {
        const double width = (m_picture.size.width() - 3 * kGap) / 2;
        double x = kGap;
        for (const CurvePlot* plot : {m_page.errorPlot(), m_page.costPlot()}) {
            const QSizeF size(width, kPlotHeight);
            m_picture.parts.push_back({QRectF(QPointF(x, m_y), size), [plot, size](QPainter& painter, double) {
                                           plot->paintOnPaper(painter, QRectF(QPointF(0, 0), size));
                                       }});
            x += width + kGap;
        }
        m_y += kPlotHeight + kGap;
    }

    const InspectPage& m_page;
    QFont m_font;
    double m_line;
    PagePicture m_picture;
    double m_y = kGap;
};

} // namespace

QString pairText(const InspectPage& page) {
    const auto& outcome = page.columns()->outcome();
    return outcome ? QString::fromStdString(outcome->sequence) + QStringLiteral(": ") + page.heading() : QString();
}

PagePicture comparisonPicture(const InspectPage& page) {
    return FigureMaker(page).make();
}

PictureSource comparisonSource(const InspectPage& page) {
    PictureSource source;
    source.fileName = page.heading();
    source.image = [&page](double scale) { return pageImage(comparisonPicture(page), scale); };
    source.saveSvg = [&page](const QString& path) { return savePageSvg(comparisonPicture(page), path); };
    source.savePdf = [&page](const QString& path) { return savePagePdf(comparisonPicture(page), path); };
    return source;
}

} // namespace widgets
