// SPDX-License-Identifier: MIT
#include "widgets/workspaces/benchmark_page.h"

#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QSplitter>
#include <QVBoxLayout>

#include "core/error.h"
#include "core/fitting/method_name.h"
#include "widgets/panels/state_colours.h"
#include "widgets/text/local_text.h"
#include "widgets/views/method_chip.h"

namespace widgets {

namespace {

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    return label;
}

/// Frames with a joint that is clicked in two views: as a rule it has a 3D point.
std::vector<int> framesWithPoints(const core::AnnotationSet& set) {
    std::set<int> frames;
    std::map<std::tuple<int, std::string, core::JointId>, int> clicks;
    for (const auto& [key, mark] : set.marks)
        if (mark.isEvidence() && ++clicks[{key.frame, key.rater, key.joint}] == 2)
            frames.insert(key.frame);
    return {frames.begin(), frames.end()};
}

} // namespace

BenchmarkPage::BenchmarkPage(BenchmarkRunner& runner, const DatasetSession& datasets,
                             const AnnotationDocument& document, const AnnotationCoverage& coverage, QWidget* parent)
    : QWidget(parent)
    , m_runner(runner)
    , m_datasets(datasets)
    , m_document(document)
    , m_coverage(coverage)
    , m_message(new MessageBar(this))
    , m_sequences(new QListWidget(this))
    , m_setup(new QComboBox(this))
    , m_percent(new QDoubleSpinBox(this))
    , m_differences(new QLineEdit(QStringLiteral("1, 5, 10, 15"), this))
    , m_seed(new QSpinBox(this))
    , m_run(new QPushButton(this))
    , m_progress(new QProgressBar(this))
    , m_save(new QPushButton(tr("Save results..."), this))
    , m_open(new QPushButton(tr("Open results..."), this))
    , m_shownRow(new QWidget(this))
    , m_shown(new QComboBox(this))
    , m_agreement(new QLabel(this))
    , m_results(new BenchmarkResultsView(this)) {
    auto* splitter = new QSplitter(Qt::Horizontal, this);
    splitter->addWidget(makeSettings());
    splitter->addWidget(makeResults());
    splitter->setStretchFactor(1, 1);
    splitter->setChildrenCollapsible(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_message);
    column->addWidget(splitter, 1);
    connectRunner();
    showRunning(false);
    takeResults();
}

QWidget* BenchmarkPage::makeResults() {
    auto* side = new QWidget(this);
    auto* row = new QHBoxLayout(m_shownRow);
    row->setContentsMargins(kSpacing, kSpacing, kSpacing, 0);
    m_shown->setFocusPolicy(Qt::NoFocus);
    m_shown->setToolTip(tr("Which setup the tables and curves below are of"));
    m_agreement->setToolTip(tr("Kendall's tau of the methods' mean errors: 1 is the same order, 0 says nothing, -1 is "
                               "the reverse; in brackets what 95 % of drawings of these pairs give"));
    m_agreement->setWordWrap(true);
    row->addWidget(m_shown);
    row->addWidget(m_agreement, 1);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_shownRow);
    column->addWidget(m_results, 1);
    connect(m_shown, qOverload<int>(&QComboBox::activated), this,
            [this](int index) { m_runner.show(static_cast<core::BenchmarkSetup>(m_shown->itemData(index).toInt())); });
    return side;
}

