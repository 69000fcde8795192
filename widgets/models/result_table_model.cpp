// SPDX-License-Identifier: MIT
#include "widgets/models/result_table_model.h"
#include "widgets/text/error_text.h"

#include <cmath>

#include <QColor>
#include <QLocale>

namespace widgets {

namespace {

QString terminationText(core::FitTermination termination) {
    switch (termination) {
    case core::FitTermination::Converged:
        return ResultTableModel::tr("Converged");
    case core::FitTermination::MaxIterations:
        return ResultTableModel::tr("Stopped at the iteration limit");
    case core::FitTermination::NoMatches:
        return ResultTableModel::tr("No matches were left");
    case core::FitTermination::Stopped:
        return ResultTableModel::tr("Stopped");
    }
    return {};
}

} // namespace

ResultTableModel::ResultTableModel(QObject* parent)
    : QAbstractTableModel(parent) {}

void ResultTableModel::setOutcome(std::shared_ptr<const FitOutcome> outcome) {
    beginResetModel();
    m_outcome = std::move(outcome);
    endResetModel();
}

int ResultTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_outcome ? 0 : static_cast<int>(m_outcome->methods.size());
}

int ResultTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ResultTableModel::value(const MethodOutcome& method, int column) const {
    switch (column) {
    case InitialErrorMm:
        return m_outcome->initialErrorMm;
    case ErrorMm:
        return method.errorMm;
    case Iterations:
        return static_cast<int>(method.result.history.size());
    case Seconds:
        return method.result.seconds;
    default:
        return {};
    }
}

QVariant ResultTableModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const MethodOutcome& method = m_outcome->methods[static_cast<std::size_t>(index.row())];
    if (role == Qt::TextAlignmentRole)
        return int((index.column() == Method ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole)
        return method.failure.isEmpty() ? terminationText(method.result.termination) : withDetailBehind(method.failure);
    if (role == ValueRole)
        return index.column() == Method ? QVariant(QString::fromStdString(method.method))
                                        : value(method, index.column());
    if (role != Qt::DisplayRole)
        return {};
    if (index.column() == Method)
        return QString::fromStdString(method.method);
    if (!method.failure.isEmpty())
        return index.column() == ErrorMm ? tr("failed") : QString();
    if (index.column() == Iterations)
        return QLocale().toString(value(method, Iterations).toInt());
    const double number = value(method, index.column()).toDouble();
    return std::isnan(number) ? QString() : QLocale().toString(number, 'f', index.column() == Seconds ? 3 : 2);
}

QVariant ResultTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == Method ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QString names[ColumnCount] = {tr("Method"), tr("Start mm"), tr("Error mm"), tr("Iterations"), tr("s")};
    return names[section];
}

} // namespace widgets
