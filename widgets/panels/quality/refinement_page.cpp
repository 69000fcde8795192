// SPDX-License-Identifier: MIT
#include "widgets/panels/quality/refinement_page.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/panels/table_style.h"
#include "widgets/text/local_text.h"
#include "widgets/text/rig_text.h"

namespace widgets {

RefinementPage::RefinementPage(RigStudy& rig, CalibrationChoice& calibrations, QWidget* parent)
    : QWidget(parent)
    , m_rig(rig)
    , m_calibrations(calibrations)
    , m_message(new MessageBar(this))
    , m_summary(new QLabel(this))
    , m_table(new QTableView(this))
    , m_model(new RefinementModel(this))
    , m_refine(new QPushButton(tr("Refine"), this))
    , m_progress(new QProgressBar(this))
    , m_stop(new QPushButton(tr("Stop"), this))
    , m_discard(new QPushButton(tr("Discard"), this))
    , m_apply(new QPushButton(tr("Use the refined calibration"), this))
    , m_files(new QListWidget(this))
    , m_use(new QPushButton(tr("Use the chosen one"), this)) {
    build();
    connect(&rig, &RigStudy::changed, this, &RefinementPage::showProposal);
    connect(&rig, &RigStudy::proposalChanged, this, &RefinementPage::showProposal);
    connect(&rig, &RigStudy::refiningChanged, this, &RefinementPage::showRunning);
    connect(&rig, &RigStudy::failed, this, [this](const QString& reason) {
        m_message->setMessage(reason);
        m_summary->setVisible(m_summary->text() != reason);
    });
    connect(&calibrations, &CalibrationChoice::listed, this, &RefinementPage::showFiles);
    connect(&calibrations, &CalibrationChoice::failed, m_message, &MessageBar::setMessage);
    connect(m_refine, &QPushButton::clicked, this, &RefinementPage::refine);
    connect(m_stop, &QPushButton::clicked, &rig, &RigStudy::stop);
    connect(m_discard, &QPushButton::clicked, &rig, &RigStudy::discardProposal);
    connect(m_apply, &QPushButton::clicked, this, &RefinementPage::apply);
    connect(
        m_files, &QListWidget::currentRowChanged, this,
        [this] {
            const QListWidgetItem* chosen = m_files->currentItem();
            m_use->setEnabled(chosen && chosen->data(Qt::UserRole).toString() != m_calibrations.inUse());
        });
    connect(m_use, &QPushButton::clicked, this,
            [this] { m_calibrations.use(m_files->currentItem()->data(Qt::UserRole).toString()); });
    calibrations.list();
    showProposal();
    showRunning();
    showFiles();
}

void RefinementPage::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpacing);
    m_summary->setWordWrap(true);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_table->setModel(m_model);
    styleTable(*m_table);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(RefinementModel::Camera, QHeaderView::ResizeToContents);
    m_table->setMinimumSize(560, 200);
    m_progress->setRange(0, 0);
    m_progress->setTextVisible(false);
    m_refine->setToolTip(tr("Adjusts every camera's place, direction, focal length and first lens coefficients to all "
                            "clicks of the dataset"));
    m_apply->setToolTip(tr("Writes a new calibration file beside the one in use, which is kept; all joints are "
                           "reconstructed anew"));
    m_files->setMaximumHeight(4 * fontMetrics().lineSpacing() + 2 * kSpacing);
    m_use->setToolTip(tr("The dataset uses that calibration from now on; marks stay as they are"));
    for (QPushButton* button : {m_refine, m_stop, m_discard, m_use})
        button->setAutoDefault(false); // Enter must not throw a result away
    auto* title = new QLabel(tr("Calibrations of this dataset"), this);
    title->setBuddy(m_files);
    auto* fileRow = new QHBoxLayout;
    fileRow->addWidget(m_files, 1);
    fileRow->addWidget(m_use, 0, Qt::AlignTop);
    column->addWidget(m_message);
    column->addWidget(m_summary);
    column->addWidget(m_table, 1);
    column->addLayout(makeButtons());
    column->addWidget(title);
    column->addLayout(fileRow);
    column->addStretch(); // takes the table's place while there is none
}

QLayout* RefinementPage::makeButtons() {
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpacing);
    row->addWidget(m_refine);
    row->addWidget(m_progress, 1);
    row->addWidget(m_stop);
    row->addStretch(1);
    row->addWidget(m_discard);
    row->addWidget(m_apply);
    return row;
}

void RefinementPage::refine() {
    m_message->setMessage({});
    m_summary->show();
    m_rig.refine();
}

void RefinementPage::apply() {
    m_message->setMessage({});
    if (m_rig.proposal())
        m_calibrations.add(m_rig.proposal()->refinement.cameras);
    else
        m_message->setMessage(tr("Refine the calibration first."));
}

void RefinementPage::showProposal() {
    const auto& proposal = m_rig.proposal();
    m_model->setChanges(proposal ? proposal->refinement.changes : std::vector<core::CameraRefinement>{});
    m_table->setVisible(proposal != nullptr);
    m_discard->setVisible(proposal != nullptr);
    m_apply->setEnabled(proposal != nullptr);
    if (!proposal) {
        const auto& state = m_rig.state();
        m_summary->setText(state ? refinementNeedsText(state->health, state->needs)
                                 : tr("The clicks of all sequences are being looked at."));
        return;
    }
    const core::RigRefinement& refinement = proposal->refinement;
    m_summary->setText(
        tr("Refined from %1 joints in %2 frames. A click scatters by %3 px per axis about the refined cameras.")
            .arg(QLocale().toString(refinement.joints), QLocale().toString(refinement.frames),
                 localNumber(refinement.sigmaPx, 2)) +
        (refinement.wrongClicks > 0
             ? QLatin1Char(' ') + tr("%n wrong click(s) took no part.", nullptr, refinement.wrongClicks)
             : QString()) +
        (refinement.converged ? QString() : QLatin1Char(' ') + tr("The adjustment stopped before it had settled.")) +
        (proposal->worldSigmaMm ? QLatin1Char(' ') + tr("Distances and shapes will be as good as the clicks; the world "
                                                        "as a whole stays where it was, known to %1 mm.")
                                                         .arg(localNumber(*proposal->worldSigmaMm, 1))
                                : QString()));
}

void RefinementPage::showRunning() {
    const bool isRunning = m_rig.isRefining();
    m_refine->setEnabled(!isRunning);
    m_progress->setVisible(isRunning);
    m_stop->setVisible(isRunning);
}

void RefinementPage::showFiles() {
    m_files->clear();
    for (const QString& file : m_calibrations.files()) {
        const bool isInUse = file == m_calibrations.inUse();
        auto* item = new QListWidgetItem(isInUse ? tr("%1 (in use)").arg(file) : file, m_files);
        item->setData(Qt::UserRole, file);
        if (isInUse)
            m_files->setCurrentItem(item);
    }
    m_use->setEnabled(false);
}

} // namespace widgets