QWidget* BenchmarkPage::makeSettings() {
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setSpacing(kSpacing);
    column->addWidget(heading(tr("Methods"), side));
    for (const std::string& name : core::plainMethodNames()) {
        auto* box = new QCheckBox(QString::fromStdString(name), side);
        box->setIcon(methodChip(name));
        box->setChecked(true);
        box->setFocusPolicy(Qt::NoFocus);
        m_methods.push_back(box);
        column->addWidget(box);
    }
    column->addWidget(heading(tr("Sequences"), side));
    m_sequences->setFocusPolicy(Qt::NoFocus);
    m_sequences->setSelectionMode(QAbstractItemView::NoSelection);
    column->addWidget(m_sequences, 1);
    auto* form = new QFormLayout;
    m_percent->setRange(0.1, 100);
    m_percent->setValue(2);
    m_percent->setDecimals(1);
    m_percent->setSuffix(tr(" % of frames"));
    m_seed->setRange(0, 1000000);
    m_seed->setValue(7);
    m_setup->addItems({tr("Synthetic"), tr("Realistic"), tr("Both")});
    m_setup->setToolTip(tr("Synthetic: silhouettes of the recorded poses, errors over all joints. Realistic: mask "
                           "files, errors over the marked joints. Both: one after the other, side by side in one "
                           "report."));
    m_setup->setFocusPolicy(Qt::NoFocus);
    form->addRow(tr("Setup"), m_setup);
    form->addRow(tr("Test"), m_percent);
    form->addRow(tr("Frames apart"), m_differences);
    form->addRow(tr("Seed"), m_seed);
    column->addLayout(form);
    column->addWidget(m_run);
    column->addWidget(m_progress);
    column->addLayout(makeFileRow());
    for (QWidget* field : std::initializer_list<QWidget*>{m_percent, m_differences, m_seed})
        field->setFocusPolicy(Qt::ClickFocus);
    m_run->setFocusPolicy(Qt::NoFocus);
    connect(m_run, &QPushButton::clicked, this, &BenchmarkPage::runOrStop);
    connect(m_percent, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &BenchmarkPage::drawChanged);
    connect(m_seed, qOverload<int>(&QSpinBox::valueChanged), this, &BenchmarkPage::drawChanged);
    connect(m_differences, &QLineEdit::textChanged, this, &BenchmarkPage::drawChanged);
    connect(m_setup, qOverload<int>(&QComboBox::currentIndexChanged), this, &BenchmarkPage::drawChanged);
    connect(&m_coverage, &AnnotationCoverage::changed, this, [this] {
        if (drawsAnnotatedFrames())
            emit drawChanged();
    });
    return side;
}

QLayout* BenchmarkPage::makeFileRow() {
    auto* row = new QHBoxLayout;
    m_save->setToolTip(tr("Tables, pairs and a report, as handlens-batch benchmark writes them"));
    m_open->setToolTip(tr("A folder that was saved here or written by handlens-batch benchmark"));
    for (QPushButton* button : {m_save, m_open}) {
        button->setFocusPolicy(Qt::NoFocus);
        row->addWidget(button);
    }
    connect(m_save, &QPushButton::clicked, this, &BenchmarkPage::askToSave);
    connect(m_open, &QPushButton::clicked, this, &BenchmarkPage::askToOpen);
    return row;
}

void BenchmarkPage::connectRunner() {
    connect(&m_datasets, &DatasetSession::datasetOpened, this, &BenchmarkPage::takeDataset);
    connect(&m_runner, &BenchmarkRunner::started, this, [this] {
        m_message->setMessage({});
        showRunning(true);
    });
    connect(&m_runner, &BenchmarkRunner::progressed, this, [this](double fraction, const QString& text) {
        m_progress->setValue(static_cast<int>(fraction * 1000));
        m_progress->setFormat(text);
    });
    connect(&m_runner, &BenchmarkRunner::updated, this, &BenchmarkPage::takeResults);
    connect(&m_runner, &BenchmarkRunner::finished, this, [this] { showRunning(false); });
    connect(&m_runner, &BenchmarkRunner::cleared, this, [this] {
        showRunning(false);
        m_message->setMessage({});
    });
    connect(&m_runner, &BenchmarkRunner::opened, this, [this](const QString& folder, const QString& note) {
        const QString from = tr("Results of %1; the settings on the left are those of the next run.")
                                 .arg(QDir::toNativeSeparators(folder));
        if (note.isEmpty())
            m_message->offer(from, {});
        else
            m_message->setMessage(from + QLatin1Char(' ') + note);
    });
    connect(&m_runner, &BenchmarkRunner::saved, this, &BenchmarkPage::offerReport);
    connect(&m_runner, &BenchmarkRunner::fileFailed, m_message, &MessageBar::setMessage);
    connect(m_results, &BenchmarkResultsView::pairOpened, this,
            [this](const core::FramePair& pair, const std::vector<std::string>& methods) {
                const FitTarget target =
                    m_runner.setup() == core::BenchmarkSetup::Realistic ? FitTarget::Masks : FitTarget::Recorded;
                emit pairOpened(QString::fromStdString(pair.sequence), {pair.start, pair.test, methods, target});
            });
    connect(m_results, &BenchmarkResultsView::runRequested, this, &BenchmarkPage::runPairs);
    connect(&m_runner, &BenchmarkRunner::failed, this, [this](const QString& message) {
        showRunning(false);
        m_message->setMessage(message);
    });
}

