// SPDX-License-Identifier: MIT
#include "widgets/panels/benchmark_page.h"

#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include "core/benchmark/metrics.h"
#include "core/error.h"
#include "core/fitting/method_name.h"
#include "widgets/panels/state_colours.h"
#include "widgets/panels/table_style.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

constexpr double kCurveStepMm = 0.1;
constexpr double kCurveMaxMm = 10;

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    return label;
}

/// Frames in which somebody clicked a joint in two views: as a rule it has a 3D point.
std::vector<int> framesWithPoints(const core::AnnotationSet& set) {
    std::set<int> frames;
    std::map<std::tuple<int, std::string, core::JointId>, int> clicks;
    for (const auto& [key, mark] : set.marks) {
        if (mark.isEvidence() && ++clicks[{key.frame, key.rater, key.joint}] == 2)
            frames.insert(key.frame);
    }
    return {frames.begin(), frames.end()};
}

} // namespace

BenchmarkPage::BenchmarkPage(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(workbench), m_message(new MessageBar(this)), m_sequences(new QListWidget(this)),
      m_setup(new QComboBox(this)), m_percent(new QDoubleSpinBox(this)), m_differences(new QLineEdit(QStringLiteral("1, 5, 10, 15"), this)), m_seed(new QSpinBox(this)),
      m_run(new QPushButton(this)), m_progress(new QProgressBar(this)), m_summary(new SummaryModel(this)),
      m_summaryTable(new QTableView(this)), m_pairs(new PairTableModel(this)), m_sortedPairs(new QSortFilterProxyModel(this)),
      m_pairTable(new QTableView(this)), m_curves(new CurvePlot(this)), m_jointMethod(new QComboBox(this)),
      m_jointErrors(new JointErrorDiagram(this)) {
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

QWidget* BenchmarkPage::makeSettings() {
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setSpacing(kSpacing);
    column->addWidget(heading(tr("Methods"), side));
    for (const std::string& name : core::plainMethodNames()) {
        auto* box = new QCheckBox(QString::fromStdString(name), side);
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
    m_setup->addItems({tr("Synthetic"), tr("Realistic")});
    m_setup->setToolTip(tr("Synthetic: silhouettes of the recorded poses, errors over all joints. Realistic: mask files, errors over the marked joints."));
    m_setup->setFocusPolicy(Qt::NoFocus);
    form->addRow(tr("Setup"), m_setup);
    form->addRow(tr("Test"), m_percent);
    form->addRow(tr("Frames apart"), m_differences);
    form->addRow(tr("Seed"), m_seed);
    column->addLayout(form);
    column->addWidget(m_run);
    column->addWidget(m_progress);
    for (QWidget* field : std::initializer_list<QWidget*>{m_percent, m_differences, m_seed})
        field->setFocusPolicy(Qt::ClickFocus);
    m_run->setFocusPolicy(Qt::NoFocus);
    connect(m_run, &QPushButton::clicked, this, &BenchmarkPage::runOrStop);
    connect(m_percent, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &BenchmarkPage::drawChanged);
    connect(m_seed, qOverload<int>(&QSpinBox::valueChanged), this, &BenchmarkPage::drawChanged);
    connect(m_differences, &QLineEdit::textChanged, this, &BenchmarkPage::drawChanged);
    connect(m_setup, qOverload<int>(&QComboBox::currentIndexChanged), this, &BenchmarkPage::drawChanged);
    connect(&m_workbench.coverage, &Coverage::changed, this, [this] {
        if (setup() == core::BenchmarkSetup::Realistic)
            emit drawChanged();
    });
    return side;
}

QWidget* BenchmarkPage::makeResults() {
    m_summaryTable->setModel(m_summary);
    m_sortedPairs->setSourceModel(m_pairs);
    m_sortedPairs->setSortRole(PairTableModel::ValueRole);
    m_pairTable->setModel(m_sortedPairs);
    for (QTableView* table : {m_summaryTable, m_pairTable}) {
        styleTable(*table);
        table->setFocusPolicy(Qt::NoFocus);
    }
    m_pairTable->setSortingEnabled(true);
    m_pairTable->setToolTip(tr("Double-click a pair to inspect it"));
    m_curves->setSettings({tr("Share of pairs below each error"), tr("Error, mm"), tr("Pairs, %"), 0, kCurveMaxMm, 0, 100, false,
                           tr("Run the benchmark to compare the methods.")});
    auto* joints = new QWidget(this);
    auto* jointColumn = new QVBoxLayout(joints);
    auto* jointRow = new QHBoxLayout;
    m_jointMethod->setFocusPolicy(Qt::NoFocus);
    jointRow->addWidget(heading(tr("Error per joint"), joints), 1);
    jointRow->addWidget(m_jointMethod);
    jointColumn->addLayout(jointRow);
    jointColumn->addWidget(m_jointErrors, 1);
    connect(m_jointMethod, qOverload<int>(&QComboBox::currentIndexChanged), this, &BenchmarkPage::showJointErrors);
    auto* pictures = new QSplitter(Qt::Horizontal, this);
    pictures->addWidget(m_curves);
    pictures->addWidget(joints);
    pictures->setStretchFactor(0, 2);
    pictures->setStretchFactor(1, 1);
    auto* rows = new QSplitter(Qt::Vertical, this);
    rows->addWidget(m_summaryTable);
    rows->addWidget(pictures);
    rows->addWidget(m_pairTable);
    rows->setStretchFactor(1, 2);
    rows->setStretchFactor(2, 1);
    for (QSplitter* splitter : {pictures, rows})
        splitter->setChildrenCollapsible(false);
    connect(m_pairTable, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
        const core::PairResult& pair = m_pairs->pair(m_sortedPairs->mapToSource(index).row());
        const FitTarget target = m_workbench.benchmarks.setup() == core::BenchmarkSetup::Realistic ? FitTarget::Masks : FitTarget::Recorded;
        emit pairOpened(QString::fromStdString(pair.pair.sequence), {pair.pair.start, pair.pair.test, {pair.method}, target});
    });
    return rows;
}

void BenchmarkPage::connectRunner() {
    BenchmarkRunner& runner = m_workbench.benchmarks;
    connect(&m_workbench.session, &DatasetSession::datasetOpened, this, &BenchmarkPage::takeDataset);
    connect(&runner, &BenchmarkRunner::started, this, [this] {
        m_message->setMessage({});
        showRunning(true);
    });
    connect(&runner, &BenchmarkRunner::progressed, this, [this](double fraction, const QString& text) {
        m_progress->setValue(static_cast<int>(fraction * 1000));
        m_progress->setFormat(text);
    });
    connect(&runner, &BenchmarkRunner::finished, this, [this] {
        showRunning(false);
        takeResults();
    });
    connect(&runner, &BenchmarkRunner::cleared, this, [this] {
        showRunning(false);
        takeResults();
    });
    connect(&runner, &BenchmarkRunner::failed, this, [this](const QString& message) {
        showRunning(false);
        m_message->setMessage(message);
    });
}

core::PairOptions BenchmarkPage::pairOptions() const {
    core::PairOptions options;
    options.fraction = m_percent->value() / 100;
    options.seed = static_cast<std::uint64_t>(m_seed->value());
    options.differences.clear();
    for (const QString& part : m_differences->text().split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        bool isNumber = false;
        options.differences.push_back(part.trimmed().toInt(&isNumber));
        if (!isNumber)
            throw core::Error(core::ErrorCode::Usage, {}, {}, tr("\u201c%1\u201d is not a number of frames.").arg(part.trimmed()).toStdString());
    }
    return options;
}

core::BenchmarkSetup BenchmarkPage::setup() const {
    return m_setup->currentIndex() == 1 ? core::BenchmarkSetup::Realistic : core::BenchmarkSetup::Synthetic;
}

std::set<int> BenchmarkPage::testFrames() const {
    const core::Sequence* sequence = m_workbench.session.sequence();
    if (!sequence)
        return {};
    core::PairFrames frames{sequence->name, {}};
    if (setup() == core::BenchmarkSetup::Realistic) {
        frames.frames = framesWithPoints(m_workbench.document.annotations());
    } else {
        frames.frames.resize(static_cast<std::size_t>(sequence->frameCount));
        std::iota(frames.frames.begin(), frames.frames.end(), 0);
    }
    std::set<int> tests;
    try {
        for (const core::FramePair& pair : core::drawPairs({frames}, pairOptions()))
            tests.insert(pair.test);
    } catch (const core::Error&) { // half typed
    }
    return tests;
}

BenchmarkRequest BenchmarkPage::request() const {
    BenchmarkRequest request;
    for (int row = 0; row < m_sequences->count(); ++row) {
        if (m_sequences->item(row)->checkState() == Qt::Checked)
            request.sequences.push_back(m_sequences->item(row)->text().toStdString());
    }
    for (const QCheckBox* box : m_methods) {
        if (box->isChecked())
            request.methods.push_back(box->text().toStdString());
    }
    request.pairs = pairOptions();
    request.setup = setup();
    if (request.methods.empty() || request.sequences.empty())
        throw core::Error(core::ErrorCode::Usage, {}, {}, tr("Choose at least one method and one sequence.").toStdString());
    return request;
}

void BenchmarkPage::runOrStop() {
    if (m_workbench.benchmarks.isRunning()) {
        m_workbench.benchmarks.stop();
        return;
    }
    try {
        m_workbench.benchmarks.run(request());
    } catch (const core::Error& error) {
        m_message->setMessage(QString::fromUtf8(error.what()));
    }
}

void BenchmarkPage::showRunning(bool running) {
    m_run->setText(running ? tr("Stop") : tr("Run"));
    m_progress->setVisible(running);
    m_progress->setRange(0, 1000);
    if (running)
        m_progress->setValue(0);
}

void BenchmarkPage::takeDataset() {
    m_sequences->clear();
    for (const core::Sequence& sequence : m_workbench.session.dataset()->sequences) {
        auto* item = new QListWidgetItem(QString::fromStdString(sequence.name), m_sequences);
        item->setCheckState(sequence.motion.empty() ? Qt::Unchecked : Qt::Checked);
        if (sequence.motion.empty())
            item->setFlags(Qt::NoItemFlags);
    }
}

void BenchmarkPage::takeResults() {
    const auto& results = m_workbench.benchmarks.results();
    m_summary->setResults(results);
    m_pairs->setResults(results);
    m_pairTable->sortByColumn(PairTableModel::ErrorMm, Qt::DescendingOrder);
    m_summaryTable->setVisible(results != nullptr);
    m_pairTable->setVisible(results != nullptr);
    std::vector<Curve> curves;
    {
        const QSignalBlocker blocker(m_jointMethod);
        m_jointMethod->clear();
        if (results) {
            for (const core::ErrorCurve& found : core::errorCurves(*results, kCurveStepMm, kCurveMaxMm)) {
                const bool isStart = found.method == "initial";
                Curve curve{isStart ? tr("start") : QString::fromStdString(found.method), methodColour(isStart ? "start" : found.method), isStart, false, {}};
                for (std::size_t i = 0; i < found.thresholdsMm.size(); ++i)
                    curve.points.emplace_back(found.thresholdsMm[i], 100 * found.share[i]);
                curves.push_back(std::move(curve));
            }
            for (const std::string& method : results->methods)
                m_jointMethod->addItem(QString::fromStdString(method));
        }
    }
    m_jointMethod->setVisible(m_jointMethod->count() > 0);
    m_curves->setCurves(curves);
    showJointErrors();
}

void BenchmarkPage::showJointErrors() {
    const auto& results = m_workbench.benchmarks.results();
    std::vector<JointError> errors;
    if (results && m_jointMethod->currentIndex() >= 0) {
        const auto means = core::meanJointErrorsMm(*results, m_jointMethod->currentText().toStdString());
        for (std::size_t i = 0; i < results->joints.size() && i < means.size(); ++i)
            errors.push_back({results->joints[i], means[i]});
    }
    m_jointErrors->setErrors(errors);
}

} // namespace widgets
