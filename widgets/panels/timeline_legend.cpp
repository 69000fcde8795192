// SPDX-License-Identifier: MIT
#include "widgets/panels/timeline_legend.h"

#include <QGridLayout>
#include <QLabel>
#include <QPixmap>

#include "widgets/panels/state_colours.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr int kSwatch = 12; // logical pixels

constexpr LocalText legendText{"widgets::TimelineLegend"};

QString lanesText() {
    return legendText(QT_TRANSLATE_NOOP(
        "widgets::TimelineLegend",
        "Upper lane: left hand. Lower lane: right hand. The fuller a bar, the more joints have marks."));
}

} // namespace

QColor othersColour(const QPalette& palette) {
    return mixed(palette.color(QPalette::Window), palette.color(QPalette::WindowText), 0.6);
}

std::vector<TimelineMeaning> timelineMeanings(const QPalette& palette) {
    return {
        {kDoneColour, legendText(QT_TRANSLATE_NOOP("widgets::TimelineLegend", "every joint is done"))},
        {kPartialColour, legendText(QT_TRANSLATE_NOOP("widgets::TimelineLegend", "some joints have marks"))},
        {kBadColour, legendText(QT_TRANSLATE_NOOP("widgets::TimelineLegend",
                                                  "a joint is bad: large error, outlier, or no 3D point"))},
        {kOccludedColour, legendText(QT_TRANSLATE_NOOP("widgets::TimelineLegend",
                                                       "at its foot: a joint is occluded, its place estimated"))},
        {kProposedColour,
         legendText(QT_TRANSLATE_NOOP("widgets::TimelineLegend", "stripes: proposed by a program, waits for a look"))},
        {kDoubtfulColour, legendText(QT_TRANSLATE_NOOP("widgets::TimelineLegend", "stripes: the same, and doubtful"))},
        {othersColour(palette),
         legendText(QT_TRANSLATE_NOOP("widgets::TimelineLegend", "between the lanes: marks of other people"))},
        {palette.color(QPalette::WindowText),
         legendText(QT_TRANSLATE_NOOP("widgets::TimelineLegend", "tick above: a note"))},
        {palette.color(QPalette::Highlight),
         legendText(QT_TRANSLATE_NOOP("widgets::TimelineLegend",
                                      "tick below: a test frame of the benchmark; the line: the current frame"))}};
}

QString timelineLegendText(const QPalette& palette) {
    QString rows;
    for (const TimelineMeaning& meaning : timelineMeanings(palette))
        rows += QStringLiteral("<tr><td bgcolor='%1'>&nbsp;&nbsp;&nbsp;</td><td>&nbsp;%2</td></tr>")
                    .arg(meaning.colour.name(), meaning.text.toHtmlEscaped());
    return QStringLiteral("<p>%1</p><table cellspacing='2'>%2</table>").arg(lanesText().toHtmlEscaped(), rows);
}

TimelineLegend::TimelineLegend(QWidget* parent)
    : QFrame(parent, Qt::Popup) {
    setFrameShape(QFrame::StyledPanel);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(2 * kSpacing, 2 * kSpacing, 2 * kSpacing, 2 * kSpacing);
    grid->setSpacing(kSpacing);
    int row = 0;
    for (const TimelineMeaning& meaning : timelineMeanings(palette())) {
        QPixmap swatch(kSwatch, kSwatch);
        swatch.fill(meaning.colour);
        auto* colour = new QLabel(this);
        colour->setPixmap(swatch);
        grid->addWidget(colour, row, 0);
        grid->addWidget(new QLabel(meaning.text, this), row++, 1);
    }
    auto* lanes = new QLabel(lanesText(), this);
    lanes->setWordWrap(true);
    grid->addWidget(lanes, row, 0, 1, 2);
}

} // namespace widgets
