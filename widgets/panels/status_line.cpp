// SPDX-License-Identifier: MIT
#include "widgets/panels/status_line.h"

#include <algorithm>
#include <cmath>

#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLocale>

#include "widgets/panels/state_colours.h"
#include "widgets/text/advice.h"
#include "widgets/text/error_text.h"

namespace widgets {

namespace {

constexpr int kBriefMs = 4000;
constexpr int kClockMs = 1000;

QFont bold(QFont font) {
    font.setBold(true);
    return font;
}

QString agoText(qint64 seconds) {
    if (seconds < 60)
        return StatusLine::tr("saved %n s ago", nullptr, static_cast<int>(seconds));
    if (seconds < 3600)
        return StatusLine::tr("saved %n min ago", nullptr, static_cast<int>(seconds / 60));
    return StatusLine::tr("saved %n h ago", nullptr, static_cast<int>(seconds / 3600));
}

} // namespace

StatusLine::StatusLine(const AnnotationDocument& document, const Reconstructions& reconstructions,
                       const Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_reconstructions(reconstructions)
    , m_selection(selection)
    , m_summary(new QLabel(this))
    , m_advice(new QLabel(this))
    , m_notice(new QToolButton(this))
    , m_work(new QLabel(this))
    , m_progress(new QProgressBar(this))
    , m_stop(new QToolButton(this))
    , m_saved(new QLabel(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kSpacing, 2, kSpacing, 2);
    row->setSpacing(2 * kSpacing);
    row->addWidget(m_summary);
    row->addWidget(m_advice, 1);
    row->addWidget(m_notice);
    row->addWidget(m_work);
    row->addWidget(m_progress);
    row->addWidget(m_stop);
    row->addWidget(m_saved);
    m_advice->setMinimumWidth(120);
    m_advice->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_progress->setMaximumWidth(140);
    m_progress->setTextVisible(false);
    m_stop->setObjectName(QStringLiteral("stop"));
    m_notice->setObjectName(QStringLiteral("notice"));
    m_notice->setAutoRaise(true);
    m_notice->setFocusPolicy(Qt::NoFocus);
    m_notice->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_notice->setIcon(QIcon::fromTheme(QStringLiteral("dialog-warning")));
    m_notice->hide();
    m_stop->setText(tr("Stop"));
    m_stop->setFocusPolicy(Qt::NoFocus);
    m_summary->setFont(bold(font()));
    m_brief.setSingleShot(true);
    m_brief.setInterval(kBriefMs);
    m_clock.setInterval(kClockMs);
    m_clock.start();
    connect(&m_brief, &QTimer::timeout, this, [this] {
        m_briefText.clear();
        refresh();
    });
    connect(&m_clock, &QTimer::timeout, this, &StatusLine::refreshSaved);
    connect(m_stop, &QToolButton::clicked, this, &StatusLine::stopRequested);
    connect(m_notice, &QToolButton::clicked, this, &StatusLine::noticeClicked);
    connect(&m_reconstructions, &Reconstructions::changed, this, &StatusLine::refresh);
    for (const auto news : {&AnnotationDocument::opened, &AnnotationDocument::saved, &AnnotationDocument::busyChanged,
                            &AnnotationDocument::busyProgressed})
        connect(&m_document, news, this, &StatusLine::refreshSaved);
    connect(&m_document, &AnnotationDocument::saveFailed, this, &StatusLine::refreshSaved);
    hideWork();
    refresh();
    refreshSaved();
}

void StatusLine::sayBriefly(const QString& text) {
    m_briefText = withoutDetail(text);
    m_brief.start();
    refresh();
    emit said(m_briefText);
}

void StatusLine::setIdleText(const QString& text) {
    m_idleText = text;
    refresh();
}

void StatusLine::setNotice(const QString& text) {
    constexpr int kWidest = 320; // logical pixels
    m_notice->setText(m_notice->fontMetrics().elidedText(text, Qt::ElideRight, kWidest));
    m_notice->setToolTip(text);
    m_notice->setAccessibleName(text);
    m_notice->setVisible(!text.isEmpty());
}

void StatusLine::setWords(const QString& summary, const QString& advice) {
    m_workSummary = summary;
    m_workAdvice = advice;
    refresh();
}

void StatusLine::refresh() {
    if (!m_document.isOpen()) {
        m_summary->clear();
        m_advice->setText(m_briefText.isEmpty() ? m_idleText : m_briefText);
        return;
    }
    if (!m_workSummary.isEmpty() || !m_workAdvice.isEmpty()) {
        const QString text = m_briefText.isEmpty() ? m_workAdvice : m_briefText;
        m_summary->setText(m_workSummary);
        m_advice->setText(text);
        m_advice->setToolTip(text);
        return;
    }
    const auto& found = m_reconstructions.selected();
    m_summary->setText(summaryText(m_selection.joint(), found));
    m_summary->setToolTip(placedInWords(found));
    const QString advice = m_briefText.isEmpty() ? adviceText(m_selection.joint(), found) : m_briefText;
    m_advice->setText(advice);
    m_advice->setToolTip(advice);
}

void StatusLine::refreshSaved() {
    QPalette colours = palette();
    QString text;
    if (m_document.isBusy()) {
        constexpr double kMost = 0.99; // the last bit is the transaction's end
        text = tr("saving, %1 %").arg(QLocale().toString(int(100 * std::min(kMost, m_document.busyShare()))));
        colours.setColor(QPalette::WindowText, kPartialColour);
    } else if (m_document.isOpen() && m_document.hasUnsaved()) {
        text = tr("NOT SAVED");
        colours.setColor(QPalette::WindowText, kBadColour);
    } else if (m_document.isOpen() && m_document.isReadOnly()) {
        text = tr("read-only");
        colours.setColor(QPalette::WindowText, kPartialColour);
    } else if (m_document.lastSaved().isValid()) {
        text = agoText(m_document.lastSaved().secsTo(QDateTime::currentDateTimeUtc()));
    } else if (m_document.isOpen()) {
        text = tr("saved");
    }
    m_saved->setPalette(colours);
    m_saved->setText(text);
}

void StatusLine::showWork(const QString& name, double fraction) {
    if (!m_progress->isVisible() || fraction <= 0)
        m_workTime.restart();
    QString text = name;
    if (fraction > 0.05) {
        const double secondsLeft = static_cast<double>(m_workTime.elapsed()) / 1000 * (1 - fraction) / fraction;
        constexpr double kManySeconds = 120;
        text += secondsLeft < kManySeconds
                    ? tr(", %n s left", nullptr, static_cast<int>(secondsLeft + 0.5))
                    : tr(", %n min left", nullptr, static_cast<int>(std::lround(secondsLeft / 60)));
    }
    m_work->setText(text);
    m_progress->setRange(0, fraction < 0 ? 0 : 1000);
    m_progress->setValue(static_cast<int>(fraction * 1000));
    for (QWidget* widget : std::initializer_list<QWidget*>{m_work, m_progress, m_stop})
        widget->show();
}

void StatusLine::hideWork() {
    for (QWidget* widget : std::initializer_list<QWidget*>{m_work, m_progress, m_stop})
        widget->hide();
}

} // namespace widgets
