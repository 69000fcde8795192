// SPDX-License-Identifier: MIT
#include "widgets/workspaces/inspect_probe_card.h"

#include <cmath>
#include <numbers>

#include <QHBoxLayout>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/text/edit_text.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

constexpr int kLeastWidth = 400; ///< of the table, which is wider where there is room

QString numberOrDash(double value, int decimals) {
    return std::isnan(value) ? QStringLiteral("\u2013") : QLocale().toString(value, 'f', decimals);
}

QString degreesText(double rad) {
    return numberOrDash(rad * 180 / std::numbers::pi, 0) + QStringLiteral("\u00b0");
}

QString pointText(QPointF px) {
    return InspectProbeCard::tr("(%1, %2)", "x and y; told apart where the decimal point is a comma, too")
        .arg(numberOrDash(px.x(), 1), numberOrDash(px.y(), 1));
}

/// A square of the method's colour.
QString chip(const std::string& method) {
    return QStringLiteral("<span style=\"color: %1\">\u25a0</span> ").arg(methodColour(method).name());
}

/// Where the card is narrow, heads and the last column are broken into lines.
QString htmlRow(const QStringList& cells, const char* tag) {
    const bool isHead = QLatin1String(tag) == QLatin1String("th");
    QString row = QStringLiteral("<tr>");
    for (int i = 0; i < cells.size(); ++i) {
        const bool isLast = i + 1 == cells.size();
        row += QStringLiteral("<%1 align=\"%2\" style=\"padding: 1px 6px; white-space: %3\">%4</%1>")
                   .arg(QLatin1String(tag), i == 0 || isLast ? QStringLiteral("left") : QStringLiteral("right"),
                        isHead || isLast ? QStringLiteral("normal") : QStringLiteral("nowrap"), cells[i]);
    }
    return row + QStringLiteral("</tr>");
}

} // namespace

InspectProbeCard::InspectProbeCard(QWidget* parent)
    : QFrame(parent)
    , m_heading(new QLabel(this))
    , m_table(new QLabel(this)) {
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    auto* close = new QToolButton(this);
    close->setText(QStringLiteral("\u00d7"));
    close->setAutoRaise(true);
    close->setFocusPolicy(Qt::NoFocus);
    close->setToolTip(tr("Take the pin away (or click the point once more)"));
    close->setAccessibleName(tr("Take the pin away"));
    connect(close, &QToolButton::clicked, this, &InspectProbeCard::closed);
    auto* head = new QHBoxLayout;
    head->addWidget(m_heading, 1);
    head->addWidget(close);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpacing, kSpacing / 2, kSpacing / 2, kSpacing / 2);
    column->setSpacing(0);
    column->addLayout(head);
    column->addWidget(m_table);
    column->addStretch(1);
    m_table->setTextFormat(Qt::RichText);
    m_table->setWordWrap(true);
    m_table->setToolTip(
        tr("What each method would take for the rim point of the pinned view, which looks in the direction "
           "above. The arrows of other columns start at rim points of their own, which may look "
           "elsewhere."));
    m_table->setMinimumWidth(kLeastWidth);
    m_heading->setWordWrap(true);
    hide();
}

void InspectProbeCard::showProbe(const QString& camera, const InspectProbe& probe) {
    QString heading = tr("%1 %2, direction %3").arg(camera, pointText(probe.px), degreesText(probe.angleRad));
    if (probe.rim)
        heading = tr("%1: %2").arg(jointText(*probe.rim), heading);
    m_heading->setText(heading);
    QString table =
        QStringLiteral("<table cellspacing=\"0\">") + htmlRow({tr("Method"), tr("Nearest, px"), tr("Distance, px"),
                                                               tr("Direction"), tr("Bin"), tr("Cost, px"), tr("Match")},
                                                              "th");
    const QString none = QStringLiteral("\u2013");
    for (const ProbeRow& row : probe.rows) {
        const QString at = row.found() ? pointText(row.contourPx) : none;
        table += htmlRow({chip(row.method) + QString::fromStdString(row.method).toHtmlEscaped(), at,
                          row.found() ? numberOrDash(row.probe.distancePx, 1) : none,
                          row.found() ? degreesText(row.contourAngleRad) : none,
                          row.bins > 1 ? QString::number(row.probe.bin) : none,
                          row.found() ? numberOrDash(row.probe.cost, 1) : none,
                          row.kept() ? tr("kept") : verdictInWords(row.probe.verdict)},
                         "td");
    }
    m_table->setText(table + QStringLiteral("</table>"));
    show();
}

} // namespace widgets
