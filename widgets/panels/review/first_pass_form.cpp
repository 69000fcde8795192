// SPDX-License-Identifier: MIT
#include "widgets/panels/review/first_pass_form.h"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"

namespace widgets {

namespace {

constexpr int kFramesAtFirst = 60; ///< what is chosen before a person chooses: so many frames over the sequence

QSpinBox* frameBox(QWidget* parent) {
    auto* box = new QSpinBox(parent);
    box->setAlignment(Qt::AlignRight);
    box->setFocusPolicy(Qt::ClickFocus);
    return box;
}

} // namespace

FirstPassForm::FirstPassForm(FirstPass& pass, DatasetSession& datasets, JointList& joints, QWidget* parent)
    : QWidget(parent)
    , m_pass(pass)
    , m_datasets(datasets)
    , m_joints(joints)
    , m_message(new MessageBar(this))
    , m_sequence(new QComboBox(this))
    , m_first(frameBox(this))
    , m_last(frameBox(this))
    , m_step(frameBox(this))
    , m_left(new QCheckBox(tr("left"), this))
    , m_right(new QCheckBox(tr("right"), this))
    , m_allJoints(new QCheckBox(tr("all 21 of a hand"), this))
    , m_choice(new QLabel(this))
    , m_start(new QPushButton(tr("Start"), this))
    , m_stop(new QPushButton(tr("Stop"), this))
    , m_close(new QPushButton(tr("Hide"), this))
    , m_progress(new QProgressBar(this)) {
    build();
    connect(&datasets, &DatasetSession::datasetOpened, this, &FirstPassForm::showSequences);
    connect(
        &datasets, &DatasetSession::sequenceOpened, this,
        [this] {
            m_sequence->setCurrentText(QString::fromStdString(m_datasets.sequence()->name));
            if (std::exchange(m_startsWhenOpen, false))
                start();
        });
    connect(&datasets, &DatasetSession::openFailed, this, [this] { m_startsWhenOpen = false; });
    connect(m_sequence, &QComboBox::currentTextChanged, this, &FirstPassForm::takeSequence);
    for (QSpinBox* box : {m_first, m_last, m_step})
        connect(box, qOverload<int>(&QSpinBox::valueChanged), this, &FirstPassForm::showChoice);
    for (QCheckBox* box : {m_left, m_right, m_allJoints})
        connect(box, &QCheckBox::toggled, this, &FirstPassForm::showChoice);
    connect(m_start, &QPushButton::clicked, this, &FirstPassForm::start);
    connect(m_stop, &QPushButton::clicked, &pass, &FirstPass::stop);
    connect(m_close, &QPushButton::clicked, this, &FirstPassForm::closeRequested);
    connect(&pass, &FirstPass::runningChanged, this, &FirstPassForm::showRunning);
    connect(&pass, &FirstPass::failed, m_message, &MessageBar::setMessage);
    connect(&pass, &FirstPass::progressed, this, [this](core::PassStage, int done, int total) {
        m_progress->setRange(0, total);
        m_progress->setValue(done);
    });
    connect(&pass, &FirstPass::finished, this, &FirstPassForm::listProposed);
    connect(&pass, &FirstPass::installed, this, [this](const QString& title) {
        m_message->offer(tr("The hand detector of %1 is installed.").arg(title), {});
        m_saysMissing = false;
        showRunning();
    });
    showSequences();
    showRunning();
}

void FirstPassForm::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpacing);
    m_left->setChecked(true);
    m_right->setChecked(true);
    m_allJoints->setChecked(true);
    m_allJoints->setToolTip(tr("The list of joints follows; otherwise only joints of the list are proposed"));
    m_first->setToolTip(tr("First frame"));
    m_last->setToolTip(tr("Last frame"));
    m_step->setToolTip(tr("Every so many frames"));
    m_start->setToolTip(
        tr("Finds the joints in these frames, in the background; they wait for your look as proposals"));
    m_stop->setToolTip(tr("Keeps the frames that are done; the next start goes on from there"));
    m_choice->setWordWrap(true);
    m_progress->setTextVisible(false);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_sequence, m_left, m_right, m_allJoints, m_start, m_stop, m_close})
        widget->setFocusPolicy(Qt::TabFocus);
    auto* form = new QFormLayout;
    form->setContentsMargins(0, 0, 0, 0);
    form->setSpacing(kSpacing);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form->addRow(tr("Sequence"), m_sequence);
    form->addRow(tr("Frames"), makeFrames());
    auto* hands = new QHBoxLayout;
    hands->addWidget(m_left);
    hands->addWidget(m_right);
    hands->addStretch(1);
    form->addRow(tr("Hands"), hands);
    form->addRow(tr("Joints"), m_allJoints);
    column->addWidget(m_message);
    column->addLayout(form);
    column->addWidget(m_choice);
    column->addLayout(makeButtons());
}

QLayout* FirstPassForm::makeFrames() {
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpacing / 2);
    row->addWidget(m_first, 1);
    row->addWidget(new QLabel(QStringLiteral("\u2013"), this));
    row->addWidget(m_last, 1);
    row->addWidget(new QLabel(tr("every"), this));
    row->addWidget(m_step, 1);
    return row;
}

QLayout* FirstPassForm::makeButtons() {
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpacing);
    row->addWidget(m_start);
    row->addWidget(m_stop);
    row->addWidget(m_progress, 1);
    row->addStretch(0);
    row->addWidget(m_close);
    return row;
}

