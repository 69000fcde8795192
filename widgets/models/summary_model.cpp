// SPDX-License-Identifier: MIT
#include "widgets/models/summary_model.h"

#include <QLocale>

namespace widgets {

SummaryModel::SummaryModel(QObject* parent)
    : QAbstractTableModel(parent) {}

void SummaryModel::setDigest(std::shared_ptr<const core::BenchmarkDigest> digest) {
    const bool sameShape = m_digest && digest && m_digest->table.methods == digest->table.methods &&
                           m_digest->differences == digest->differences;
    if (sameShape) { // a run goes on
        m_digest = std::move(digest);
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
        return;
    }
    beginResetModel();
    m_digest = std::move(digest);
    endResetModel();
}

int SummaryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_digest ? 0 : static_cast<int>(m_digest->summary.size());
}

int SummaryModel::columnCount(const QModelIndex& parent) const {
    const std::size_t differences = m_digest ? m_digest->differences.size() : 0;
    return parent.isValid() ? 0 : static_cast<int>(differences) + 4; // method, differences, all, pairs, seconds
}

QString SummaryModel::cell(int row, int column) const {
    const bool isStart = row == 0;
    const core::BenchmarkDigest::SummaryRow& values = m_digest->summary[static_cast<std::size_t>(row)];
    const int last = columnCount() - 1;
    if (column == 0)
        return isStart ? tr("start") : QString::fromStdString(values.method);
    const std::size_t difference = static_cast<std::size_t>(column - 1);
    const core::ErrorStatistics& found =
        difference < values.byDifference.size() ? values.byDifference[difference] : values.all;
    if (column == last - 1)
        return QLocale().toString(found.pairs);
    if (found.pairs == 0 || (isStart && column == last))
        return {};
    if (column == last) // external trackers have none
        return found.meanSeconds > 0 ? QLocale().toString(found.meanSeconds, 'f', 3) : QString();
    return QStringLiteral("%1 \u00b1 %2")
        .arg(QLocale().toString(found.meanMm, 'f', 2), QLocale().toString(found.stdMm, 'f', 2));
}

QVariant SummaryModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((index.column() == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == ValueRole && index.column() == 0)
        return index.row() == 0
                   ? QStringLiteral("start")
                   : QString::fromStdString(m_digest->summary[static_cast<std::size_t>(index.row())].method);
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
    return QLocale().toString(m_digest->differences[static_cast<std::size_t>(section - 1)]);
}

} // namespace widgets
