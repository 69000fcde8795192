// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QColor>
#include <QSize>
#include <QString>
#include <QStringList>
#include <QWidget>

namespace widgets {

/// A sample and what it stands for.
struct LegendEntry {
    enum class Sample { Line, Box, Hatch, Dot, Scale };
    Sample sample = Sample::Line;
    QString text;
    QColor colour = {};
    Qt::PenStyle line = Qt::SolidLine;
    std::vector<QColor> scale = {}; ///< colours from the scale's least to its greatest value
    bool operator==(const LegendEntry&) const = default;
};

/// Entries side by side, in as many lines as they need. Hidden without entries, unless it keeps its place.
class LegendStrip : public QWidget {
    Q_OBJECT
public:
    explicit LegendStrip(QWidget* parent = nullptr);

    void setEntries(const std::vector<LegendEntry>& entries);
    /// Stays as high as a line without entries, and as two lines where it is wide: nothing beside it moves when entries
    /// appear that fit there.
    void keepPlace();
    const std::vector<LegendEntry>& entries() const { return m_entries; }
    QStringList texts() const;
    /// The entries in dark ink on white ground, in as many lines as that width takes, from (0, 0).
    void paintOnPaper(QPainter& painter, int width) const;
    int heightOnPaper(int width) const;

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintEntries(QPainter& painter, int width, const QPalette& colours) const;
    int lineHeight() const;
    /// Where each entry stands in that width.
    std::vector<QRect> places(int width) const;

    std::vector<LegendEntry> m_entries;
    bool m_keepsPlace = false;
};

} // namespace widgets
