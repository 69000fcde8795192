// SPDX-License-Identifier: MIT
#include "widgets/models/pair_table_model.h"

#include <algorithm>

#include <QLocale>

namespace widgets {

namespace {

bool isText(int column) {
    return column == PairTableModel::Method || column == PairTableModel::Sequence;
}

bool isSameRow(const core::PairResult& a, const core::PairResult& b) {
    return a.pair == b.pair && a.method == b.method && a.errorMm == b.errorMm && a.seconds == b.seconds;
}

} // namespace

PairTableModel::PairTableModel(QObject* parent)
    : QAbstractTableModel(parent) {}

void PairTableModel::setResults(std::shared_ptr<const core::BenchmarkResults> results) {
    const std::size_t before = m_results ? m_results->rows.size() : 0;
    const bool onlyMore = before > 0 && results && results->rows.size() >= before &&
                          std::equal(m_results->rows.begin(), m_results->rows.end(), results->rows.begin(), isSameRow);
    if (onlyMore) { // a run goes on: what is selected and scrolled to stays
        const auto after = static_cast<int>(results->rows.size());
        if (after > static_cast<int>(before))
            beginInsertRows({}, static_cast<int>(before), after - 1);
        m_results = std::move(results);
        if (after > static_cast<int>(before))
            endInsertRows();
        return;
    }
    beginResetModel();
    m_results = std::move(results);
    endResetModel();
}

int PairTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_results ? 0 : static_cast<int>(m_results->rows.size());
}

int PairTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant PairTableModel::value(const core::PairResult& row, int column) const {
    switch (column) {
    case Method:
        return QString::fromStdString(row.method);
    case Sequence:
        return QString::fromStdString(row.pair.sequence);
    case Start:
        return row.pair.start;
    case Test:
        return row.pair.test;
    case InitialErrorMm:
        return row.initialErrorMm;
    case ErrorMm:
        return row.errorMm;
    case Iterations:
        return row.iterations;
    case Seconds:
        return row.seconds;
    default:
        return {};
    }
}

QVariant PairTableModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const QVariant raw = value(pair(index.row()), index.column());
    if (role == ValueRole)
        return raw;
    if (role == Qt::TextAlignmentRole)
        return int((isText(index.column()) ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    if (raw.type() == QVariant::Double)
        return QLocale().toString(raw.toDouble(), 'f', index.column() == Seconds ? 3 : 2);
    return raw.type() == QVariant::Int ? QVariant(QLocale().toString(raw.toInt())) : raw;
}

QVariant PairTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((isText(section) ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QString names[ColumnCount] = {tr("Method"),   tr("Sequence"), tr("Start"),      tr("Test"),
                                        tr("Start mm"), tr("Error mm"), tr("Iterations"), tr("s")};
    return names[section];
}

} // namespace widgets