/// The first part that is not a number of frames.
std::optional<QString> BenchmarkPage::wrongDifference() const {
    for (const QString& part : m_differences->text().split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        bool isNumber = false;
        part.trimmed().toInt(&isNumber);
        if (!isNumber)
            return part.trimmed();
    }
    return std::nullopt;
}

/// Parts that are not a number are left out.
core::PairOptions BenchmarkPage::pairOptions() const {
    core::PairOptions options;
    options.fraction = m_percent->value() / 100;
    options.seed = static_cast<std::uint64_t>(m_seed->value());
    options.differences.clear();
    for (const QString& part : m_differences->text().split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        bool isNumber = false;
        const int difference = part.trimmed().toInt(&isNumber);
        if (isNumber)
            options.differences.push_back(difference);
    }
    return options;
}

/// Of both setups, the frames of the timeline are those of the synthetic one, which come first.
bool BenchmarkPage::drawsAnnotatedFrames() const {
    return m_setup->currentIndex() == 1;
}

std::set<int> BenchmarkPage::testFrames() const {
    const core::Sequence* sequence = m_datasets.sequence();
    if (!sequence)
        return {};
    core::PairFrames frames{sequence->name, {}};
    if (drawsAnnotatedFrames()) {
        frames.frames = framesWithPoints(m_document.annotations());
    } else {
        frames.frames.resize(static_cast<std::size_t>(sequence->frameCount));
        std::iota(frames.frames.begin(), frames.frames.end(), 0);
    }
    std::set<int> tests;
    if (wrongDifference()) // half typed
        return tests;
    try {
        for (const core::FramePair& pair : core::drawPairs({frames}, pairOptions()))
            tests.insert(pair.test);
    } catch (const core::Error&) { // out of range
    }
    return tests;
}

BenchmarkRequest BenchmarkPage::request() const {
    BenchmarkRequest request;
    for (int row = 0; row < m_sequences->count(); ++row)
        if (m_sequences->item(row)->checkState() == Qt::Checked)
            request.sequences.push_back(m_sequences->item(row)->text().toStdString());
    for (const QCheckBox* box : m_methods)
        if (box->isChecked())
            request.methods.push_back(box->text().toStdString());
    request.pairs = pairOptions();
    if (m_setup->currentIndex() != 0)
        request.setups.push_back(core::BenchmarkSetup::Realistic);
    if (drawsAnnotatedFrames())
        request.setups.erase(request.setups.begin());
    return request;
}

QString BenchmarkPage::objection(const BenchmarkRequest& request) const {
    if (const auto wrong = wrongDifference())
        return tr("\u201c%1\u201d is not a number of frames.").arg(*wrong);
    if (request.methods.empty() || request.sequences.empty())
        return tr("Choose at least one method and one sequence.");
    return {};
}

