// SPDX-License-Identifier: MIT
#include "widgets/workspaces/benchmark_results_view.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabBar>
#include <QVBoxLayout>

#include "core/benchmark/figures.h"
#include "widgets/panels/table_style.h"
#include "widgets/views/joint_colours.h"
#include "widgets/views/method_chip.h"

namespace widgets {

namespace {

constexpr double kCurveMaxMm = 10;
constexpr int kSummaryRows = 9; ///< that are always in sight, if there are as many

} // namespace

BenchmarkResultsView::BenchmarkResultsView(QWidget* parent)
    : QWidget(parent)
    , m_summary(new SummaryModel(this))
    , m_summaryTable(new QTableView(this))
    , m_pairs(new BenchmarkPairsView(this))
    , m_pictures(new QTabWidget(this))
    , m_pairPlots(new BenchmarkPairPlots(this))
    , m_curves(new CurvePlot(this))
    , m_jointMethod(new QComboBox(this))
    , m_jointErrors(new JointErrorDiagram(this)) {
    m_summaryTable->setObjectName(QStringLiteral("benchmarkSummary"));
    m_summaryTable->setModel(m_summary);
    m_summaryTable->setItemDelegateForColumn(0, new MethodDelegate(SummaryModel::ValueRole, m_summaryTable));
    styleTable(*m_summaryTable);
    m_summaryTable->setFocusPolicy(Qt::NoFocus);
    auto* rows = new QSplitter(Qt::Vertical, this);
    rows->addWidget(m_summaryTable);
    rows->addWidget(makePictures());
    rows->addWidget(m_pairs);
    rows->setStretchFactor(0, 0); // as high as its rows
    rows->setStretchFactor(1, 3);
    rows->setStretchFactor(2, 2);
    rows->setChildrenCollapsible(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(rows);
    connectPairs();
    setResults(nullptr, nullptr);
}

QWidget* BenchmarkResultsView::makePictures() {
    m_curves->setSettings({tr("Share of pairs below each error"), tr("Error, mm"), tr("Pairs, %"), 0, kCurveMaxMm, 0,
                           100, false, tr("Run the benchmark to compare the methods.")});
    auto* all = new QSplitter(Qt::Horizontal, this);
    all->addWidget(m_curves);
    all->addWidget(makeJointPart());
    all->setStretchFactor(0, 2);
    all->setStretchFactor(1, 1);
    all->setChildrenCollapsible(false);
    m_pictures->setDocumentMode(true);
    m_pictures->setFocusPolicy(Qt::NoFocus);
    m_pictures->addTab(all, tr("All methods"));
    m_pictures->addTab(m_pairPlots, tr("A against B"));
    return m_pictures;
}

void BenchmarkResultsView::connectPairs() {
    connect(
        m_pairs, &BenchmarkPairsView::shownChanged, this, [this] { m_pairPlots->showPairs(m_pairs->model()); });
    connect(m_pairs, &BenchmarkPairsView::selectionChanged, this,
            [this] { m_pairPlots->setSelected(m_pairs->selected()); });
    connect(m_pairs, &BenchmarkPairsView::pairOpened, this, &BenchmarkResultsView::openPair);
    connect(m_pairs, &BenchmarkPairsView::runRequested, this, [this](const std::vector<std::size_t>& pairs) {
        std::vector<core::FramePair> wanted;
        for (const std::size_t pair : pairs)
            wanted.push_back(m_pairs->model().table()->pairs[pair]);
        emit runRequested(wanted);
    });
    connect(m_pairPlots, &BenchmarkPairPlots::pairClicked, this, &BenchmarkResultsView::openPair);
    connect(m_pairPlots, &BenchmarkPairPlots::conditionClicked, this,
            [this](const QString& condition) { m_pairs->setFilter(condition); });
}

void BenchmarkResultsView::openPair(std::size_t pair) {
    m_pairs->select({pair});
    emit pairOpened(m_pairs->model().table()->pairs[pair], methodsToInspect());
}

QWidget* BenchmarkResultsView::makeJointPart() {
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    auto* row = new QHBoxLayout;
    auto* title = new QLabel(tr("Error per joint"), part);
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    m_jointMethod->setFocusPolicy(Qt::NoFocus);
    row->addWidget(title, 1);
    row->addWidget(m_jointMethod);
    column->addLayout(row);
    column->addWidget(m_jointErrors, 1);
    connect(m_jointMethod, qOverload<int>(&QComboBox::currentIndexChanged), this,
            &BenchmarkResultsView::showJointErrors);
    return part;
}

void BenchmarkResultsView::setResults(std::shared_ptr<const core::BenchmarkResults> results,
                                      std::shared_ptr<const core::BenchmarkDigest> digest) {
    m_results = std::move(results);
    m_digest = std::move(digest);
    m_summary->setDigest(m_digest);
    m_pairs->setTable(m_digest ? std::shared_ptr<const core::PairTable>(m_digest, &m_digest->table) : nullptr);
    m_summaryTable->setMinimumHeight(heightOfRows(*m_summaryTable, std::min(kSummaryRows, m_summary->rowCount())));
    m_summaryTable->setVisible(m_results != nullptr);
    m_pairs->setVisible(m_results != nullptr);
    m_pictures->tabBar()->setVisible(m_results != nullptr);
    if (!m_results)
        m_pictures->setCurrentIndex(0);
    showCurves();
    showJointMethods();
    showJointErrors();
}

void BenchmarkResultsView::showCurves() {
    std::vector<Curve> curves;
    if (m_digest) {
        for (const core::ErrorCurve& found : m_digest->curves) {
            const bool isStart = found.method == "initial";
            Curve curve{isStart ? tr("start") : QString::fromStdString(found.method),
                        methodColour(isStart ? "start" : found.method),
                        isStart,
                        false,
                        {}};
            for (std::size_t i = 0; i < found.thresholdsMm.size(); ++i)
                curve.points.emplace_back(found.thresholdsMm[i], 100 * found.share[i]);
            curves.push_back(std::move(curve));
        }
    }
    m_curves->setCurves(curves);
}

/// Keeps the one that is chosen while rows come in.
void BenchmarkResultsView::showJointMethods() {
    QStringList names, shown;
    for (int i = 0; i < m_jointMethod->count(); ++i)
        shown << m_jointMethod->itemText(i);
    if (m_results)
        for (const std::string& method : m_results->methods)
            names << QString::fromStdString(method);
    if (names != shown) {
        const QSignalBlocker blocker(m_jointMethod);
        m_jointMethod->clear();
        for (const QString& name : names)
            m_jointMethod->addItem(methodChip(name.toStdString()), name);
    }
    m_jointMethod->setVisible(m_jointMethod->count() > 0);
}

void BenchmarkResultsView::showJointErrors() {
    std::vector<JointError> errors;
    const auto method = static_cast<std::size_t>(m_jointMethod->currentIndex());
    if (m_digest && m_jointMethod->currentIndex() >= 0 && method < m_digest->jointErrorsMm.size()) {
        const std::vector<double>& means = m_digest->jointErrorsMm[method];
        for (std::size_t i = 0; i < m_results->joints.size() && i < means.size(); ++i)
            errors.push_back({m_results->joints[i], means[i]});
    }
    m_jointErrors->setErrors(errors);
}

/// All that can be run here; of a long list the most telling ones, and the two that are compared.
std::vector<std::string> BenchmarkResultsView::methodsToInspect() const {
    constexpr std::size_t kMost = 9;
    std::vector<std::string> wanted =
        m_results->methods.size() > kMost ? core::headlineMethods(*m_results, kMost) : m_results->methods;
    const auto [a, b] = m_pairs->model().compared();
    for (const std::size_t compared : {a, b})
        if (const std::string& method = m_pairs->model().table()->methods[compared];
            std::find(wanted.begin(), wanted.end(), method) == wanted.end())
            wanted.push_back(method);
    std::erase_if(wanted, [this](const std::string& method) {
        return std::find(m_results->external.begin(), m_results->external.end(), method) != m_results->external.end();
    });
    return wanted;
}

} // namespace widgets
