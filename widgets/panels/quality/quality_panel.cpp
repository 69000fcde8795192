// SPDX-License-Identifier: MIT
#include "widgets/panels/quality/quality_panel.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLocale>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/panels/table_style.h"
#include "widgets/presenters/other_marks.h"
#include "widgets/text/local_text.h"
#include "widgets/text/rig_text.h"

namespace widgets {

QualityPanel::QualityPanel(const QualitySources& sources, QWidget* parent)
    : QWidget(parent)
    , m_from(sources)
    , m_rigMessage(new MessageBar(this))
    , m_threshold(new QDoubleSpinBox(this))
    , m_scope(new QComboBox(this))
    , m_summary(new QLabel(this))
    , m_nothing(new QLabel(this))
    , m_table(new QTableView(this))
    , m_model(new FindingModel(this))
    , m_cameras(new RigHealthView(sources.rig, this)) {
    build();
    connect(&m_from.reconstructions, &Reconstructions::changed, this, [this] {
        if (m_scope->currentIndex() == ThisFrame) // the whole sequence is looked at in the background
            refresh();
    });
    connect(&m_from.coverage, &AnnotationCoverage::changed, this, &QualityPanel::refreshSummary);
    connect(&m_from.joints, &JointList::changed, this, &QualityPanel::refreshSummary);
    connect(m_threshold, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double px) {
        m_from.coverage.setBadRmsPx(px);
        emit badRmsPxChanged(px);
        refresh();
    });
    connect(&m_from.checks, &QualityChecks::changed, this, [this] {
        refresh();
        refreshSummary();
    });
    connect(&m_from.rig, &RigStudy::changed, this, &QualityPanel::refreshRig);
    connect(&m_from.rig, &RigStudy::clickSigmasChanged, this, &QualityPanel::refreshSummary);
    connect(m_scope, qOverload<int>(&QComboBox::currentIndexChanged), this, &QualityPanel::refresh);
    connect(m_scope, qOverload<int>(&QComboBox::currentIndexChanged), this, &QualityPanel::refreshRig);
    connect(m_table, &QTableView::clicked, this, &QualityPanel::jump);
    connect(m_cameras, &RigHealthView::refineRequested, this, &QualityPanel::refineRequested);
    connect(m_cameras, &RigHealthView::cameraChosen, &m_from.selection, &Selection::setCamera);
    refresh();
    refreshSummary();
    refreshRig();
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
    m_threshold->setValue(m_from.coverage.badRmsPx());
    m_threshold->setAlignment(Qt::AlignRight);
    m_threshold->setFocusPolicy(Qt::ClickFocus);
    row->addWidget(label);
    row->addWidget(m_threshold);
    row->addStretch(1);
    m_scope->addItems({tr("This frame"), tr("Whole sequence"), tr("Cameras")});
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
    column->addWidget(m_rigMessage);
    column->addWidget(m_summary);
    column->addLayout(row);
    column->addWidget(m_nothing, 1);
    column->addWidget(m_table, 1);
    column->addWidget(m_cameras, 1);
}

void QualityPanel::askForThreshold() {
    m_threshold->setFocus(Qt::ShortcutFocusReason);
    m_threshold->selectAll();
}

std::vector<Finding> QualityPanel::frameFindings() const {
    const int frame = m_from.selection.frame();
    const double bad = m_from.coverage.badRmsPx();
    auto findings = findingsOf(m_from.reconstructions.joints(), frame,
                               bad); // of this moment: clicks that disagree are among them
    for (const core::QualityFinding& found : m_from.checks.findings())
        if (found.frame == frame && found.kind != core::QualityKind::Disagreement)
            findings.push_back(findingOf(found, bad));
    std::stable_sort(findings.begin(), findings.end(),
                     [](const auto& a, const auto& b) { return a.severity > b.severity; });
    return findings;
}

std::vector<Finding> QualityPanel::sequenceFindings() const {
    std::vector<Finding> findings;
    for (const core::QualityFinding& found : m_from.checks.findings())
        findings.push_back(findingOf(found, m_from.coverage.badRmsPx()));
    return findings;
}

void QualityPanel::showCameras() {
    m_scope->setCurrentIndex(Cameras);
}

/// What is wrong with the cameras is said once, whatever the panel shows; the row of cameras says it itself.
void QualityPanel::refreshRig() {
    const auto& state = m_from.rig.state();
    const bool isSaidBelow = m_scope->currentIndex() == Cameras;
    const QString text = state && !isSaidBelow ? rigNoticeText(state->health, state->sequences) : QString();
    if (text == m_rigText) // what was dismissed does not come back by itself
        return;
    m_rigText = text;
    m_rigMessage->offer(text, {{tr("Cameras"), [this] { showCameras(); }}}, MessageBar::Tone::Warning);
}

void QualityPanel::refresh() {
    const bool camerasShown = m_scope->currentIndex() == Cameras;
    const bool wholeSequence = m_scope->currentIndex() == WholeSequence;
    m_cameras->setVisible(camerasShown);
    m_summary->setVisible(!camerasShown);
    if (camerasShown) {
        m_table->hide();
        m_nothing->hide();
        return;
    }
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
    const core::AnnotationSet& set = m_from.document.annotations();
    const auto others = m_from.raters.isRepeating() ? std::vector<core::RaterWork>() : workOfOthers(m_from.document);
    QString text =
        others.empty()
            ? tr("No frame of this sequence has marks yet.")
            : tr("No frame has marks of yours (%1) yet.").arg(QString::fromStdString(m_from.document.rater())) +
                  QLatin1Char(' ') + othersText(others);
    const auto proposals =
        std::count_if(set.marks.begin(), set.marks.end(), [](const auto& item) { return item.second.isProposal(); });
    if (proposals > 0)
        text += QLatin1Char(' ') + tr("%n proposed mark(s) wait to be checked.", nullptr, static_cast<int>(proposals));
    return text;
}

void QualityPanel::refreshSummary() {
    int frames = 0, done = 0, partial = 0, bad = 0;
    for (const auto& [frame, hands] : m_from.coverage.frames()) {
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
        tr("%n frame(s) with marks of %1.", nullptr, frames).arg(QString::fromStdString(m_from.document.rater())) +
        QLatin1Char(' ') +
        tr("Joints: %1 done, %2 partial, %3 bad.")
            .arg(QLocale().toString(done), QLocale().toString(partial), QLocale().toString(bad));
    const core::RaterSigma& sigma = m_from.rig.clickSigmas().of(m_from.document.rater());
    m_summary->setText(text + QLatin1Char(' ') +
                       (sigma.isAssumed
                            ? tr("Too few clicks to know how far yours scatter: 1 px is assumed.")
                            : tr("Your clicks scatter by %1 px per axis.").arg(localNumber(sigma.clickPx, 2))));
}

void QualityPanel::jump(const QModelIndex& index) {
    const Finding found = m_model->finding(index.row());
    m_from.selection.setFrame(found.frame);
    if (!found.joint.joint.empty())
        m_from.selection.setJoint(found.joint);
    if (!found.camera.empty())
        m_from.selection.setCamera(found.camera);
}

} // namespace widgets