void FirstPassForm::showSequences() {
    {
        const QSignalBlocker blocker(m_sequence);
        m_sequence->clear();
        if (m_datasets.dataset())
            for (const core::Sequence& sequence : m_datasets.dataset()->sequences)
                m_sequence->addItem(QString::fromStdString(sequence.name));
        if (m_datasets.sequence())
            m_sequence->setCurrentText(QString::fromStdString(m_datasets.sequence()->name));
    }
    takeSequence();
}

/// All of the chosen sequence, in steps that are not too small to begin with.
void FirstPassForm::takeSequence() {
    const int at = m_sequence->currentIndex();
    if (at < 0 || !m_datasets.dataset())
        return;
    const int frames = m_datasets.dataset()->sequences[static_cast<std::size_t>(at)].frameCount;
    setFrames(0, frames - 1, std::max(1, (frames + kFramesAtFirst - 1) / kFramesAtFirst));
}

void FirstPassForm::setFrames(int first, int last, int step) {
    const int at = m_sequence->currentIndex();
    if (at < 0 || !m_datasets.dataset())
        return;
    const int end = std::max(0, m_datasets.dataset()->sequences[static_cast<std::size_t>(at)].frameCount - 1);
    m_first->setRange(0, end);
    m_last->setRange(0, end);
    m_step->setRange(1, end + 1);
    m_first->setValue(first);
    m_last->setValue(last);
    m_step->setValue(step);
    showChoice();
}

FirstPassRequest FirstPassForm::request() const {
    FirstPassRequest request;
    for (int frame = m_first->value(); frame <= m_last->value(); frame += m_step->value())
        request.frames.push_back(frame);
    request.hands.clear();
    if (m_left->isChecked())
        request.hands.insert(core::Side::Left);
    if (m_right->isChecked())
        request.hands.insert(core::Side::Right);
    request.joints = {m_joints.joints().begin(), m_joints.joints().end()};
    if (m_allJoints->isChecked())
        for (const std::string& name : jointNames(JointChoice::TwentyOne, nullptr))
            for (const core::Side side : {core::Side::Left, core::Side::Right})
                request.joints.insert({side, name});
    return request;
}

void FirstPassForm::start() {
    m_message->setMessage({});
    const FirstPassRequest wanted = request();
    if (!m_datasets.dataset() || !m_datasets.sequence()) {
        m_message->setMessage(tr("Open a dataset first."));
    } else if (!m_pass.isInstalled()) {
        showMissing();
    } else if (wanted.frames.empty() || wanted.hands.empty()) {
        m_message->setMessage(wanted.hands.empty() ? tr("Choose a hand.")
                                                   : tr("The last frame comes before the first one."));
    } else if (const QString name = m_sequence->currentText();
               name != QString::fromStdString(m_datasets.sequence()->name)) {
        m_startsWhenOpen = true;
        m_datasets.openSequence(name, m_first->value());
    } else {
        m_pass.run(wanted);
    }
}

/// What was proposed can be seen and corrected: the list of joints grows to it.
void FirstPassForm::listProposed(const FirstPassResult& result) {
    const auto lists = [this](const core::JointId& joint) { return m_joints.contains(joint); };
    if (!m_datasets.dataset() || std::all_of(result.joints.begin(), result.joints.end(), lists))
        return;
    std::vector<std::string> names = jointNames(JointChoice::TwentyOne, nullptr);
    const std::size_t usual = names.size();
    for (const core::JointId& joint : m_joints.joints())
        if (m_joints.choice() == JointChoice::Custom &&
            std::find(names.begin(), names.end(), joint.joint) == names.end())
            names.push_back(joint.joint);
    for (const core::JointId& joint : result.joints)
        if (std::find(names.begin(), names.end(), joint.joint) == names.end())
            names.push_back(joint.joint);
    if (names.size() == usual)
        m_joints.setChoice(JointChoice::TwentyOne, *m_datasets.dataset());
    else
        m_joints.setNames(names, *m_datasets.dataset());
}

void FirstPassForm::showChoice() {
    const auto frames = static_cast<int>(request().frames.size());
    m_choice->setText(frames > 0 ? tr("%n frame(s). Marks that are there already stay.", nullptr, frames)
                                 : tr("The last frame comes before the first one."));
}

void FirstPassForm::showRunning() {
    const bool runs = m_pass.isRunning();
    m_start->setVisible(!runs);
    m_start->setEnabled(!m_pass.isInstalling());
    m_stop->setVisible(runs);
    m_progress->setVisible(runs || m_pass.isInstalling());
    if (!runs)
        m_progress->setRange(0, 0);
    m_close->setVisible(m_isClosable && !runs);
    const bool isMissing = !m_pass.isInstalled();
    if (isMissing && !m_saysMissing)
        showMissing();
    else if (!isMissing && std::exchange(m_saysMissing, false))
        m_message->setMessage({});
}

void FirstPassForm::setClosable(bool closable) {
    m_isClosable = closable;
    m_close->setVisible(closable && !m_pass.isRunning());
}

void FirstPassForm::showMissing() {
    m_saysMissing = true;
    m_message->offer(tr("The hand detector is not installed: get it with \"npm pack @mediapipe/hands\" (11 MB, "
                        "Apache-2.0) and choose the file, or run \"handlens-batch detector install FILE\"."),
                     {{tr("Choose the file..."), [this] { askForPackage(); }}}, MessageBar::Tone::Warning);
}

void FirstPassForm::askForPackage() {
    auto* dialog = new QFileDialog(this, tr("The package @mediapipe/hands"), QDir::homePath());
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Packages (*.tgz)"), tr("All files (*)")});
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, &m_pass, &FirstPass::install);
    dialog->open();
}

} // namespace widgets
