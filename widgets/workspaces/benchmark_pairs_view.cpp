// SPDX-License-Identifier: MIT
#include "widgets/workspaces/benchmark_pairs_view.h"

#include <algorithm>
#include <set>

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "widgets/panels/state_colours.h"
#include "widgets/panels/table_style.h"
#include "widgets/text/pair_filter_text.h"
#include "widgets/views/method_chip.h"

namespace widgets {

namespace {

constexpr int kLeastRows = 6;     ///< in sight, however small the window is
constexpr int kMeasuredRows = 30; ///< by which a column's width is chosen

/// The selected cells as lines that spreadsheets take.
QString asLines(const QTableView& table) {
    QStringList lines;
    QStringList cells;
    const QAbstractItemModel& model = *table.model();
    for (int column = 0; column < model.columnCount(); ++column)
        cells << model.headerData(column, Qt::Horizontal).toString();
    lines << cells.join(QLatin1Char('\t'));
    for (const QModelIndex& row : table.selectionModel()->selectedRows()) {
        cells.clear();
        for (int column = 0; column < model.columnCount(); ++column)
            cells << row.sibling(row.row(), column).data().toString();
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

} // namespace

BenchmarkPairsView::BenchmarkPairsView(QWidget* parent)
    : QWidget(parent)
    , m_model(new PairTableModel(this))
    , m_table(new QTableView(this))
    , m_a(new QComboBox(this))
    , m_b(new QComboBox(this))
    , m_filter(new QLineEdit(this))
    , m_count(new QLabel(this))
    , m_wrong(new QLabel(this))
    , m_run(new QPushButton(this)) {
    makeTable();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(makeChoiceRow());
    m_wrong->setTextFormat(Qt::PlainText);
    m_wrong->setWordWrap(true);
    m_wrong->setContentsMargins(kSpacing, 0, kSpacing, kSpacing / 2);
    QPalette wrong = palette();
    wrong.setColor(QPalette::WindowText, kBadColour);
    m_wrong->setPalette(wrong);
    column->addWidget(m_wrong);
    column->addWidget(m_table, 1);
    setTable(nullptr);
}

void BenchmarkPairsView::makeTable() {
    m_model->setMethodIcon([](const std::string& method) { return methodChip(method); });
    m_table->setObjectName(QStringLiteral("benchmarkPairs"));
    m_table->setModel(m_model);
    styleTable(*m_table);
    // And half a row more: it shows that the list goes on.
    m_table->setMinimumHeight(heightOfRows(*m_table, kLeastRows) + m_table->verticalHeader()->defaultSectionSize() / 2);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setFocusPolicy(Qt::NoFocus);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    m_table->setToolTip(tr("Double-click a pair to inspect it with every method; select several to run them"));
    m_table->horizontalHeader()->setResizeContentsPrecision(kMeasuredRows);
    m_table->horizontalHeader()->setSortIndicator(-1, Qt::DescendingOrder);
    m_table->horizontalHeader()->setSortIndicatorShown(true);
    m_table->horizontalHeader()->setSectionsClickable(true);
    connect(
        m_table->horizontalHeader(), &QHeaderView::sectionClicked, this,
        [this](int section) {
            const auto& sorted = m_model->sortedBy();
            const bool again =
                sorted && *sorted == m_model->quantity(section) && m_model->order() == Qt::DescendingOrder;
            sortBy(m_model->quantity(section), again ? Qt::AscendingOrder : Qt::DescendingOrder);
        });
    connect(m_table, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
        emit pairOpened(m_model->shown()[static_cast<std::size_t>(index.row())]);
    });
    connect(m_table, &QTableView::customContextMenuRequested, this, &BenchmarkPairsView::showMenu);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        showCounts();
        emit selectionChanged();
    });
}

