// SPDX-License-Identifier: MIT
#include "widgets/panels/raters_panel.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/panels/table_style.h"
#include "widgets/text/edit_text.h"
#include "widgets/text/local_text.h"

namespace widgets {

RatersPanel::RatersPanel(RaterStudy& study, const Selection& selection, const Reconstructions& reconstructions,
                         const DatasetSession& datasets, QWidget* parent)
    : QWidget(parent)
    , m_study(study)
    , m_selection(selection)
    , m_reconstructions(reconstructions)
    , m_message(new MessageBar(this))
    , m_pairs(new QComboBox(this))
    , m_clicks(new QLabel(this))
    , m_table(new QTableView(this))
    , m_model(new AgreementModel(this))
    , m_nothing(new QLabel(this))
    , m_consensus(new QLabel(this))
    , m_round(new QLabel(this))
    , m_next(new QPushButton(tr("Next"), this))
    , m_begin(new QPushButton(this))
    , m_compare(new QPushButton(tr("Compare"), this)) {
    build();
    connect(&study, &RaterStudy::compared, this, &RatersPanel::showComparisons);
    connect(&datasets, &DatasetSession::sequenceOpened, this, &RatersPanel::compareIfShown);
    connect(&study, &RaterStudy::roundChanged, this, &RatersPanel::showRound);
    connect(&study, &RaterStudy::failed, m_message, &MessageBar::setMessage);
    connect(&reconstructions, &Reconstructions::changed, this, &RatersPanel::showConsensus);
    connect(m_pairs, qOverload<int>(&QComboBox::currentIndexChanged), this, &RatersPanel::showPair);
    connect(m_begin, &QPushButton::clicked, this, &RatersPanel::roundRequested);
    connect(m_next, &QPushButton::clicked, this, &RatersPanel::nextTaskRequested);
    showComparisons();
    showRound();
}

void RatersPanel::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpacing, kSpacing, kSpacing, kSpacing);
    column->setSpacing(kSpacing);
    for (QLabel* label : {m_clicks, m_nothing, m_consensus, m_round})
        label->setWordWrap(true);
    QPalette quiet = palette();
    quiet.setColor(QPalette::WindowText, quietTextColour(quiet));
    m_nothing->setPalette(quiet);
    m_nothing->setAlignment(Qt::AlignCenter);
    m_table->setModel(m_model);
    styleTable(*m_table);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_table, m_pairs, m_next, m_begin, m_compare})
        widget->setFocusPolicy(Qt::NoFocus);
    m_compare->setToolTip(tr("Compares all raters as they stand now"));
    connect(m_compare, &QPushButton::clicked, this, [this] { m_study.compare(); });
    auto* pairRow = new QHBoxLayout;
    pairRow->addWidget(m_pairs, 1);
    pairRow->addStretch(0);
    pairRow->addWidget(m_compare);
    auto* roundRow = new QHBoxLayout;
    roundRow->addWidget(m_round, 1);
    roundRow->addWidget(m_next);
    roundRow->addWidget(m_begin);
    column->addWidget(m_message);
    column->addLayout(pairRow);
    column->addWidget(m_clicks);
    column->addWidget(m_nothing, 1);
    column->addWidget(m_table, 1);
    column->addWidget(m_consensus);
    column->addLayout(roundRow);
}

void RatersPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    compareIfShown();
    showConsensus();
}

void RatersPanel::compareIfShown() {
    if (isVisible())
        m_study.compare();
}

void RatersPanel::showComparisons() {
    m_message->setMessage({});
    {
        const QSignalBlocker blocker(m_pairs);
        const QString before = m_pairs->currentText();
        m_pairs->clear();
        for (const core::RaterComparison& pair : m_study.comparisons())
            m_pairs->addItem(QStringLiteral("%1 \u2013 %2")
                                 .arg(QString::fromStdString(pair.first), QString::fromStdString(pair.second)));
        m_pairs->setCurrentIndex(std::max(0, m_pairs->findText(before)));
    }
    m_pairs->setEnabled(m_pairs->count() > 1);
    m_pairs->setVisible(m_pairs->count() > 0);
    showPair();
    showConsensus();
}

void RatersPanel::showPair() {
    const auto& comparisons = m_study.comparisons();
    const int index = m_pairs->currentIndex();
    const bool any = index >= 0 && index < static_cast<int>(comparisons.size());
    m_table->setVisible(any);
    m_nothing->setVisible(!any);
    m_clicks->setVisible(any);
    m_model->setComparison(any ? std::optional(comparisons[static_cast<std::size_t>(index)]) : std::nullopt);
    if (!any)
        return;
    const core::RaterComparison& pair = comparisons[static_cast<std::size_t>(index)];
    QStringList parts{
        tr("%n shared click(s), %1 px apart (RMS)", nullptr, pair.clicks).arg(localNumber(pair.clickRmsPx, 2))};
    for (const std::string& rater : {pair.first, pair.second}) {
        const core::RaterSigma& sigma = m_study.clickSigmas().of(rater);
        const QString name = QString::fromStdString(rater);
        parts << (sigma.isAssumed ? tr("%1 has too few clicks to know how far they scatter").arg(name)
                                  : tr("%1 scatters by %2 px per axis").arg(name, localNumber(sigma.clickPx, 2)));
    }
    m_clicks->setText(parts.join(QStringLiteral("; ")));
}

void RatersPanel::showConsensus() {
    if (!isVisible())
        return;
    const core::Consensus all = m_study.consensus();
    m_consensus->setVisible(all.result.point.has_value());
    if (!all.result.point)
        return;
    QString text =
        tr("All raters together: %1 \u00b1 %2 mm, from %n click(s).", nullptr, static_cast<int>(all.clicks.size()))
            .arg(jointText(m_selection.joint()), localNumber(core::sigmaMm(all.result.point->covariance), 2));
    const auto& own = m_reconstructions.selected().result.point;
    if (own)
        text +=
            QLatin1Char(' ') + tr("Your 3D joint lies %1 mm from it.")
                                   .arg(localNumber((own->pointInWorld - all.result.point->pointInWorld).norm(), 2));
    m_consensus->setText(text);
}

void RatersPanel::showRound() {
    const bool repeating = m_study.isRepeating();
    m_begin->setText(repeating ? tr("End the round") : tr("Start a repeat round"));
    m_begin->setToolTip(
        repeating
            ? tr("Back to your own marks; both rounds are compared")
            : tr("A random tenth of your finished joints, your first marks hidden: how well do you repeat yourself?"));
    m_next->setVisible(repeating);
    m_compare->setEnabled(!repeating);
    m_nothing->setText(repeating ? tr("Your first marks are hidden until the round has ended.")
                                 : tr("No two raters have marked the same joint. Start a repeat round to see how far "
                                      "you agree with yourself."));
    m_next->setToolTip(tr("To the next joint of the round that is not marked yet"));
    showConsensus();
    m_round->setText(repeating ? tr("Repeat round: %1 of %2 joints are left.")
                                     .arg(QLocale().toString(m_study.openTasks()), QLocale().toString(m_study.tasks()))
                               : QString());
}

} // namespace widgets
