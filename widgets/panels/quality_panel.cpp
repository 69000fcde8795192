// SPDX-License-Identifier: MIT
#include "widgets/panels/quality_panel.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLocale>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/panels/table_style.h"
#include "widgets/presenters/other_marks.h"

namespace widgets {

QualityPanel::QualityPanel(WindowSession& session, QWidget* parent)
    : QWidget(parent)
    , m_session(session)
    , m_threshold(new QDoubleSpinBox(this))
    , m_scope(new QComboBox(this))
    , m_summary(new QLabel(this))
    , m_nothing(new QLabel(this))
    , m_table(new QTableView(this))
    , m_model(new FindingModel(this)) {
    build();
    connect(&session.reconstructions, &Reconstructions::changed, this, [this] {
        if (m_scope->currentIndex() == 0) // the whole sequence is looked at in the background
            refresh();
    });
    connect(&session.coverage, &Coverage::changed, this, &QualityPanel::refreshSummary);
    connect(&session.joints, &JointList::changed, this, &QualityPanel::refreshSummary);
    connect(m_threshold, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double px) {
        m_session.coverage.setBadRmsPx(px);
        emit badRmsPxChanged(px);
        refresh();
    });
    connect(&session.checks, &QualityChecks::changed, this, [this] {
        refresh();
        refreshSummary();
    });
    connect(m_scope, qOverload<int>(&QComboBox::currentIndexChanged), this, &QualityPanel::refresh);
    connect(m_table, &QTableView::clicked, this, &QualityPanel::jump);
    refresh();
    refreshSummary();
}

void QualityPanel::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpacing, kSpacing, kSpacing, kSpacing);
    column->setSpacing(kSpacing);
    m_summary->setWordWrap(true);
    auto* row = new QHBoxLayout;
    auto* label = new QLabel(tr("Bad above"), this);
    label->setBuddy(m_threshold);
    m_threshold->setRange(0.1, 50);
    m_threshold->setSingleStep(0.5);
    m_threshold->setDecimals(1);
    m_threshold->setSuffix(tr(" px"));
    m_threshold->setValue(m_session.coverage.badRmsPx());
    m_threshold->setAlignment(Qt::AlignRight);
    m_threshold->setFocusPolicy(Qt::ClickFocus);
    row->addWidget(label);
    row->addWidget(m_threshold);
    row->addStretch(1);
    m_scope->addItems({tr("This frame"), tr("Whole sequence")});
    m_scope->setToolTip(tr("Where to look for findings"));
    m_scope->setFocusPolicy(Qt::TabFocus);
    row->addWidget(m_scope);
    QPalette quiet = palette();
    quiet.setColor(QPalette::WindowText, quietTextColour(quiet));
    m_nothing->setPalette(quiet);
    m_nothing->setAlignment(Qt::AlignCenter);
    m_nothing->setWordWrap(true);
    m_table->setModel(m_model);
    styleTable(*m_table);
    m_table->setFocusPolicy(Qt::NoFocus);
    column->addWidget(m_summary);
    column->addLayout(row);
    column->addWidget(m_nothing, 1);
    column->addWidget(m_table, 1);
}

void QualityPanel::askForThreshold() {
    m_threshold->setFocus(Qt::ShortcutFocusReason);
    m_threshold->selectAll();
}

std::vector<Finding> QualityPanel::frameFindings() const {
    const int frame = m_session.selection.frame();
    const double bad = m_session.coverage.badRmsPx();
    auto findings = findingsOf(m_session.reconstructions.joints(), frame,
                               bad); // of this moment: clicks that disagree are among them
    for (const core::QualityFinding& found : m_session.checks.findings())
        if (found.frame == frame && found.kind != core::QualityKind::Disagreement)
            findings.push_back(findingOf(found, bad));
    std::stable_sort(findings.begin(), findings.end(),
                     [](const auto& a, const auto& b) { return a.severity > b.severity; });
    return findings;
}

std::vector<Finding> QualityPanel::sequenceFindings() const {
    std::vector<Finding> findings;
    for (const core::QualityFinding& found : m_session.checks.findings())
        findings.push_back(findingOf(found, m_session.coverage.badRmsPx()));
    return findings;
}

void QualityPanel::refresh() {
    const bool wholeSequence = m_scope->currentIndex() == 1;
    m_model->setFindings(wholeSequence ? sequenceFindings() : frameFindings());
    m_table->setColumnHidden(FindingModel::Frame, !wholeSequence);
    m_nothing->setText(wholeSequence ? tr("Nothing stands out in this sequence.")
                                     : tr("Nothing stands out in this frame."));
    const bool any = m_model->rowCount() > 0;
    m_table->setVisible(any);
    m_nothing->setVisible(!any);
}

/// What stands for the numbers while the rater has no marks: others may have some, and proposals may wait.
QString QualityPanel::nothingText() const {
    const core::AnnotationSet& set = m_session.document.annotations();
    const auto others =
        m_session.raters.isRepeating() ? std::vector<core::RaterWork>() : workOfOthers(m_session.document);
    QString text =
        others.empty()
            ? tr("No frame of this sequence has marks yet.")
            : tr("No frame has marks of yours (%1) yet.").arg(QString::fromStdString(m_session.document.rater())) +
                  QLatin1Char(' ') + othersText(others);
    const auto proposals =
        std::count_if(set.marks.begin(), set.marks.end(), [](const auto& item) { return item.second.isProposal(); });
    if (proposals > 0)
        text += QLatin1Char(' ') + tr("%n proposed mark(s) wait to be checked.", nullptr, static_cast<int>(proposals));
    return text;
}

void QualityPanel::refreshSummary() {
    int frames = 0, done = 0, partial = 0, bad = 0;
    for (const auto& [frame, hands] : m_session.coverage.frames()) {
        const int before = done + partial + bad;
        for (const auto& [hand, state] : hands) {
            done += state.done;
            partial += state.partial;
            bad += state.bad;
        }
        frames += done + partial + bad > before; // proposals alone do not count as marks
    }
    if (frames == 0) {
        m_summary->setText(nothingText());
        return;
    }
    QString text =
        tr("%n frame(s) with marks of %1.", nullptr, frames).arg(QString::fromStdString(m_session.document.rater())) +
        QLatin1Char(' ') +
        tr("Joints: %1 done, %2 partial, %3 bad.")
            .arg(QLocale().toString(done), QLocale().toString(partial), QLocale().toString(bad));
    if (const auto& noise = m_session.checks.clickNoise())
        text += QLatin1Char(' ') +
                tr("Your clicks scatter by %1 px per axis.").arg(QLocale().toString(noise->sigmaPx, 'f', 2));
    m_summary->setText(text);
}

void QualityPanel::jump(const QModelIndex& index) {
    const Finding found = m_model->finding(index.row());
    m_session.selection.setFrame(found.frame);
    if (!found.joint.joint.empty())
        m_session.selection.setJoint(found.joint);
    if (!found.camera.empty())
        m_session.selection.setCamera(found.camera);
}

} // namespace widgets
