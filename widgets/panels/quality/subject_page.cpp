// SPDX-License-Identifier: MIT
#include "widgets/panels/quality/subject_page.h"

#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/panels/table_style.h"
#include "widgets/text/subject_text.h"

namespace widgets {

SubjectPage::SubjectPage(SubjectStudy& study, QWidget* parent)
    : QWidget(parent)
    , m_study(study)
    , m_message(new MessageBar(this))
    , m_saved(new MessageBar(this))
    , m_sources(new QListWidget(this))
    , m_mostFrames(new QSpinBox(this))
    , m_withMasks(new QCheckBox(tr("Use masks"), this))
    , m_measure(new QPushButton(tr("Measure"), this))
    , m_progress(new QProgressBar(this))
    , m_stage(new QLabel(this))
    , m_stop(new QPushButton(tr("Stop"), this))
    , m_result(new QLabel(this))
    , m_table(new QTableView(this))
    , m_model(new SubjectModel(this))
    , m_save(new QPushButton(tr("Save as a new dataset..."), this)) {
    build();
    connect(&study, &SubjectStudy::sourcesChanged, this, &SubjectPage::showSources);
    connect(&study, &SubjectStudy::measured, this, &SubjectPage::showResult);
    connect(&study, &SubjectStudy::runningChanged, this, &SubjectPage::showRunning);
    connect(&study, &SubjectStudy::failed, m_message, &MessageBar::setMessage);
    connect(
        &study, &SubjectStudy::progressed, this,
        [this](double fraction, const QString& stage) {
            m_progress->setRange(0, fraction < 0 ? 0 : 1000);
            m_progress->setValue(static_cast<int>(1000 * fraction));
            m_stage->setText(stage);
        });
    connect(&study, &SubjectStudy::saved, this, [this](const QString& folder) {
        m_saved->offer(tr("Saved in %1.").arg(QDir::toNativeSeparators(folder)),
                       {{tr("Open"), [this, folder] { emit openRequested(folder); }}});
    });
    connect(m_measure, &QPushButton::clicked, this, &SubjectPage::measure);
    connect(m_stop, &QPushButton::clicked, &study, &SubjectStudy::stop);
    connect(m_save, &QPushButton::clicked, this, &SubjectPage::askWhereToSave);
    showSources();
    showResult();
    study.count();
}

void SubjectPage::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpacing);
    m_sources->setMaximumHeight(5 * fontMetrics().lineSpacing() + 2 * kSpacing);
    m_mostFrames->setRange(core::kFewestSubjectFrames, 100);
    m_mostFrames->setValue(core::SubjectRequest{}.mostFrames);
    m_mostFrames->setAlignment(Qt::AlignRight);
    m_mostFrames->setToolTip(tr("Evenly drawn from the annotated ones; more than 15 bring little and take long"));
    m_withMasks->setChecked(true);
    m_withMasks->setToolTip(tr("Outlines tell the girth; joints alone leave it as the model has it"));
    m_progress->setTextVisible(false);
    m_result->setWordWrap(true);
    m_result->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_table->setModel(m_model);
    styleTable(*m_table);
    m_table->setMinimumSize(480, 180);
    m_table->horizontalHeader()->setSectionResizeMode(SubjectModel::Hand, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(SubjectModel::Bone, QHeaderView::Stretch);
    m_save->setToolTip(tr("A dataset with these hands; footage and masks stay where they are, annotations and motion "
                          "are copied"));
    column->addWidget(m_message);
    column->addWidget(m_saved);
    column->addLayout(makeChoice());
    column->addLayout(makeButtons());
    column->addWidget(m_result);
    column->addWidget(m_table, 1);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(m_save);
    column->addLayout(row);
}

QLayout* SubjectPage::makeChoice() {
    auto* form = new QFormLayout;
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form->addRow(tr("Sequences"), m_sources);
    form->addRow(tr("Frames at most"), m_mostFrames);
    form->addRow(QString(), m_withMasks);
    return form;
}

QLayout* SubjectPage::makeButtons() {
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpacing);
    row->addWidget(m_measure);
    row->addWidget(m_progress, 1);
    row->addWidget(m_stage);
    row->addWidget(m_stop);
    row->addStretch(1);
    return row;
}

core::SubjectRequest SubjectPage::request() const {
    core::SubjectRequest request;
    for (int row = 0; row < m_sources->count(); ++row)
        if (m_sources->item(row)->checkState() == Qt::Checked)
            request.sequences.push_back(m_sources->item(row)->data(Qt::UserRole).toString().toStdString());
    request.mostFrames = m_mostFrames->value();
    request.withoutMasks = !m_withMasks->isChecked();
    return request;
}

void SubjectPage::measure() {
    m_message->setMessage({});
    m_saved->setMessage({});
    if (request().sequences.empty())
        m_message->setMessage(tr("Choose a sequence with annotated frames."));
    else
        m_study.measure(request());
}

void SubjectPage::showSources() {
    m_sources->clear();
    bool anyMasks = false;
    for (const SubjectSource& source : m_study.sources()) {
        auto* item =
            new QListWidgetItem(subjectSourceText(source.sequence, source.annotatedFrames, source.hasMasks), m_sources);
        item->setData(Qt::UserRole, QString::fromStdString(source.sequence));
        const bool isUseful = source.annotatedFrames > 0;
        item->setFlags(isUseful ? Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable : Qt::NoItemFlags);
        item->setCheckState(isUseful ? Qt::Checked : Qt::Unchecked);
        anyMasks = anyMasks || (isUseful && source.hasMasks);
    }
    m_withMasks->setEnabled(anyMasks);
    showRunning();
    if (m_study.sources().empty()) // of another dataset
        m_study.count();
}

void SubjectPage::showResult() {
    const auto& measured = m_study.result();
    std::vector<std::pair<core::Side, core::SubjectHand>> hands;
    for (std::size_t h = 0; measured && h < measured->result.hands.size(); ++h)
        hands.emplace_back(measured->dataset.hands[h].side, measured->result.hands[h]);
    m_model->setHands(hands);
    m_table->setVisible(!hands.empty());
    m_save->setEnabled(measured != nullptr);
    m_result->setText(measured ? subjectResultText(*measured)
                               : tr("Bone lengths, scale and girth of this person's hands are found from annotated "
                                    "frames: at least %1, from 5 on every bone by itself.")
                                     .arg(core::kFewestSubjectFrames));
}

void SubjectPage::showRunning() {
    const bool isMeasuring = m_study.isMeasuring();
    m_measure->setEnabled(!isMeasuring && m_study.dataset());
    for (QWidget* widget : std::initializer_list<QWidget*>{m_progress, m_stage, m_stop})
        widget->setVisible(isMeasuring);
    if (!isMeasuring)
        m_progress->setRange(0, 0);
    m_save->setEnabled(m_study.result() && !isMeasuring && !m_study.isSaving());
}

void SubjectPage::askWhereToSave() {
    auto* dialog = new QFileDialog(this, tr("A new folder for the dataset"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setFileMode(QFileDialog::AnyFile);
    dialog->setLabelText(QFileDialog::Accept, tr("Save"));
    const std::filesystem::path& folder = m_study.dataset()->folder;
    dialog->setDirectory(QString::fromStdString(folder.parent_path().string()));
    dialog->selectFile(QString::fromStdString(folder.filename().string() + "-subject"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        m_message->setMessage({});
        m_study.save(path);
    });
    dialog->open();
}

} // namespace widgets