void BenchmarkPage::runOrStop() {
    if (m_runner.isRunning()) {
        m_runner.stop();
        return;
    }
    const BenchmarkRequest wanted = request();
    if (const QString why = objection(wanted); !why.isEmpty())
        m_message->setMessage(why);
    else
        m_runner.run(wanted);
}

void BenchmarkPage::runPairs(const std::vector<core::FramePair>& pairs) {
    BenchmarkRequest wanted = request();
    wanted.framePairs = pairs;
    if (m_runner.isRunning())
        m_message->setMessage(tr("Stop the benchmark first."));
    else if (wanted.methods.empty())
        m_message->setMessage(tr("Choose at least one method."));
    else
        m_runner.run(wanted);
}

void BenchmarkPage::runSelectedPairs() {
    if (m_results->pairs()->selected().empty())
        m_message->setMessage(tr("Select pairs in the table first."));
    else
        m_results->pairs()->runSelected();
}

void BenchmarkPage::showRunning(bool running) {
    m_run->setText(running ? tr("Stop") : tr("Run"));
    m_progress->setVisible(running);
    m_open->setEnabled(!running);
    m_progress->setRange(0, 1000);
    if (running)
        m_progress->setValue(0);
}

void BenchmarkPage::takeDataset() {
    m_sequences->clear();
    for (const core::Sequence& sequence : m_datasets.dataset()->sequences) {
        auto* item = new QListWidgetItem(QString::fromStdString(sequence.name), m_sequences);
        item->setCheckState(sequence.motion.empty() ? Qt::Unchecked : Qt::Checked);
        if (sequence.motion.empty())
            item->setFlags(Qt::NoItemFlags);
    }
}

void BenchmarkPage::takeResults() {
    showSetups();
    m_results->setResults(m_runner.results(), m_runner.digest());
    m_save->setEnabled(m_runner.results() != nullptr);
}

/// A choice of setups where there are results of both, and how far they agree.
void BenchmarkPage::showSetups() {
    const std::vector<core::BenchmarkSetup> setups = m_runner.setups();
    if (m_shown->count() != static_cast<int>(setups.size())) {
        m_shown->clear();
        for (const core::BenchmarkSetup setup : setups)
            m_shown->addItem(setup == core::BenchmarkSetup::Synthetic ? tr("Synthetic") : tr("Realistic"),
                             static_cast<int>(setup));
    }
    m_shown->setCurrentIndex(m_shown->findData(static_cast<int>(m_runner.setup())));
    m_shownRow->setVisible(setups.size() > 1);
    const auto agreement = m_runner.agreement();
    m_agreement->setText(agreement ? tr("Order of the methods in both setups: tau %1 (%2 to %3)")
                                         .arg(localNumber(agreement->tau, 2), localNumber(agreement->low, 2),
                                              localNumber(agreement->high, 2))
                                   : QString());
}

void BenchmarkPage::offerReport(const QString& folder) {
    m_message->offer(tr("The results are saved in %1.").arg(QDir::toNativeSeparators(folder)),
                     {{tr("Show the report"),
                       [this, folder] { emit reportWanted(QDir(folder).filePath(QStringLiteral("report.html"))); }}});
}

void BenchmarkPage::askToSave() {
    chooseFolder(
        tr("Save the results in a folder"), [this](const QString& folder) { m_runner.save(folder); });
}

void BenchmarkPage::askToOpen() {
    chooseFolder(
        tr("Open the results of a folder"), [this](const QString& folder) { m_runner.open(folder); });
}

void BenchmarkPage::chooseFolder(const QString& title, const std::function<void(const QString&)>& take) {
    auto* dialog = new QFileDialog(this, title, m_lastFolder.isEmpty() ? QDir::homePath() : m_lastFolder);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this, [this, take](const QString& folder) {
        m_lastFolder = folder;
        m_message->setMessage({});
        take(folder);
    });
    dialog->open();
}

} // namespace widgets