QLayout* BenchmarkPairsView::makeChoiceRow() {
    auto* row = new QHBoxLayout;
    row->setContentsMargins(kSpacing, kSpacing / 2, kSpacing, kSpacing / 2);
    row->setSpacing(kSpacing);
    for (const auto& [letter, box] : {std::pair(QStringLiteral("A"), m_a), std::pair(QStringLiteral("B"), m_b)}) {
        box->setFocusPolicy(Qt::NoFocus);
        box->setToolTip(tr("The column A \u2212 B and the plots compare these two methods"));
        box->setAccessibleName(tr("Method %1").arg(letter));
        row->addWidget(new QLabel(letter, this));
        row->addWidget(box);
        connect(box, qOverload<int>(&QComboBox::activated), this, &BenchmarkPairsView::takeChoice);
    }
    m_filter->setPlaceholderText(tr("Filter, such as A-B>1 difference>=10"));
    m_filter->setToolTip(pairFilterHelp());
    m_filter->setAccessibleName(tr("Filter of the pairs"));
    m_filter->setClearButtonEnabled(true);
    m_filter->setFocusPolicy(Qt::ClickFocus);
    m_filter->setMinimumWidth(120);
    row->addWidget(m_filter, 1);
    m_count->setTextFormat(Qt::PlainText);
    row->addWidget(m_count);
    m_run->setFocusPolicy(Qt::NoFocus);
    m_run->setToolTip(
        tr("Runs the methods that are ticked on the left on the selected pairs, and adds what they find"));
    row->addWidget(m_run);
    connect(m_filter, &QLineEdit::textChanged, this, &BenchmarkPairsView::takeFilter);
    connect(m_filter, &QLineEdit::returnPressed, m_filter, &QLineEdit::clearFocus);
    connect(m_run, &QPushButton::clicked, this, &BenchmarkPairsView::runSelected);
    return row;
}

void BenchmarkPairsView::setTable(const std::shared_ptr<const core::PairTable>& table) {
    const std::vector<std::size_t> kept = selected();
    const auto before = m_model->table();
    const bool goesOn = m_model->setTable(table);
    showChoice();
    if (goesOn) {
        if (before->pairs == table->pairs)
            select(kept);
    } else {
        const QSignalBlocker blocker(m_filter);
        m_filter->clear();
    }
    takeFilter();
}

/// The boxes and the header's arrow say what the model has.
void BenchmarkPairsView::showChoice() {
    QStringList names;
    if (m_model->table())
        for (const std::string& method : m_model->table()->methods)
            names << QString::fromStdString(method);
    for (QComboBox* box : {m_a, m_b}) {
        QStringList shown;
        for (int i = 0; i < box->count(); ++i)
            shown << box->itemText(i);
        if (shown != names) {
            box->clear();
            for (const QString& name : names)
                box->addItem(methodChip(name.toStdString()), name);
        }
    }
    m_a->setCurrentIndex(static_cast<int>(m_model->compared().a));
    m_b->setCurrentIndex(static_cast<int>(m_model->compared().b));
    showOrder();
}

void BenchmarkPairsView::showOrder() {
    const auto& sorted = m_model->sortedBy();
    m_table->horizontalHeader()->setSortIndicator(sorted ? m_model->columnOf(*sorted) : -1, m_model->order());
}

void BenchmarkPairsView::takeChoice() {
    const std::vector<std::size_t> kept = selected();
    m_model->setCompared({static_cast<std::size_t>(std::max(0, m_a->currentIndex())),
                          static_cast<std::size_t>(std::max(0, m_b->currentIndex()))});
    showOrder();
    select(kept);
    takeFilter();
}

bool BenchmarkPairsView::setCompared(const QString& a, const QString& b) {
    const int first = m_a->findText(a), second = m_b->findText(b);
    if (first < 0 || second < 0)
        return false;
    m_a->setCurrentIndex(first);
    m_b->setCurrentIndex(second);
    takeChoice();
    return true;
}

