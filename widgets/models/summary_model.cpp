// SPDX-License-Identifier: MIT
#include "widgets/models/summary_model.h"

#include <QLocale>

#include "core/benchmark/metrics.h"

namespace widgets {

SummaryModel::SummaryModel(QObject* parent)
    : QAbstractTableModel(parent) {}

void SummaryModel::setResults(std::shared_ptr<const core::BenchmarkResults> results) {
    std::vector<int> differences = results ? core::differencesOf(*results) : std::vector<int>{};
    const bool sameShape =
        m_results && results && m_results->methods == results->methods && differences == m_differences;
    if (sameShape) { // a run goes on
        m_results = std::move(results);
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
        return;
    }
    beginResetModel();
    m_results = std::move(results);
    m_differences = std::move(differences);
    endResetModel();
}

int SummaryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_results ? 0 : static_cast<int>(m_results->methods.size()) + 1;
}

int SummaryModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0
                            : static_cast<int>(m_differences.size()) + 4; // method, differences, all, pairs, seconds
}

QString SummaryModel::cell(int row, int column) const {
    const bool isStart = row == 0;
    const std::string method = isStart ? std::string() : m_results->methods[static_cast<std::size_t>(row - 1)];
    const int last = columnCount() - 1;
    if (column == 0)
        return isStart ? tr("start") : QString::fromStdString(method);
    std::optional<int> difference;
    if (column <= static_cast<int>(m_differences.size()))
        difference = m_differences[static_cast<std::size_t>(column - 1)];
    const core::ErrorStatistics found = isStart ? core::initialStatistics(*m_results, difference)
                                                : core::errorStatistics(*m_results, method, difference);
    if (column == last - 1)
        return QLocale().toString(found.pairs);
    if (found.pairs == 0 || (isStart && column == last))
        return {};
    if (column == last)
        return QLocale().toString(found.meanSeconds, 'f', 3);
    return QStringLiteral("%1 \u00b1 %2")
        .arg(QLocale().toString(found.meanMm, 'f', 2), QLocale().toString(found.stdMm, 'f', 2));
}

QVariant SummaryModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((index.column() == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == ValueRole && index.column() == 0)
        return index.row() == 0 ? QStringLiteral("start")
                                : QString::fromStdString(m_results->methods[static_cast<std::size_t>(index.row() - 1)]);
    return role == Qt::DisplayRole ? QVariant(cell(index.row(), index.column())) : QVariant();
}

QVariant SummaryModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount())
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && section > 0)
        return section == columnCount() - 1   ? tr("Seconds per pair")
               : section == columnCount() - 2 ? tr("Pairs that are finished")
                                              : tr("Mean and standard deviation of the error, mm, by frames apart");
    if (role != Qt::DisplayRole)
        return {};
    if (section == 0)
        return tr("Method");
    if (section == columnCount() - 1)
        return tr("s");
    if (section == columnCount() - 2)
        return tr("Pairs");
    if (section == columnCount() - 3)
        return tr("All, mm");
    return QLocale().toString(m_differences[static_cast<std::size_t>(section - 1)]);
}

} // namespace widgets
