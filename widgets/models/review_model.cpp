// SPDX-License-Identifier: MIT
#include "widgets/models/review_model.h"

#include <algorithm>

#include "widgets/text/local_text.h"
#include "widgets/text/review_text.h"

namespace widgets {

ReviewModel::ReviewModel(QObject* parent)
    : QAbstractTableModel(parent) {}

void ReviewModel::setRows(std::vector<ReviewRow> rows) {
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

int ReviewModel::rowOf(int frame) const {
    const auto row =
        std::find_if(m_rows.begin(), m_rows.end(), [frame](const ReviewRow& one) { return one.item.frame == frame; });
    return row == m_rows.end() ? -1 : static_cast<int>(row - m_rows.begin());
}

int ReviewModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int ReviewModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ReviewModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const ReviewRow& row = m_rows[static_cast<std::size_t>(index.row())];
    if (role == Qt::TextAlignmentRole)
        return int((index.column() == Reason ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole)
        return doubtReasonText(row.why);
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case Frame:
        return QLocale().toString(row.item.frame);
    case Doubt:
        return localNumber(100 * row.item.doubt, 0);
    case Neighbours:
        return QLocale().toString(row.item.neighbours);
    default:
        return doubtReasonText(row.why);
    }
}

QVariant ReviewModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == Reason ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    const QString names[ColumnCount] = {tr("Reason"), tr("Frame"), tr("Doubt, %"), tr("Near")};
    const QString tips[ColumnCount] = {tr("Why the frame deserves a look"),
                                       {},
                                       tr("0: sure, 100: lost; of the more doubtful hand"),
                                       tr("Doubtful frames around that a corrected one helps")};
    if (role == Qt::ToolTipRole)
        return tips[section];
    return role == Qt::DisplayRole ? QVariant(names[section]) : QVariant();
}

} // namespace widgets
