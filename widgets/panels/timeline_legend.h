// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QColor>
#include <QFrame>
#include <QPalette>
#include <QString>

namespace widgets {

/// What a colour of the timeline means.
struct TimelineMeaning {
    QColor colour;
    QString text;
};
/// Of frames in which other people have marks.
QColor othersColour(const QPalette& palette);
std::vector<TimelineMeaning> timelineMeanings(const QPalette& palette);
/// The same as rich text, for tool tips.
QString timelineLegendText(const QPalette& palette);

/// A small popup with the timeline's colours and their meanings.
class TimelineLegend : public QFrame {
    Q_OBJECT

public:
    explicit TimelineLegend(QWidget* parent = nullptr);
};

} // namespace widgets