bool BenchmarkPairsView::sortBy(const core::PairQuantity& quantity, Qt::SortOrder order) {
    const int column = m_model->columnOf(quantity);
    if (column < 0)
        return false;
    const std::vector<std::size_t> kept = selected();
    m_model->sort(column, order);
    showOrder();
    select(kept);
    m_table->scrollToTop();
    emit shownChanged();
    return true;
}

QString BenchmarkPairsView::setFilter(const QString& text) {
    if (text != m_filter->text())
        m_filter->setText(text); // takes it
    return m_problem;
}

void BenchmarkPairsView::takeFilter() {
    m_problem.clear();
    core::PairFilter wanted;
    if (m_model->table()) {
        const auto read = core::parsePairFilter(m_filter->text().toStdString(), *m_model->table(), m_model->compared());
        if (const auto* problem = std::get_if<core::PairFilterProblem>(&read))
            m_problem = pairFilterProblemText(*problem);
        else
            wanted = std::get<core::PairFilter>(read);
    }
    const std::vector<std::size_t> kept = selected();
    m_model->setFilter(std::move(wanted));
    select(kept);
    showCounts();
    emit shownChanged();
}

void BenchmarkPairsView::showCounts() {
    const QLocale locale;
    const int all = m_model->table() ? static_cast<int>(m_model->table()->pairs.size()) : 0;
    m_count->setText(tr("%1 of %2 pairs").arg(locale.toString(m_model->rowCount()), locale.toString(all)));
    m_wrong->setText(m_problem);
    m_wrong->setVisible(!m_problem.isEmpty());
    const int chosen = m_table->selectionModel()->selectedRows().size();
    m_run->setEnabled(chosen > 0);
    m_run->setText(chosen > 0 ? tr("Run selected (%1)").arg(locale.toString(chosen)) : tr("Run selected"));
}

std::vector<std::size_t> BenchmarkPairsView::selected() const {
    std::vector<std::size_t> pairs;
    for (const QModelIndex& row : m_table->selectionModel()->selectedRows())
        pairs.push_back(m_model->shown()[static_cast<std::size_t>(row.row())]);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

/// One range per run of rows that stand together.
void BenchmarkPairsView::select(const std::vector<std::size_t>& pairs) {
    const std::set<std::size_t> wanted(pairs.begin(), pairs.end());
    const std::vector<std::size_t>& shown = m_model->shown();
    QItemSelection selection;
    const int last = m_model->columnCount() - 1;
    for (int row = 0; !wanted.empty() && row < static_cast<int>(shown.size()); ++row) {
        if (!wanted.contains(shown[static_cast<std::size_t>(row)]))
            continue;
        int end = row;
        while (end + 1 < static_cast<int>(shown.size()) && wanted.contains(shown[static_cast<std::size_t>(end + 1)]))
            ++end;
        selection.select(m_model->index(row, 0), m_model->index(end, last));
        row = end;
    }
    m_table->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
}

void BenchmarkPairsView::askForFilter() {
    m_filter->setFocus(Qt::ShortcutFocusReason);
    m_filter->selectAll();
}

void BenchmarkPairsView::runSelected() {
    if (const std::vector<std::size_t> pairs = selected(); !pairs.empty())
        emit runRequested(pairs);
}

void BenchmarkPairsView::showMenu(const QPoint& place) {
    const QModelIndex index = m_table->indexAt(place);
    QMenu menu;
    if (index.isValid())
        menu.addAction(tr("Inspect this pair"), this,
                       [this, index] { emit pairOpened(m_model->shown()[static_cast<std::size_t>(index.row())]); });
    menu.addAction(tr("Select all that are shown"), m_table, &QTableView::selectAll);
    if (m_run->isEnabled()) {
        menu.addAction(m_run->text(), this, &BenchmarkPairsView::runSelected);
        menu.addAction(QIcon::fromTheme(QStringLiteral("edit-copy")), tr("Copy the selected rows"), this,
                       [this] { QApplication::clipboard()->setText(asLines(*m_table)); });
    }
    menu.exec(m_table->viewport()->mapToGlobal(place));
}

} // namespace widgets
